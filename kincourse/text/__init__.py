"""Parts of statements as text: tables of joints, and URDF files."""
