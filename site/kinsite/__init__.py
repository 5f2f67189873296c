"""The course site: executes the notebooks, generates the pages about the packages, and shows outputs without a kernel."""
