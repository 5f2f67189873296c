"""Read DH tables as text: signs, then rows of cells from names with values or from lines, and what the text does not say."""
