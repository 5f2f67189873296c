"""Lecture 07, DH frames for any arm: problems, blank steps and questions.

notebook   notebooks/07_frame_assignment.ipynb
solutions  solutions/07_frame_assignment/07_frame_assignment.ipynb
sheet      exercises/07_frame_assignment/07_frame_assignment.ipynb, released from the solutions
"""
