"""Sheets for any robot: the tasks, and the file in which the robot travels."""
