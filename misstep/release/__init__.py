"""From the instructors' notebooks to the students' notebooks."""
