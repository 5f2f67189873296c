"""Answers by hand to sheet 03."""
