"""What the answers by hand of several lectures need: motions, chains, DH tables, and the words that name a mistake."""
