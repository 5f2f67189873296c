"""Answers by hand to sheet 01."""
