"""The questions of the lectures: every file can be read, every option has a reason, and no explanation stands open."""

import json
import re
from pathlib import Path

import pytest
from scipy.stats import chi2, chisquare

from kincourse import COURSE, find_question
from misstep.questions.item import KINDS

ROOT = Path(__file__).parents[2]
LECTURES = {path.name[:2]: path for path in sorted((ROOT / "notebooks").glob("[0-9]*.ipynb"))}
QUESTIONS = [(lecture, key) for lecture, items in COURSE.questions().items() for key in items]


def test_every_file_of_questions_is_read():
    assert len(list(COURSE.folder.glob("lecture_*/questions.toml"))) == len(COURSE.questions()) >= 5


@pytest.mark.parametrize(("lecture", "key"), QUESTIONS)
def test_every_option_of_every_question_has_a_reason(lecture, key):
    item = find_question(f"{lecture}/{key}")
    assert item.kind in KINDS
    assert all(len(option.why) > 20 for option in item.options)
    assert len({option.text for option in item.options}) == len(item.options)


def test_the_place_of_the_right_option_is_left_to_chance():
    """Over all questions, as often in each place as chance would have it: a reader who always presses B gains nothing."""
    items = [find_question(f"{lecture}/{key}") for lecture, key in QUESTIONS]
    places = [[sum(item.right == k for item in items if len(item.options) == n) for k in range(n)] for n in range(2, 9)]
    counted = [counts for counts in places if sum(counts)]
    statistic = sum(chisquare(counts).statistic for counts in counted)
    assert chi2.sf(statistic, sum(len(counts) - 1 for counts in counted)) > 0.05, counted


@pytest.mark.parametrize(("lecture", "key"), QUESTIONS)
def test_options_that_speak_of_the_others_stay_last(lecture, key):
    options = find_question(f"{lecture}/{key}").options
    speak = [
        re.match(r"(all|none) of them\b|(in )?both[,.]|both are\b|either[,.]|neither[,.]", one.text, re.IGNORECASE)
        for one in options
    ]
    assert [bool(found) for found in speak] == [one.last for one in options] == sorted(one.last for one in options)


PREDICTIONS = [(lecture, key) for lecture, key in QUESTIONS if find_question(f"{lecture}/{key}").kind == "predict"]


def cells(lecture, kind):
    notebook = json.loads(LECTURES[lecture].read_text("utf-8"))
    return [(cell["metadata"], "".join(cell["source"])) for cell in notebook["cells"] if cell["cell_type"] == kind]


@pytest.mark.parametrize(("lecture", "key"), PREDICTIONS)
def test_every_prediction_is_asked_and_then_explained(lecture, key):
    code = "\n".join(source for _, source in cells(lecture, "code"))
    asked, explained = (code.find(f'{verb}("{lecture}/{key}")') for verb in ("ask", "explain"))
    assert 0 <= asked < explained
    assert len(find_question(f"{lecture}/{key}").explanation) > 100


@pytest.mark.parametrize(("lecture", "key"), PREDICTIONS)
def test_a_link_in_an_explanation_leads_to_a_file(lecture, key):
    for address in re.findall(r"\]\(([^)#]+)[^)]*\)", find_question(f"{lecture}/{key}").explanation):
        assert address.startswith("https://") or (LECTURES[lecture].parent / address).is_file()


@pytest.mark.parametrize("lecture", LECTURES)
def test_no_explanation_stands_open_in_a_lecture(lecture):
    assert not [text for _, text in cells(lecture, "markdown") if re.search(r"(\*\*|__)Explain\b", text)]


@pytest.mark.parametrize("lecture", LECTURES)
def test_what_jupyterlab_folds_is_folded_on_the_site(lecture):
    """JupyterLab goes by the metadata source_hidden and jp-MarkdownHeadingCollapsed, the site by a tag and the heading."""
    for metadata, text in cells(lecture, "code"):
        assert metadata.get("jupyter", {}).get("source_hidden", False) == ("hide-input" in metadata.get("tags", [])), (
            text
        )
    for metadata, text in cells(lecture, "markdown"):
        assert metadata.get("jp-MarkdownHeadingCollapsed", False) == text.startswith("## Side track: "), text
        assert "\n## Side track" not in text, "a side track must begin in a cell of its own"
