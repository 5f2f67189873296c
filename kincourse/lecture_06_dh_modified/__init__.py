"""Lecture 06, DH tables in the modified convention: problems, blank steps and questions.

notebook   notebooks/06_dh_modified.ipynb
solutions  solutions/06_dh_modified/06_dh_modified.ipynb
sheet      exercises/06_dh_modified/06_dh_modified.ipynb, released from the solutions
"""
