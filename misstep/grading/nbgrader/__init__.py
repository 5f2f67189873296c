"""nbgrader: the plugin for `nbgrader autograde`, and the gradebook of an nbgrader course."""
