"""Arrays: input validation, named tolerances, batches, and generated code for single configurations."""
