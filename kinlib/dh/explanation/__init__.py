"""What explains a wrong table: slips, and what its digits say."""
