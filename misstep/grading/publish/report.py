"""The report of a class: how the points are distributed, and how often each mistake was made. It names no student.

So it can be shown in a lecture. Which student made which mistake is in the tables beside it.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from misstep.grading.judging.result import ABSENT, Result
from misstep.grading.publish.pages import STATE_LABELS, format_points, render_page
from misstep.grading.publish.shared_answers import Match

WIDTH, HEIGHT, TOP_MARGIN, BOTTOM_MARGIN = 420, 116, 20, 22
"""The size of a histogram in pixels, and its margins above and below the bars."""

BAR_SVG = Markup('<rect class="bar" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>')

LABEL_SVG = Markup('<text x="{:.1f}" y="{:.1f}" text-anchor="middle" font-size="{}">{}</text>')

HISTOGRAM_SVG = Markup(
    '<svg role="img" aria-label="{0}" viewBox="0 0 {1} {2}" width="{1}">'
    '<line class="axis" x1="0" x2="{1}" y1="{3}" y2="{3}"/>{4}</svg>'
)

MAX_BARS = 10
"""The most bars of a histogram."""


@dataclass(frozen=True)
class Bar:
    """A bar: the values that it counts, as text, and how many there are."""

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


def report_page(results: Sequence[Result], matches: Sequence[Match], limits: str = "") -> str:
    """The HTML of the report. There must be at least one result. Those who submitted nothing are counted, but not as points.

    limits  what each submission might use, in words
    """
    absent = sum(result.status == ABSENT for result in results)
    results = [result for result in results if result.status != ABSENT] or results
    problems = [problem_report(results, k) for k in range(len(results[0].problems))]
    totals = [result.points for result in results]
    return render_page(
        "report.html",
        sheet=results[0].sheet,
        count=len(results),
        absent=absent,
        covered=[one.number for one in results[0].problems if one.own_points is not None],
        typed=sum(bool(result.typed) for result in results),
        max=results[0].max,
        mean=sum(totals) / len(totals),
        bars=histogram_bars(totals, results[0].max),
        statuses=Counter(result.status for result in results),
        noted=sum(bool(result.notes or result.reason) for result in results),
        matching=len({match.student for match in matches if match.shared_count > 1}),
        problems=problems,
        patterns=patterns(results),
        max_count=max((count for problem in problems for _, count in problem.mistakes), default=1),
        histogram=histogram,
        changed=sum(bool(result.changes) for result in results),
        limits=limits,
        is_safe=all(result.is_safe for result in results),
    )


def problem_report(results: Sequence[Result], k: int) -> ProblemReport:
    """The results of problem k, counted from 0."""
    problems = [result.problems[k] for result in results]
    points = [problem.points for problem in problems]
    states = Counter(problem.state for problem in problems)
    mistakes = Counter(name for problem in problems for name in set(problem.mistakes))
    return ProblemReport(
        problems[0].number,
        problems[0].title,
        problems[0].max,
        sum(points) / len(points),
        histogram_bars(points, problems[0].max),
        [(state, states[state]) for state in STATE_LABELS if states[state]],
        sorted(mistakes.items(), key=lambda item: (-item[1], item[0])),
    )


def patterns(results: Sequence[Result]) -> list[tuple[str, int, int]]:
    """For each mistake, the number of students in whose answers it returns, and of those in which it is probably a slip."""
    found = [one for result in results for one in result.recurrences]
    returning = Counter(one.name for one in found if one.returns)
    slips = Counter(one.name for one in found if one.is_slip)
    rows = [(name, returning[name], slips[name]) for name in {*returning, *slips}]
    return sorted(rows, key=lambda row: (-row[1], -row[2], row[0]))


def histogram_bars(values: Sequence[float], max_points: float) -> list[Bar]:
    """How often each number of points was earned: one bar for each value if there are few, otherwise one for each range.

    In a range, points are rounded down.

    >>> histogram_bars([0, 1.5, 3, 3], 3)[2:]
    [Bar(label='1.5', count=1), Bar(label='2', count=0), Bar(label='3', count=2)]
    >>> histogram_bars([0, 23.9, 24], 24)[-2:]
    [Bar(label='21–23', count=1), Bar(label='24', count=1)]
    """
    counts = Counter(round(value, 2) for value in values)
    ticks = sorted({*counts, *(float(whole) for whole in range(int(max_points) + 1))})
    if len(ticks) <= MAX_BARS:
        return [Bar(format_points(tick), counts[tick]) for tick in ticks]
    bar_width = -(-int(max_points) // (MAX_BARS - 2))
    counts_by_bar = Counter(int(value) // bar_width for value in values)
    starts = range(0, int(max_points) + 1, bar_width)
    ends = (min(start + bar_width - 1, int(max_points)) for start in starts)
    return [
        Bar(f"{start}–{end}" if end > start else str(start), counts_by_bar[start // bar_width])
        for start, end in zip(starts, ends, strict=True)
    ]


def histogram(bars: Sequence[Bar], title: str) -> Markup:
    """A histogram as SVG, each bar with its count above it, and all counts as text for screen readers."""
    max_count = max(bar.count for bar in bars) or 1
    step, baseline = WIDTH / len(bars), HEIGHT - BOTTOM_MARGIN
    description = "; ".join(f"{bar.label} points: {bar.count}" for bar in bars)
    shapes = []
    for k, bar in enumerate(bars):
        height = (baseline - TOP_MARGIN) * bar.count / max_count
        left, middle = (k + 0.12) * step, (k + 0.5) * step
        shapes += [
            BAR_SVG.format(left, baseline - height, 0.76 * step, height),
            LABEL_SVG.format(middle, baseline - height - 4, 13, bar.count or ""),
            LABEL_SVG.format(middle, baseline + 16, 11, bar.label),
        ]
    return HISTOGRAM_SVG.format(f"{title}: {description}", WIDTH, HEIGHT, baseline, Markup().join(shapes))
