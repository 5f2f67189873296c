"""Lecture 02, the matrix exponential and the logarithm: problems, blank steps and questions.

notebook   notebooks/02_matrix_exponential.ipynb
solutions  solutions/02_matrix_exponential/02_matrix_exponential.ipynb
sheet      exercises/02_matrix_exponential/02_matrix_exponential.ipynb, released from the solutions
"""
