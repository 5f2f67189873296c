"""How two descriptions of a mechanism are aligned: invariants of axes, and maps."""
