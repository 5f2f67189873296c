"""Evidence that the library is right and that feedback is true: checks from outside, which no wheel contains."""
