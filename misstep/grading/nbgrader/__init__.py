"""The bridge to nbgrader: its gradebook, its cells, its autograder."""
