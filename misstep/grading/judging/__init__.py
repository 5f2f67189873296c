"""Judging: from one submission to its result. The judge runs in a process that never runs student code."""
