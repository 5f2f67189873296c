"""Where submissions run: confined processes, limits, and what they can reach."""
