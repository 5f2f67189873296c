"""Common mistakes of kinematics: each takes the right value and returns the value that the mistake leads to."""
