"""nbgrader's settings for this course: sheets are made from solutions/, and submissions run in misstep's sandbox."""

c = get_config()  # noqa: F821 - nbgrader defines get_config when it reads this file

c.CourseDirectory.source_directory = "solutions"
c.CourseDirectory.release_directory = "exercises"
c.ClearSolutions.code_stub = {"python": "# your lines here"}

c.OverwriteCells.add_missing_cells = True
c.Autograde.autograde_preprocessors = [
    "misstep.grading.nbgrader.plugin.Execute",
    "nbgrader.preprocessors.LimitOutput",
    "nbgrader.preprocessors.SaveAutoGrades",
    "nbgrader.preprocessors.AssignLatePenalties",
    "nbgrader.preprocessors.CheckCellMetadata",
]
