"""Arrays: validation at the public edge, batches, and generated code for single configurations."""
