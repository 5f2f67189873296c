"""Lecture 10, one robot, described in four ways: problems, blank steps and questions.

notebook   notebooks/10_one_robot_four_ways.ipynb
solutions  solutions/10_one_robot_four_ways/10_one_robot_four_ways.ipynb
sheet      exercises/10_one_robot_four_ways/10_one_robot_four_ways.ipynb, released from the solutions
"""
