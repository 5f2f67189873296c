"""Lecture 09, URDF files: problems, blank steps and questions.

notebook   notebooks/09_urdf.ipynb
solutions  solutions/09_urdf/09_urdf.ipynb
sheet      exercises/09_urdf/09_urdf.ipynb, released from the solutions
"""
