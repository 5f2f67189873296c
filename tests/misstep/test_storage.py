"""Answers as data: what a student hands in is judged from JSON as it is judged at home, and no JSON does harm."""

import json
from contextlib import suppress

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from test_sheets import HOSTILE, Rude
from typed_answers import as_typed

from kincourse import find_sheet, open_sheet, sheets
from kinlib.dh.table import DHTable
from misstep.formulas.sympy_parsing import FUNCTIONS, LONGEST, expression
from misstep.judge import judge
from misstep.storage.deserialize import DEEPEST, MIME, MOST_NUMBERS, Malformed, Opaque, Outputs, from_data
from misstep.storage.serialize import MOST_PARTS, to_data

TEMPLATES = [template for name in sheets() for template in find_sheet(name).problems]


def sent(value, inputs=()):
    """A value after its journey: to JSON as strict as there is, and back."""
    return from_data(json.loads(json.dumps(to_data(value, inputs), allow_nan=False)))


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
def test_every_answer_is_judged_from_data_as_it_is_at_home(template):
    problem = template.variant("ada")
    typed = [problem.answer.value, *(wrong.value for wrong in problem.mistakes)]
    for value in [*map(as_typed, typed), ..., None, *HOSTILE.values(), Rude()]:
        home, away = judge(problem, value), judge(problem, sent(value, problem.answer.inputs))
        assert (away.state, away.fraction, away.mistakes) == (home.state, home.fraction, home.mistakes)


q, a = sp.symbols("q_1 a", positive=True)


@pytest.mark.parametrize(
    "value",
    [
        a * sp.cos(q) + sp.sin(q) ** 2 / 3,
        sp.sqrt(2) / 2,
        sp.pi / 2,
        sp.exp(-q) * sp.atan2(a, q),
        sp.Float("0.25") * a - 7,
        sp.Abs(q - a),
        sp.I * sp.pi,
        sp.Rational(3, 7) ** a,
    ],
    ids=str,
)
def test_a_formula_comes_back_as_the_same_formula(value):
    symbols = {symbol: sp.Symbol(symbol.name) for symbol in value.free_symbols}
    assert sp.simplify(sent(value) - value.subs(symbols)) == 0


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_function_of_the_language_is_read_as_sympys(name):
    arguments = sp.symbols("x y")[: 2 if name == "atan2" else 1]
    assert expression(str(getattr(sp, name)(*arguments))) == getattr(sp, name)(*arguments)


def test_a_matrix_of_formulas_comes_back_as_a_matrix():
    assert sent(sp.Matrix([[sp.Symbol("x"), 1], [0, sp.pi]])) == sp.Matrix([[sp.Symbol("x"), 1], [0, sp.pi]])


def test_numbers_that_sympy_made_are_numbers():
    np.testing.assert_allclose(np.array(sent([sp.pi / 2, sp.Rational(1, 4), 2]), dtype=float), [np.pi / 2, 0.25, 2])


@given(st.lists(st.lists(st.floats(allow_nan=True), min_size=3, max_size=3), min_size=1, max_size=4))
def test_arrays_and_rows_come_back_to_the_last_bit_but_for_what_is_not_finite(rows):
    expected = np.where(np.isfinite(rows), rows, np.nan)
    np.testing.assert_array_equal(sent(np.array(rows)), expected)
    np.testing.assert_array_equal(sent(rows), expected)


def test_a_table_comes_back_with_signs_base_and_tool():
    typed = "a | alpha | d | theta\n 0.4 | pi/2 | 0.1 | 0.3 - q1\n 0.3 | 0 | q2 - 1 | 1e-7\n 0.1 | 0 | 0.2 | 0"
    table = DHTable(typed, convention="modified", base=np.diag([1, -1, -1, 1.0]), tool=np.diag([-1, -1, 1, 1.0]))
    back = sent(table)
    assert (back.joints, back.convention) == (table.joints, "modified") == ("RPF", "modified")
    at = np.array([0.7, -0.2])
    np.testing.assert_allclose(back.fk(at), table.fk(at), rtol=0, atol=1e-15)


def test_a_function_is_called_where_it_is_asked_and_cannot_spoil_the_inputs():
    inputs = [(np.ones(2),), (np.zeros(2),)]
    outputs = sent(lambda x: np.add(x, 1, out=x), inputs)
    assert isinstance(outputs, Outputs)
    np.testing.assert_array_equal(outputs.values, [[2, 2], [1, 1]])
    assert inputs[0][0].sum() == 2


