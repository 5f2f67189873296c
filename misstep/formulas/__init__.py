"""Formulas: parsed from text without running it, and computed as numbers or as SymPy expressions."""
