"""The questions of the lectures: every file can be read, every option has a reason, and no explanation stands open."""

import json
import re
from pathlib import Path

from scipy.stats import chi2, chisquare

from kincourse import COURSE, find_question
from misstep.questions.item import KINDS

ROOT = Path(__file__).parents[2]
LECTURES = {path.stem.partition("_")[0]: path for path in sorted((ROOT / "notebooks").glob("[0-9]*.ipynb"))}
QUESTIONS = {
    (lecture, key): find_question(f"{lecture}/{key}") for lecture, items in COURSE.questions().items() for key in items
}


def test_every_option_of_every_question_has_a_reason_and_those_that_speak_of_the_others_stay_last():
    assert len(list(COURSE.folder.glob("lecture_*/questions.toml"))) == len(COURSE.questions()) >= 5
    words = r"(all|none) of them\b|(in )?both[,.]|both are\b|either[,.]|neither[,.]"
    for place, item in QUESTIONS.items():
        assert item.kind in KINDS, place
        assert all(len(option.why or item.explanation) > 20 for option in item.options), place
        assert len({option.text for option in item.options}) == len(item.options), place
        last = [one.last for one in item.options]
        speaks = [bool(re.match(words, one.text, re.IGNORECASE)) for one in item.options]
        assert speaks == last == sorted(last), place


def test_the_place_of_the_right_option_is_left_to_chance():
    """Over all questions, as often in each place as chance would have it: a reader who always presses B gains nothing."""
    items = QUESTIONS.values()
    places = [[sum(item.right == k for item in items if len(item.options) == n) for k in range(n)] for n in range(2, 9)]
    counted = [counts for counts in places if sum(counts)]
    statistic = sum(chisquare(counts).statistic for counts in counted)
    assert chi2.sf(statistic, sum(len(counts) - 1 for counts in counted)) > 0.05, counted


def cells(lecture, kind):
    notebook = json.loads(LECTURES[lecture].read_text("utf-8"))
    return [(cell["metadata"], "".join(cell["source"])) for cell in notebook["cells"] if cell["cell_type"] == kind]


def test_every_prediction_is_asked_and_then_explained():
    for (lecture, key), item in QUESTIONS.items():
        if item.kind == "predict":
            code = "\n".join(source for _, source in cells(lecture, "code"))
            asked, explained = (code.find(f'{verb}("{lecture}/{key}"') for verb in ("ask", "explain"))
            assert 0 <= asked < explained, (lecture, key)
            assert len(item.explanation) > 100, (lecture, key)
            for address in re.findall(r"\]\(([^)#]+)[^)]*\)", item.explanation):
                assert address.startswith("https://") or (LECTURES[lecture].parent / address).is_file(), address


def test_what_jupyterlab_folds_is_folded_on_the_site_and_no_explanation_stands_open():
    """JupyterLab goes by the metadata source_hidden and jp-MarkdownHeadingCollapsed, the site by a tag and the heading."""
    for lecture in LECTURES:
        for metadata, text in cells(lecture, "code"):
            is_hidden = metadata.get("jupyter", {}).get("source_hidden", False)
            assert is_hidden == ("hide-input" in metadata.get("tags", [])), text
        for metadata, text in cells(lecture, "markdown"):
            is_side_track = text.startswith("## Side track: ")
            assert metadata.get("jp-MarkdownHeadingCollapsed", False) == is_side_track, text
            assert "\n## Side track" not in text, "a side track must begin in a cell of its own"
            assert not re.search(r"(\*\*|__)Explain\b", text), text
    for sheet in Path(__file__).parents[2].glob("exercises/*/*.ipynb"):
        shown = [cell for cell in json.loads(sheet.read_text("utf-8"))["cells"] if cell["id"].startswith("show-")]
        assert all(cell["metadata"] == {"jupyter": {"source_hidden": True}, "tags": ["hide-input"]} for cell in shown)
