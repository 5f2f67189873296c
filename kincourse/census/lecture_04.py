"""Answers by hand to sheet 04."""
