"""What statements show: tables of joints, pieces of URDF files."""
