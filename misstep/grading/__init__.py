"""Grading: submissions run in a sandbox and give answers, a judge that never runs them gives the points.

How one submission comes to its grade, in the order of reading:

    submission   what was handed in: which cells run, with the sheet's own check cells in place of the student's
    judge        a process that knows the sheet: it writes the paper, and later judges the answers
    paper        a student's sheet without answers: what the submission sees in place of the sheet
    server       a process that knows nothing: it imports once and forks a child for each submission
    runner       talks with the server, and holds the clock
    child, run   the life of a child: it goes into the cage, and runs cells as a notebook would
    root, cage   what a child can reach, layer by layer; kernel has the calls, layers the words for what is missing
    hearing      what the child wrote, read as strictly as its lines deserve
    grade        all of this for one submission: bytes in, a result out

Around it stand the command, the folders and zips that submissions come in, and what is made of results.
"""
