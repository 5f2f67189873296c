"""Drawing: SVG elements, labels and text alternatives, from which the figures are made."""
