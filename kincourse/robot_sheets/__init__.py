"""Sheets for any robot: the tasks, the choice of those that fit a robot, and the JSON file that stores the robot."""
