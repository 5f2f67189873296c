"""Arms and linkages drawn for one student."""
