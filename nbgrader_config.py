"""nbgrader's settings for this course: sheets are made from solutions/, and `misstep grade --gradebook .` gives the points."""

c = get_config()  # noqa: F821 - nbgrader defines get_config when it reads this file

c.CourseDirectory.source_directory = "solutions"
c.CourseDirectory.release_directory = "exercises"
c.ClearSolutions.code_stub = {"python": "# your lines here"}
c.Autograde.autograde_preprocessors = ["misstep.grading.gradebook.Refuse"]
# Students do not get the worked solutions.
c.GenerateAssignment.preprocessors.prepend(["nbconvert.preprocessors.RegexRemovePreprocessor"])
c.RegexRemovePreprocessor.enabled = True
c.RegexRemovePreprocessor.patterns = ["(One way to it|The answer), with the numbers of “your id”"]
