"""Lecture 01, frames, poses and their products: problems, blank steps and questions.

notebook   notebooks/01_frames.ipynb
solutions  solutions/01_frames/01_frames.ipynb
sheet      exercises/01_frames/01_frames.ipynb, released from the solutions
"""
