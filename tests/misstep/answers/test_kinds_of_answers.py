# ruff: noqa: ARG005, E501 - tables of what people type
"""Each kind of answer: ten right ways to type an answer, and ten wrong ones, as typed and as stored for the grader.

A wrong one stands with the mistake that feedback must name, "unreadable", or "" for one of which nothing is known.
"""

import json
from fractions import Fraction
from math import factorial, pi

import numpy as np
import pint
import pytest
import sympy as sp

from misstep import Problem
from misstep.answers.accuracy import absolute, decimals, digits, relative
from misstep.answers.angle import Angles
from misstep.answers.choice import Choice
from misstep.answers.equivalent import Equivalent
from misstep.answers.expression import ClosedForm
from misstep.answers.function import Function
from misstep.answers.groups.interval import Interval
from misstep.answers.groups.members import Members
from misstep.answers.groups.ordering import Ordering
from misstep.answers.groups.table import Table
from misstep.answers.number import Numbers
from misstep.answers.quantity import Quantity
from misstep.answers.text import Text
from misstep.judge import judge
from misstep.storage.deserialize import from_data
from misstep.storage.serialize import to_data

F, unit = Fraction, pint.UnitRegistry(cache_folder=None)
BAD = "unreadable"
COUNT = factorial(25)
MATRIX = [[1, 2], [3, 4]]
HALF = Numbers(["1/4", "1/2", "1/4"])
BINOMIAL = Table({"k": Numbers([0, 1, 2]), "p": HALF})
REVERSED = Function(lambda word: word[::-1], Text("a word"), lambda chance: ("".join(chance.choice(list("abcd"), 6)),))
LENGTHS = Function(
    lambda words: [len(word) for word in words],
    Numbers(np.array([1, 2])),
    lambda chance: (["x" * int(chance.integers(1, 5)), "x" * int(chance.integers(5, 9))],),
)
UNION = "(-oo, 1/2] u (3, oo)"

