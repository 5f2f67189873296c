"""What is made of results: pages, tables, and files for platforms."""
