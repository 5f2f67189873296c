"""What was handed in: folders, zips, rosters, notebooks."""
