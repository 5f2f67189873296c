"""The operations of kinematics as parts of solutions, each with the ways in which people get it wrong."""
