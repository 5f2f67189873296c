"""The report of a class: how the points are spread, and which mistakes were made how often. It names nobody.

So it may be shown in a lecture. Who did what stands in the tables beside it.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from misstep.grading.judging.result import Result
from misstep.grading.publish.pages import STATES, page, points
from misstep.grading.publish.shared_answers import Match

WIDTH, HEIGHT, HEAD, FOOT = 420, 116, 20, 22
"""The size of a histogram, and what of its height is above and below the bars."""

BAR = Markup('<rect class="bar" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>')

WORDS = Markup('<text x="{:.1f}" y="{:.1f}" text-anchor="middle" font-size="{}">{}</text>')

DRAWING = Markup(
    '<svg role="img" aria-label="{0}" viewBox="0 0 {1} {2}" width="{1}">'
    '<line class="axis" x1="0" x2="{1}" y1="{3}" y2="{3}"/>{4}</svg>'
)

BARS = 10
"""Most bars of a histogram."""


@dataclass(frozen=True)
class Bar:
    """A bar: the values that it stands for, in words, and how many there are."""

    label: str
    count: int


@dataclass(frozen=True)
class ProblemReport:
    """One problem in a class: its points, its states, and its mistakes, the most frequent first."""

    number: str
    title: str
    max: float
    mean: float
    bars: Sequence[Bar]
    states: Sequence[tuple[str, int]]
    mistakes: Sequence[tuple[str, int]]


def report(results: Sequence[Result], found: Sequence[Match]) -> str:
    """The page. Expects at least one result."""
    problems = [problem_report(results, place) for place in range(len(results[0].problems))]
    totals = [result.points for result in results]
    return page(
        "report.html",
        sheet=results[0].sheet,
        count=len(results),
        max=results[0].max,
        mean=sum(totals) / len(totals),
        bars=spread(totals, results[0].max),
        statuses=Counter(result.status for result in results),
        noted=sum(bool(result.notes or result.reason) for result in results),
        matching=len({match.student for match in found if match.together > 1}),
        problems=problems,
        longest=max((number for problem in problems for _, number in problem.mistakes), default=1),
        histogram=histogram,
        is_safe=all(result.is_safe for result in results),
    )


def problem_report(results: Sequence[Result], place: int) -> ProblemReport:
    """What became of one problem."""
    each = [result.problems[place] for result in results]
    earned = [problem.points for problem in each]
    states = Counter(problem.state for problem in each)
    mistakes = Counter(name for problem in each for name in set(problem.mistakes))
    return ProblemReport(
        each[0].number,
        each[0].title,
        each[0].max,
        sum(earned) / len(earned),
        spread(earned, each[0].max),
        [(state, states[state]) for state in STATES if states[state]],
        sorted(mistakes.items(), key=lambda item: (-item[1], item[0])),
    )


def spread(values: Sequence[float], most: float) -> list[Bar]:
    """How often each number of points was earned: by value where there are few, or rounded down and a few together.

    >>> spread([0, 1.5, 3, 3], 3)[2:]
    [Bar(label='1.5', count=1), Bar(label='2', count=0), Bar(label='3', count=2)]
    >>> spread([0, 23.9, 24], 24)[-2:]
    [Bar(label='21–23', count=1), Bar(label='24', count=1)]
    """
    counts = Counter(round(value, 2) for value in values)
    ticks = sorted({*counts, *(float(whole) for whole in range(int(most) + 1))})
    if len(ticks) <= BARS:
        return [Bar(points(tick), counts[tick]) for tick in ticks]
    together = -(-int(most) // (BARS - 2))
    places = Counter(int(value) // together for value in values)
    starts = range(0, int(most) + 1, together)
    ends = (min(start + together - 1, int(most)) for start in starts)
    return [
        Bar(f"{start}–{end}" if end > start else str(start), places[start // together])
        for start, end in zip(starts, ends, strict=True)
    ]


def histogram(bars: Sequence[Bar], title: str) -> Markup:
    """Bars as SVG, each with its count on top, and all of it in words for who does not see it."""
    tallest = max(bar.count for bar in bars) or 1
    step, ground = WIDTH / len(bars), HEIGHT - FOOT
    told = "; ".join(f"{bar.label} points: {bar.count}" for bar in bars)
    marks = []
    for place, bar in enumerate(bars):
        height = (ground - HEAD) * bar.count / tallest
        left, middle = (place + 0.12) * step, (place + 0.5) * step
        marks += [
            BAR.format(left, ground - height, 0.76 * step, height),
            WORDS.format(middle, ground - height - 4, 13, bar.count or ""),
            WORDS.format(middle, ground + 16, 11, bar.label),
        ]
    return DRAWING.format(f"{title}: {told}", WIDTH, HEIGHT, ground, Markup().join(marks))
