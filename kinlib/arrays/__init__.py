"""Arrays: input validation, named tolerances, and numbers as text."""
