"""Formulas as people type them: parsed without being run, and evaluated."""
