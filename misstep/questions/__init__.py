"""Questions of the lectures: how they are written, as widgets, and on a page without a kernel."""
