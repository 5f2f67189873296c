"""Lecture 03, the product of exponentials in the space frame: problems, blank steps and questions.

notebook   notebooks/03_poe_space.ipynb
solutions  solutions/03_poe_space/03_poe_space.ipynb
sheet      exercises/03_poe_space/03_poe_space.ipynb, released from the solutions
"""
