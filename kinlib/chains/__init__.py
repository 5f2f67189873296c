"""Open chains: the product of exponentials, and the robots of the course (lectures 03 and 04)."""