def test_what_is_no_answer_is_named():
    assert sent(object()) == Opaque("object")
    assert sent(np.zeros((4000, 4000))) == Opaque("array of shape (4000, 4000)")
    assert sent([0.5] * 100_000) == Opaque("list of 100000 entries")
    assert sent("x" * 20_000) == Opaque("text of 20000 characters")
    assert "raises RuntimeError" in sent(Rude()).name
    assert "nested deeper" in repr(sent([[[[[[[0]]]]]]]))
    assert sent(np.sin) == Opaque("function sin")


def test_a_formula_that_shares_its_parts_is_not_written_out():
    x = sp.Symbol("x")
    for _ in range(60):
        x = sp.sin(x) + sp.cos(x)
    assert sent(x) == Opaque(f"formula of more than {MOST_NUMBERS} parts")


def test_lists_in_lists_are_looked_at_up_to_a_number_of_parts():
    row = [[0.5] * 1000] * 1000
    assert sent([row] * 1000) == Opaque(f"list of more than {MOST_PARTS} parts")


def test_a_list_that_holds_itself_comes_to_an_end():
    endless = []
    endless.append(endless)
    assert len(json.dumps(to_data(endless))) < 1000


def a_table(**odd):
    right = {"dh": [[0, 0, 0, 0]], "convention": "standard", "joints": "R", "signs": [1]}
    pose = np.eye(4).tolist()
    return {**odd, **{name: value for name, value in {**right, "base": pose, "tool": pose}.items() if name not in odd}}


@pytest.mark.parametrize(
    "data",
    [
        7,
        "text",
        [],
        {},
        {"number": "7"},
        {"number": True},
        {"number": 10**400},
        {"number": 1, "score": 3},
        {"text": 7},
        {"text": "x" * (LONGEST + 1)},
        {"array": [1, 2], "shape": [3]},
        {"array": [1, 2], "shape": [-1]},
        {"array": [1, 2], "shape": [2.0]},
        {"array": [1, [2]], "shape": [2]},
        {"array": ["1"], "shape": [1]},
        {"array": 7, "shape": [1]},
        {"array": [1], "shape": 1},
        {"array": [1], "shape": [True]},
        {"array": [1], "shape": [1.0]},
        {"array": [1], "shape": [1] * (DEEPEST + 2)},
        {"array": [0] * (MOST_NUMBERS + 1), "shape": [MOST_NUMBERS + 1]},
        {"array": [], "shape": [0] * 40},
        {"array": [], "shape": [0, 10**30]},
        {"list": 7},
        {"list": [None] * (MOST_NUMBERS + 1)},
        {"list": [7]},
        {"map": {}},
        {"map": 7},
        {"map": [["a", None]] * (MOST_NUMBERS + 1)},
        {"map": [["a"]]},
        {"map": [[7, None]]},
        {"symbolic": 7},
        {"matrix": [[None], [None, None]]},
        {"matrix": 7},
        {"matrix": [7]},
        {"dh": [[0, 0, 0, 0]]},
        {"dh": [[0, 0, 0, 0]], "convention": "other", "joints": "R", "signs": [1], "base": [], "tool": []},
        {"dh": 7, "convention": "standard", "joints": "R", "signs": [1], "base": [], "tool": []},
        {"dh": [["x"]], "convention": [], "joints": {}, "signs": 1, "base": None, "tool": 7},
        a_table(signs="1"),
        a_table(joints=["R"]),
        a_table(joints="X"),
        a_table(signs=[0.5]),
        a_table(dh=[["0", 0, 0, 0]]),
        a_table(dh=[[10**400, 0, 0, 0]]),
        a_table(signs=[True]),
        a_table(dh=[[1e400, 0, 0, 0]]),
        a_table(base=[[1, 0, 0, 0], [0, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        {"matrix": [[]] * (MOST_NUMBERS + 1)},
        {"matrix": [[{"number": 1}], 7]},
        {"\ud800": 1},
        {"function": "f", "outputs": 7},
        {"function": "f", "outputs": [7]},
        {"other": None},
        {"pickle": "gASV"},
        {7: 7},
    ],
    ids=lambda data: json.dumps(data)[:60],
)
def test_json_of_any_other_form_is_refused(data):
    with pytest.raises(Malformed) as refused:
        from_data(data)
    assert str(refused.value).encode().endswith((b".", b"?")), "a sentence that a screen can show, to its end"


def welds(n):
    return a_table(dh=[[0, 0, 0, 0]] * n, joints="F" * n, signs=[1] * n)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"matrix": [7]}, "A matrix is a list of rows of one length."),
        (a_table(dh=[[0, 0, 0]]), "This is no DH table: rows should have shape (..., 4); got (1, 3). One vector has 4"),
        (a_table(joints=["R"]), "This is no DH table: joints must be text, a letter for each row; got list ['R']."),
        (
            a_table(signs=[0.5]),
            "This is no DH table: signs must have an entry 1 or -1 for each of the 1 rows; got list",
        ),
        (a_table(signs=[1, 1]), "A DH table is a list of rows, with a letter and a sign for each of them."),
        (a_table(joints="RR"), "A DH table is a list of rows, with a letter and a sign for each of them."),
        (a_table(dh=7), "A DH table is a list of rows, with a letter and a sign for each of them."),
        (welds(MOST_NUMBERS), "This is no DH table: A table should have at least one joint; every row here is fixed."),
        (welds(MOST_NUMBERS + 1), f"A DH table has at most {MOST_NUMBERS} rows."),
        ({"b": 1, "a": 2}, "An answer has none of the forms with the keys 'a, b'."),
    ],
    ids=lambda value: str(value)[:40],
)
def test_what_is_refused_is_told_why(data, said):
    with pytest.raises(Malformed) as refused:
        from_data(data)
    assert str(refused.value).startswith(said)


