"""Questions of lectures: their TOML files, their widgets, and their HTML for pages without a kernel."""
