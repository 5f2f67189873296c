"""Lecture 04, the product of exponentials in the body frame: problems, blank steps and questions.

notebook   notebooks/04_poe_body.ipynb
solutions  solutions/04_poe_body/04_poe_body.ipynb
sheet      exercises/04_poe_body/04_poe_body.ipynb, released from the solutions
"""
