"""What holds for each student's numbers: the right answer has full marks, and each mistake of the author has its own message."""

from misstep.judge import judge


def assert_mistakes_are_named(problem):
    assert judge(problem, problem.answer.value).fraction == 1.0
    for wrong in problem.mistakes:
        judgement = judge(problem, wrong.value)
        assert judgement.mistakes == [wrong.name]
        assert judgement.fraction < 1
        assert wrong.message in [finding.message for finding in judgement.findings]
