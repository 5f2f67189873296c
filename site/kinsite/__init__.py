"""The course site: executes the notebooks, writes the pages that are made from kinlib, and shows outputs without a kernel."""
