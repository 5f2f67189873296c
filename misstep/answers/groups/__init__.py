"""Answers that are made of others: intervals, orders, sets and tables."""
