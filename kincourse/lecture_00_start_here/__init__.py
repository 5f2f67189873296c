"""Lecture 00, a first notebook: blank steps and questions. It has no sheet.

notebook   notebooks/00_start_here.ipynb
"""
