"""Answers that are made of others: intervals, sets and tables."""
