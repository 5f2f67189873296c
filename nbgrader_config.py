"""nbgrader's settings for this course: sheets are made from solutions/, and submissions run in kinlib's sandbox."""

c = get_config()  # noqa: F821 - nbgrader reads this file and brings it

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
