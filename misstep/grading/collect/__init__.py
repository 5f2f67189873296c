"""What students submitted: folders, zip files, rosters and notebooks, read without trust."""
