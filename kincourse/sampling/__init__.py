"""Random points, frames, arms and linkages for the variants of problems."""
