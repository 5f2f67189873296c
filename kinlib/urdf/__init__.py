"""URDF files: reading them, checking that they are trees, and converting them to chains and back (lecture 09)."""
