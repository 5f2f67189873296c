"""What a student sees: cards, numbers as text, and whether a page without a kernel is being made."""
