"""Drawings of arms, frames, tables and linkages: each function returns a Picture with its text alternative."""
