"""Grading: submissions run in a sandbox and give answers, a judge that never runs them gives the points."""
