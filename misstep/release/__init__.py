"""Instructors' notebooks with solutions, and the students' notebooks that are released from them."""