KINDS = {
    "whole number": (
        Numbers(5040),
        [5040, 5040.0, "5040", "5 040", "5.04·10³", F(5040), sp.Integer(5040), np.int64(5040), np.array(5040 + 0j), "+5040.0"],
        [(5041, ""), (5039.9, ""), (-5040, "all signs"), (5000, "rounded"), (True, BAD), (5040j, BAD), ("5,040", BAD),
         ("seven", BAD), ([5040, 1], BAD), (float("nan"), BAD)],
    ),
    "large whole number": (
        Numbers(COUNT),
        [COUNT, str(COUNT), F(COUNT), sp.Integer(COUNT), sp.factorial(25), f"{COUNT:_}", f"{COUNT}.0", "25!",
         np.array(COUNT, dtype=object), f" {COUNT} "],
        [(COUNT + 1, ""), (COUNT - 1, ""), (-COUNT, "all signs"), (factorial(24), ""), (1.5511e25, "rounded"), ("25!!", BAD),
         (10**400, BAD), (None, "blank"), ([COUNT, COUNT], BAD), ("1.55e25", "rounded")],
    ),
    "fraction": (
        Numbers(F(1, 3)),
        [F(1, 3), 1 / 3, "1/3", "2/6", " 1 / 3 ", sp.Rational(1, 3), 0.333333333333, "1/3 ", np.float64(1 / 3), "(1/3)"],
        [(0.3333, "rounded"), ("33 %", "rounded"), (0.3, ""), (-1 / 3, "all signs"), (2 / 3, "doubled"), (F(1, 6), "halved"),
         ("1/0", BAD), ("0,333", BAD), ("1:3", BAD), (False, BAD)],
    ),
    "fraction to four decimals": (
        Numbers("1/3", accuracy=decimals(4)),
        [0.3333, 1 / 3, "1/3", ".3333", 0.33333, F(3333, 10000), "33.33 %", sp.Rational(1, 3), 0.33335, "3.333e-1"],
        [(0.333, "rounded"), (0.33, "rounded"), (0.3334, ""), (-0.3333, "all signs"), (0.6667, "doubled"), (1 / 6, "halved"),
         (True, BAD), ("a third", BAD), ((1, 3), BAD), (3333, "")],
    ),
    "physical constant to three digits": (
        Numbers(6.02214e23, accuracy=digits(3)),
        [6.02e23, 6.022e23, "6.02e23", "6.02*10^23", "6.02×10^23", 6.02214076e23, "602.2e21", 602_000_000_000_000_000_000_000,
         "6.0221e+23", F(602 * 10**21)],
        [(6.0e23, "rounded"), (6.03e23, ""), (6.02e24, ""), (6.02e22, ""), (-6.02e23, "all signs"), (6.02, ""), (1e301, BAD),
         ("6,02e23", BAD), (float("inf"), BAD), (1.204428e24, "")],
    ),
    "measured, with an error": (
        Numbers(9.81, accuracy=absolute(0.05), unit="m"),
        [9.81, 9.8, 9.77, 9.86, "9.8", "9.80", F(98, 10), "981/100", np.array(9.83), sp.Float(9.81)],
        [(9.7, ""), (9.9, ""), (-9.81, "all signs"), (19.62, "doubled"), (9810, "millimetres"), (4.905, "halved"), (98.1, "power of ten"),
         ("9,81", BAD), (True, BAD), (10, "")],
    ),
    "two per cent": (
        Numbers(200.0, accuracy=relative(0.02)),
        [200, 204, 196, 203.9, "201", "2e2", F(399, 2), 198 + 1e-14j, "198.5", "20000 %"],
        [(205, ""), (195, ""), (-200, "all signs"), (20, ""), (2000, ""), (0, ""), (100, ""), (200j, BAD), ("two", BAD), ([], BAD)],
    ),
    "complex number": (
        Numbers(3 + 4j),
        [3 + 4j, "3+4j", "3 + 4i", "3+j4", "5 e^(j0.9273)", "5∠53.13°", "5 angle 53.13 deg", "5∠0.9273 rad", "5*exp(j*0.9273)",
         np.complex128(3 + 4j)],
        [(3 - 4j, "conjugate"), (4 + 3j, "real and imaginary swapped"), (-3 - 4j, "all signs"), (5, ""), ("5∠53.13", BAD),
         ("5∠36.87°", "real and imaginary swapped"), ("3+4k", BAD), ("5∠-53.13°", "conjugate"), (7, ""), (complex("nan"), BAD)],
    ),
    "complex vector": (
        Numbers(np.array([1 + 2j, 3])),
        [[1 + 2j, 3], np.array([1 + 2j, 3]), ["1+2j", "3"], (1 + 2j, 3.0), [[1 + 2j], [3]], ["1+2i", 3], [1 + 2j, 3 + 0j],
         ["1+j2", F(3)], [1.0001 + 2j, 3], [np.complex64(1 + 2j), 3]],
        [([1 - 2j, 3], "conjugate"), ([3, 1 + 2j], "two entries swapped"), ([-1 - 2j, -3], "all signs"),
         ([-1 - 2j, 3], "sign of one entry"), ([1 + 2j], BAD), (1 + 2j, BAD), ([1 + 2j, True], BAD), ([1, 3], "one entry"), (["x", 3], BAD),
         ([2 + 1j, 3j], "real and imaginary swapped")],
    ),
    "matrix of whole numbers": (
        Numbers(MATRIX),
        [MATRIX, np.array(MATRIX), np.array(MATRIX, float), [[F(1), 2], [3, 4]], [["1", "2"], ["3", "4"]], ((1, 2), (3, 4)),
         sp.Matrix(MATRIX), np.linalg.inv(np.linalg.inv(MATRIX)), [[1.0, 2], [3, "4"]], np.array(MATRIX, dtype=object)],
        [([[1, 3], [2, 4]], "transposed"), ([[3, 4], [1, 2]], "rows swapped"), ([[1, 2], [3, 4.01]], "one entry"), ([1, 2, 3, 4], BAD),
         ([[-1, -2], [-3, -4]], "all signs"), ([[1, 2], [3, True]], BAD), ([[2, 1], [4, 3]], "columns swapped"),
         ([[1, 2], [3]], BAD), ([[1, -2], [3, 4]], "sign of one entry"), ([[1, 2], [3, 4j]], BAD)],
    ),
    "eigenvector": (
        Equivalent(np.array([1.0, 2.0]), meaning=lambda v: np.outer(v, v) / max(v @ v, 1e-9)),
        [[1, 2], [2, 4], [-1, -2], (0.5, 1), np.array([-3, -6]), ["1", "2"], [F(1, 3), F(2, 3)], [[1, 2]], [0.4472, 0.8944],
         np.linalg.eigh([[1, 2], [2, 4]])[1][:, 1]],
        [([2, 1], ""), ([1, -2], ""), ([1, 0], ""), ([0, 0], "placeholder"), ([1, 2.1], ""), ([1, 2, 0], BAD), (2, BAD), ([1, 2j], BAD),
         ([True, 2], BAD), ("1, 2", BAD)],
    ),
    "angle in degrees": (
        Angles(350.0, unit="degrees"),
        [350, -10, 710, "350°", "-10 deg", 350.0, -370, F(350), 350.1, np.int64(-10)],
        [(10, "all signs"), (170, "half a turn off"), (350 + 2 * pi, ""), (np.radians(350), "radians"), (True, BAD), ("350 m", BAD),
         (-170, "supplement"), (100, "complement"), ([350, 350], BAD), (351, "")],
    ),
    "angle in radians": (
        Angles(1.5 * pi),
        [1.5 * pi, -pi / 2, 3.5 * pi, 4.712, -1.5708, "4.7124", sp.pi * F(3, 2), np.array(4.7124), "270°", "3pi/2"],
        [(pi / 2, "all signs"), (270, "degrees"), (0, "placeholder"), (pi, "complement"), (True, BAD), ("3pi/2 m", BAD), (1, ""), (-90, "degrees"), (4.6, ""), ({}, BAD)],
    ),
    "interval": (
        Interval("[0, 1)"),
        ["[0, 1)", "[0;1)", "[0,1[", " [ 0 , 1 ) ", "0 <= x < 1", "0 ≤ t < 1", "[0.0, 1.0)", "[0/5, 2/2)", "[0,1/2] u (1/2,1)",
         "[0, 0.6) ∪ [0.5, 1)"],
        [("(0, 1]", "ends of an interval"), ("[0, 1]", "ends of an interval"), ("(0, 1)", "ends of an interval"), ("[1, 0)", BAD),
         ("(-oo, 0) u [1, oo)", "complement"), ([0, 1], BAD), ((0, 1), BAD), ("[0, 2)", ""), ("[0, 1", BAD), ("x < 1", "")],
    ),
    "union of intervals": (
        Interval(UNION),
        [UNION, "(3, oo) u (-oo, 0.5]", "x <= 1/2 or x > 3", "(-∞, 1/2] ∪ (3, ∞)", "]-oo; 0.5] u ]3; oo[", "x≤0.5 or x>3",
         "(-inf,1/2] U (3,inf)", "(-oo, 1/2] u (3, 4] u (4, oo)  ", "(-infinity, .5]u(3, +oo)", "(-oo, 0] u [0, 2/4] u (3, oo)"],
        [("(1/2, 3]", "complement"), ("(-oo, 1/2) u [3, oo)", "ends of an interval"), ("(-oo, 1/2]", ""), ("[-oo, 1/2]", BAD),
         ("(-oo, oo)", ""), ("∅", ""), ("{1/2, 3}", ""), ("(-oo, 0,5] u (3, oo)", BAD), (0.5, BAD), ("(3, oo) u (-oo, 1/3]", "")],
    ),
    "set": (
        Members([2, 3, "1/2"]),
        [{2, 3, 0.5}, [0.5, 2, 3], (3, 2, 0.5), "{1/2, 2, 3}", "0.5; 2; 3", np.array([3, 2, 0.5]), [F(1, 2), 3, 2], ["1/2", 2, 3],
         [3, 3, 2, 0.5], frozenset({2, 3, F(1, 2)})],
        [({2, 3}, "elements missing"), ({2, 3, 0.5, 4}, "elements too many"), ([-2, -3, -0.5], "all signs"), ([2, 3, 0.6], ""),
         (2, BAD), ([True, 2, 0.5], BAD), ("{2, 3, x}", BAD), (set(), "elements missing"), ([[2], [3]], BAD), ({2, 3, 2.5}, "")],
    ),
    "multiset of eigenvalues": (
        Members([1 + 2j, 1 - 2j, 3.0, 3.0], repeated=True),
        [[3, 3, 1 + 2j, 1 - 2j], np.array([1 - 2j, 3, 1 + 2j, 3]), "{3, 3, 1+2j, 1-2j}", (3, 1 + 2j, 3, 1 - 2j), [3.001, 3, 1 + 2j, 1 - 2j],
         ["3", "3", "1+2i", "1-2i"], [1 + 2.0001j, 1 - 2j, 3, 3], "3, 3, 1+j2, 1-j2", [F(3), 3, 1 + 2j, 1 - 2j], ["1+2j", "1-2j", 3, 3]],
        [([3, 1 + 2j, 1 - 2j], "multiplicity"), ([3, 3, 3, 1 + 2j, 1 - 2j], "multiplicity"), ([3, 3, 1 + 2j], "elements missing"),
         ({3, 1 + 2j, 1 - 2j}, "multiplicity"), ([-3, -3, -1 + 2j, -1 - 2j], "all signs"), ([3, 3, 2 + 1j, 2 - 1j], ""),
         ([3, 3, 1, 1], ""), (3, BAD), ("{3, 3, a}", BAD), ([3, 3, 1 + 2j, 1 - 2j, 0], "elements too many")],
    ),
    "set of words": (
        Members(["copper", "silver"]),
        [{"silver", "copper"}, ["Copper", "SILVER"], "copper, silver", "{silver; copper}", ("copper", "silver"), ["copper", "copper", "silver"],
         [" copper ", "silver."], np.array(["silver", "copper"]), frozenset({"copper", "silver"}), "(Copper, Silver)"],
        [({"copper"}, "elements missing"), ({"copper", "silver", "iron"}, "elements too many"), (["copper", "gold"], ""), ([1, 2], BAD),
         ("gold, iron", ""), (True, BAD), (None, "blank"), ([["copper"]], BAD), ({"copper": "silver"}, BAD), (["cooper", "silver"], "")],
    ),
    "table": (
        BINOMIAL,
        [{"k": [0, 1, 2], "p": [0.25, 0.5, 0.25]}, [[0, 0.25], [1, 0.5], [2, 0.25]], {"P": ["1/4", "1/2", "1/4"], "K": [0, 1, 2]},
         np.array([[0, 0.25], [1, 0.5], [2, 0.25]]), [{"k": k, "p": p} for k, p in ((0, 0.25), (1, 0.5), (2, 0.25))],
         {"k": (0, 1, 2), "p": (F(1, 4), F(1, 2), F(1, 4))}, {"k": np.arange(3), "p": np.array([1, 2, 1]) / 4},
         [("0", "1/4"), ("1", "1/2"), ("2", "1/4")], {" k ": [0, 1, 2], "p.": [0.25, 0.5, 0.25]}, ((0, 0.25), (1, 0.5), (2, 0.25))],
        [([[0, 0.25], [1, 0.5], [2, 0.5]], ""), ({"k": [0, 1, 2], "p": [-0.25, -0.5, -0.25]}, "all signs"), ({"k": [0, 1, 2]}, BAD),
         ({"k": [0, 1, 2], "p": [0.25, 0.5, 0.25], "q": 1}, BAD), ({"k": [0, 1], "p": [0.25, 0.5, 0.25]}, BAD), ([0, 1, 2], BAD),
         ({"k": [1, 0, 2], "p": [0.25, 0.5, 0.25]}, "two entries swapped"), (7, BAD), ({"k": [0, 1, 2], "p": [0.5, 1, 0.5]}, "doubled"),
         ([[0, 0.25], [1, 0.5]], BAD)],
    ),
    "word": (
        Text("Fourier series", also=["series of Fourier"]),
        ["Fourier series", "fourier series", " FOURIER  SERIES ", "Fourier-series", "'Fourier series'", "Fourier series.", "Fouriér series",
         "series of Fourier", "Series of FOURIER", "“Fourier series”"],
        [("Fourier serie", "spelling"), ("Furier series", "spelling"), ("Fourrier series", "spelling"), ("Taylor series", ""), ("", ""),
         (3, BAD), (["Fourier series"], BAD), ("Fourier", ""), ("x" * 1000, BAD), ("Fourier transform", "")],
    ),
    "line of code": (
        Text("x = [1, 2]", strict=True),
        ["x = [1, 2]", " x = [1, 2]", "x = [1, 2] ", "x = [1, 2]\n", "\tx = [1, 2]", "\nx = [1, 2]\n", np.str_("x = [1, 2]"), "x = [1, 2]   ",
         "x" + " = [1, 2]", "   x = [1, 2]\t"],
        [("X = [1, 2]", "letter case or spaces"), ("x  = [1, 2]", "letter case or spaces"), ("x = [1,2]", ""), ("x = (1, 2)", ""),
         ("x == [1, 2]", ""), ([1, 2], BAD), (1, BAD), ("y = [1, 2]", ""), ("x = [1, 2];", ""), ("x = [2, 1]", "")],
    ),
    "quantity": (
        Quantity(1200.0, "ohm"),
        ["1200 ohm", "1200 Ω", "1.2 kΩ", "1.2kohm", "1.2e3 ohm", "0.0012 MΩ", "1200 V/A", unit("1.2 kiloohm"), "6/5 kΩ", "1 200 Ω"],
        [("1200 V", "wrong unit"), (1200, "unit missing"), ("1200", "unit missing"), ("1200 kΩ", "another unit"), ("1.2 Ω", "power of ten"),
         ("-1200 Ω", "all signs"), ("1200 wibble", BAD), ("Ω 1200", BAD), ("2400 ohm", ""), ([1200], "unit missing")],
    ),
    "complex quantity": (
        Quantity(3 + 4j, "ohm"),
        ["3+4j ohm", "5∠53.13° Ω", "3 + 4i Ω", "(3+4j) ohm", "0.003+0.004j kΩ", "5∠0.9273 rad ohm", "3+j4 Ω", (3 + 4j) * unit.ohm, "3+4j V/A",
         "3000+4000j mΩ"],
        [("3-4j ohm", "conjugate"), (3 + 4j, "unit missing"), ("5 ohm", ""), ("3+4j A", "wrong unit"), ("3+4j kΩ", "another unit"),
         ("5∠53.13 Ω", BAD), ("j Ω", ""), ("ohm", BAD), ("4+3j Ω", "real and imaginary swapped"), ("-3-4j ohm", "all signs")],
    ),
    "temperature": (
        Quantity(293.15, "kelvin"),
        ["293.15 K", "20 °C", "20 degC", "20 celsius", "68 degF", "293.15 kelvin", "293150 mK", "0.29315 kK", "20.0°C", unit.Quantity(293.15, "K")],
        [("20 K", ""), ("293.15 °C", "another unit"), (293.15, "unit missing"), ("20 J", "wrong unit"), ("20", "unit missing"), ("-20 °C", ""),
         ("K", BAD), ("293,15 K", BAD), ("2931.5 K", "power of ten"), (True, BAD)],
    ),
    "conditions": (
        Interval("[100, 1000)"),
        ["100 <= x < 1000", "1000 > x >= 100", "x >= 100 and x < 1000", "x in [100, 1000)", "x ∈ [10², 10³)", r"100 \leq x < 1000", "[10^2; 10^3[",
         "x >= 100 ∧ x < 1000", "100 ≤ X and 1000 > X", "x = 100 or 100 < x < 1000"],
        [("x >= 100 or x < 1000", ""), ("x > 100 and x < 1000", "ends of an interval"), ("[102, 103)", ""), ("x < 100 or x >= 1000", "complement"),
         ("x >= 100 and x > 1000", ""), ("x = 100", ""), ("x < 100 and x > 1000", ""), ("x and y", BAD), ("100 < x > 1000", BAD), ("in [1, 2]", BAD)],
    ),
    "solutions": (
        Members([2, 3]),
        ["x = 2 or x = 3", "2 and 3", "x1 = 2, x2 = 3", "x_1=3; x_2=2", "2 ∨ 3", "{2, 3}", " 3 , 2 ", "x=2 and x=3", "[6/2, sqrt(4)]", "2^1, 3^1"],
        [("x = 2", "elements missing"), ("x = -2 or x = -3", "all signs"), ("{}", "elements missing"), ("", "elements missing"), ("x or y", BAD), ("2 3", BAD),
         ("x = 2 or x = 3 or x = 5", "elements too many"), ("2.3", ""), ("x = ", BAD), ("x > 2 or x = 3", BAD)],
    ),
    "choice": (
        Choice("b", {"a": "to the left", "b": "to the right"}),
        ["b", "B", "(b)", "b)", "option b", "to the right", "To the right.", "b: to the right", "Answer B", "[b]"],
        [("a", ""), ("to the left", ""), ("A", ""), ("option a", ""), ("c", BAD), ("right", BAD), (2, BAD), ("ab", BAD), ("", BAD), (["b"], BAD)],
    ),
    "order": (
        Ordering(["Li", "Na", "K"]),
        [["Li", "Na", "K"], ("Li", "Na", "K"), "Li, Na, K", "Li < Na < K", "Li -> Na -> K", "Li; Na; K", ["li", "na", "k"], [" Li", "Na ", "K"],
         np.array(["Li", "Na", "K"]), "[Li, Na, K]"],
        [(["K", "Na", "Li"], "reversed"), ("Li, K, Na", "neighbours swapped"), (["K", "Li", "Na"], "one in the wrong place"), (["Li", "Na"], BAD),
         (["Li", "Na", "Na"], BAD), ("Li Na K", BAD), (["Li", "Na", "Rb"], BAD), (3, BAD), ([], BAD), ("Na, Li, K", "neighbours swapped")],
    ),
    "formula": (
        ClosedForm(sp.exp(-sp.Symbol("x")) * sp.sin(2 * sp.Symbol("x"))),
        ["exp(-x) sin(2x)", "e^(-x) sin(2x)", "sin(2x)/e^x", "2 sin(x) cos(x) e^-x", "y = exp(-x)*sin(2*x)", "f(x) = exp(-x) sin(2x)", r"e^{-x}\sin(2x)",
         "sin(2·x) e**(−x)", "sin(x+x) / exp(x)", sp.sin(2 * sp.Symbol("x")) / sp.exp(sp.Symbol("x"))],
        [("-exp(-x) sin(2x)", "all signs"), ("exp(x) sin(2x)", ""), ("exp(-x) cos(2x)", ""), ("e - x sin(2x)", ""), ("exp(-t) sin(2t)", BAD), ("sin 2x", BAD),
         ("", BAD), ("0", "left at 0"), (3, "letters missing"), ("x == 2", BAD)],
    ),
    "function of a text": (
        REVERSED,
        [lambda w: w[::-1], lambda w: "".join(reversed(w)), lambda w: w[::-1].upper(), lambda w: " " + w[::-1], lambda w: w[-1] + w[:-1][::-1],
         lambda w: str(np.array(list(w))[::-1].tolist()).translate({ord(c): None for c in "[]', "}), lambda w: np.str_(w[::-1]),
         lambda w: f"{w[::-1]}.", lambda w: f"'{w[::-1]}'", lambda word: word[::-1]],
        [(lambda w: w, ""), (lambda w: w[1:], ""), (lambda w: None, BAD), (lambda w: 1, BAD), (lambda: "", BAD), ("abc", BAD), (lambda w: {w}, BAD),
         (lambda w: w[5], ""), (lambda w: w[::-2], ""), (list, BAD)],
    ),
    "function of a list": (
        LENGTHS,
        [lambda ws: [len(w) for w in ws], lambda ws: list(map(len, ws)), lambda ws: np.array([len(w) for w in ws]),
         lambda ws: tuple(len(w) for w in ws), lambda ws: [ws.pop(0).count("x"), len(ws[0])], lambda ws: [F(len(w)) for w in ws],
         lambda ws: [float(len(w)) for w in ws], lambda ws: [str(len(w)) for w in ws], np.char.str_len,
         lambda ws: [w.count("x") for w in ws]],
        [(lambda ws: [len(w) + 1 for w in ws], ""), (sum, BAD), (lambda ws: ws, BAD), (lambda ws: [-len(w) for w in ws], "all signs"),
         (lambda ws: [], BAD), (lambda ws: ws[9], BAD), ([1, 2], BAD), (lambda ws: [True, 2], BAD), (lambda ws: [1, 1], "the same at every input"), (len, BAD)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_ten_right_and_ten_wrong_ways_to_type_an_answer(kind):
    answer, right, wrong = KINDS[kind]
    problem = Problem("", answer)
    assert len(right) == len(wrong) == 10
    for value, name in [*((one, "right") for one in right), *wrong]:
        stored = from_data(json.loads(json.dumps(to_data(value, answer.inputs), allow_nan=False)))
        for typed in (value, stored):
            judgement = judge(problem, typed)
            found = "" if judgement.state in {"wrong", "partly"} else judgement.state
            assert (judgement.mistakes[0] if judgement.mistakes else found) == name, (typed, judgement)
    for slip in problem.slips:  # what feedback says of itself is named as itself
        assert judge(problem, slip.value).state in ("wrong", "partly")


def test_a_text_that_would_take_long_or_overflow_is_unreadable():
    for kind in ("complex number", "interval", "set", "quantity", "complex quantity"):
        for text in (
            "1 m**9**9**9**9",
            "1 m**(9**9**9**9)",
            "1 m^9^9^9^9",
            "1e999+1j",
            "1e999∠1e999rad m",
            "1e999 m",
            "{" * 999,
        ):
            answer = KINDS[kind][0]
            assert judge(Problem("", answer), text).state in {"unreadable", "wrong"}, (kind, text)
