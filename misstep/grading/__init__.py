"""Grading: reads the answers that check cells have stored in notebooks, and judges them. No code of a student is ever run."""
