"""Widgets, which also work on a page without a kernel; kinlib/view/js draws them."""
