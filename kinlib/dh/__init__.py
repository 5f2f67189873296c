"""Denavit-Hartenberg tables: reading, assigning, comparing and diagnosing them (lectures 05 to 07)."""
