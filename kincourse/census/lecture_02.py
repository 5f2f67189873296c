"""Answers by hand to sheet 02."""
