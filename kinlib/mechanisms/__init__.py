"""Closed chains: joints, loop closure, mobility, linkages (lecture 08)."""