def test_what_is_read_may_be_as_long_as_any_and_no_longer_name_is_told():
    assert from_data({"text": "x" * LONGEST}) == "x" * LONGEST
    assert len(from_data({"list": [None] * MOST_NUMBERS})) == MOST_NUMBERS
    assert from_data({"array": [1] * MOST_NUMBERS, "shape": [MOST_NUMBERS]}).sum() == MOST_NUMBERS
    assert from_data({"array": [1], "shape": [1] * (DEEPEST + 1)}).ndim == DEEPEST + 1
    assert from_data({"array": [], "shape": [0, 3]}).shape == (0, 3)
    assert from_data({"matrix": [[]] * MOST_NUMBERS}).shape == (MOST_NUMBERS, 0)
    assert from_data({"map": [["a" * 100, {"number": 1}]] * MOST_NUMBERS}) == {"a" * 80: 1}
    with pytest.raises(Malformed) as refused:
        from_data(a_table(dh=[[0] * 4] * 2000, joints="X" * 2000, signs=[1] * 2000))
    assert len(str(refused.value)) < 200


def test_a_table_of_plain_numbers_is_read():
    assert from_data(a_table()).joints == "R"


@pytest.mark.parametrize("entry", [None, {"text": "x"}, {"list": []}, {"function": "f", "outputs": []}, {"matrix": []}])
def test_a_matrix_of_what_is_no_formula_is_opaque(entry):
    assert from_data({"matrix": [[entry]]}) == Opaque("a matrix with entries that cannot be read")


NESTS = {
    "lists": lambda data: {"list": [data]},
    "maps": lambda data: {"map": [["a", data]]},
    "outputs": lambda data: {"function": "f", "outputs": [data]},
}


@pytest.mark.parametrize("nest", NESTS.values(), ids=NESTS)
def test_a_nest_is_read_to_a_depth_and_refused_beyond(nest):
    data = None
    for _ in range(DEEPEST + 2):
        data = nest(data)
    assert from_data(data) is not None
    with pytest.raises(Malformed, match="without end"):
        from_data(nest(data))


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('true')",
        "x.__class__",
        "(lambda: 1)()",
        "[1 for x in y]",
        "open('x')",
        "factorial(99999999)",
        "9**9**9**9",
        "(10**64)**64",
        "2**10**9",
        "sin(1, 2, 3)",
        "atan2(1)",
        "cos()",
        "1 if x else 2",
        "f'{x}'",
        "True",
        "'x'*99",
        "x[0]",
        "x < 2",
        "x // 2",
        "(" * 500 + "x" + ")" * 500,
        "",
        "sin(x",
    ],
)
def test_a_text_that_is_no_formula_is_opaque_and_nothing_runs(text):
    assert from_data({"symbolic": text}).name.startswith("a formula that cannot be read: ")


@given(st.text(alphabet="x1209.+-*/()sincoqrtpe, ", max_size=40))
def test_any_text_is_read_or_refused(text):
    from_data({"symbolic": text})


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=9),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(["number", "text", "array", "shape", "list", "map", "symbolic", "dh"]), inner, max_size=3
        )
    ),
    max_leaves=12,
)


@given(JSON)
def test_any_json_is_read_or_refused(data):
    with suppress(Malformed):
        from_data(data)


def test_a_check_shows_its_card_and_writes_the_answer_beside_it():
    verdict = open_sheet("03_poe_space", "ada").check(2, [1, 2, 3, 4, 5, 6])
    bundle = verdict._repr_mimebundle_()
    assert set(bundle) == {"text/plain", "text/html", MIME}
    expected = {"array": [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], "shape": [6]}
    assert bundle[MIME] == {"sheet": "03_poe_space", "problem": 2, "student": "ada", "answer": expected}
