"""Grading: submissions run in a sandbox and emit answers; a judge that never runs student code computes the points.

How one submission gets its grade, in the order of reading:

    command      `misstep grade`: the whole run, from a folder or a zip file to the results
    collect/     what students submitted
        files, layouts, roster   the files of a folder or a zip file, and which student each of them belongs to
        gather                   one Submission for each student
        notebook, run_plan       its code cells, and what is run of them: with the sheet's own check cells
    jobs         the submissions that have no result yet
    fingerprint  a digest of everything that a result depends on; of the code, only what is imported (code_digest)
    fork_server  the one way in which processes are started, ended and asked: a server imports everything once, and forks
    steps        functions that run in such processes with limits on processor time and memory, and what they return
    redacted_sheet   the sheet without answers, which a child of the sandbox sees
    sandbox/     the confined processes in which submissions run
        runner, server           the server forks a child for each submission
        submission_process       the child: it confines itself, and runs the cells
        rootfs, confine, limits, allowed_syscalls   what a child can reach, layer by layer
        course_stub              what a child sees instead of the course
        run_cells, kept_output   runs the cells as a notebook would, and keeps as much of their output as can be shown
    judging/     from one submission to its Result
        grader                   all of this for one submission: bytes in, a Result out
        parse_output             parses what the child wrote, and trusts none of it
        judge_process            the steps: redacted sheets, verdicts, and all that reads what students wrote
        redraw                   with a key: other numbers, by which computed answers are told from typed ones
        cluster                  many submissions at a time, on a Dask cluster
    write_results    from the stored results to what people open
    publish/     the stored results, what is changed by hand, feedback pages, the report, tables and files for platforms
    nbgrader/    the plugin for `nbgrader autograde`, and the gradebook of an nbgrader course
"""
