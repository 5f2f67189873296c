"""The sandbox: the confined processes in which submissions run, their limits, and what they can read."""
