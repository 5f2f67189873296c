"""Pages that are made from the packages: robots, mistakes, reference, progress."""
