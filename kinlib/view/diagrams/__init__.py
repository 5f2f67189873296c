"""Pictures that explain one idea each: a cross product as a matrix, the relations of two axes. `kinlib.view.figures` draws robots."""
