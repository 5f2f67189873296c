"""Denavit-Hartenberg tables: parsing, formatting, assigning, comparing and diagnosing them (lectures 05 to 07)."""
