"""Lecture 08, closed chains: problems, blank steps and questions.

notebook   notebooks/08_closed_chains.ipynb
solutions  solutions/08_closed_chains/08_closed_chains.ipynb
sheet      exercises/08_closed_chains/08_closed_chains.ipynb, released from the solutions
"""
