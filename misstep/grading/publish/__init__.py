"""What is published of results: pages, tables, and files for learning platforms."""
