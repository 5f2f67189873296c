"""Widgets: the 3-D viewer and what moves with sliders."""
