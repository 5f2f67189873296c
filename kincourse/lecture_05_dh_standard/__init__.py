"""Lecture 05, DH tables in the standard convention: problems, blank steps and questions.

notebook   notebooks/05_dh_standard.ipynb
solutions  solutions/05_dh_standard/05_dh_standard.ipynb
sheet      exercises/05_dh_standard/05_dh_standard.ipynb, released from the solutions
"""
