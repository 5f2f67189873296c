"""The mistakes of a problem as the mutants of its solution: the solution is an expression, changed as people go wrong."""
