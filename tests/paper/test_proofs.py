"""Every formula of the paper follows from its premises, and is true in numbers; what is printed
wrongly is neither."""

import pickle
from collections.abc import Callable

import pytest

from kugelpendel import paper
from kugelpendel.paper.algebra.calculus import is_constant_multiple, is_zero
from kugelpendel.paper.algebra.dimensions import is_homogeneous
from kugelpendel.paper.algebra.notation import NotationError, read
from kugelpendel.paper.algebra.symbols import a, b, l, omega, rho, t, theta, x
from kugelpendel.paper.algebra.sympy_names import Add, cos, sin, sqrt
from kugelpendel.paper.derivation.graph import premises
from kugelpendel.paper.proofs.symbolic import Premises

Examined = Callable[[str], paper.Row]
LABELS = [formula.label for formula in paper.FORMULAS]
NUMBERS = [
    "1",
    "2",
    "3",
    "4",
    "5a",
    "5b",
    "5c",
    "6",
    "8",
    "9",
    "10",
    "12",
    "13a",
    "13b",
    "16",
    "17",
    "18",
    "19",
    "20",
    "23",
    "25",
    "26",
]


@pytest.mark.parametrize("label", LABELS)
def test_formula_follows_and_is_true(label: str, examined: Examined) -> None:
    row = examined(label)
    assert row.symbolic
    assert row.numeric
    assert row.faults == ()  # that a premise is named but not used, among others


@pytest.mark.parametrize("label", LABELS)
def test_formula_has_one_dimension(label: str) -> None:
    assert is_homogeneous(paper.right(label))


@pytest.mark.parametrize("label", [f.label for f in paper.FORMULAS if f.is_misprinted])
def test_printed_formula_is_rejected_by_both_proofs(label: str) -> None:
    one = paper.formula(label)
    assert not one.proof(paper.printed(label), premises(one))
    assert not one.proof.true_in_numbers(paper.printed(label))


def test_all_numbers_of_the_paper_are_there() -> None:
    theirs = [one for one in paper.FORMULAS if not one.is_ours]
    numbers = list(dict.fromkeys(one.number for one in theirs if one.number))
    assert numbers == NUMBERS
    assert theirs == list(paper.FORMULAS[: len(theirs)])
    assert [one.section for one in paper.FORMULAS] == sorted(one.section for one in paper.FORMULAS)
    assert len(set(LABELS)) == len(LABELS)


def test_every_display_of_our_own_has_a_number_of_its_chapter() -> None:
    ours = [one for one in paper.FORMULAS if one.is_ours]
    assert {one.section for one in ours} == {5, 6, 7, 8}
    for section, letter in zip((5, 6, 7, 8), "ABCD", strict=True):
        found = list(dict.fromkeys(one.number for one in ours if one.section == section))
        assert found == [f"{letter}{k}" for k in range(1, len(found) + 1)]
    assert all(one.number == one.display and not one.is_misprinted for one in ours)
    assert not set(NUMBERS) & {one.number for one in ours}


def test_nothing_rests_on_what_comes_later() -> None:
    order = {label: k for k, label in enumerate(LABELS)}
    assert all(order[premise] < order[label] for premise, label in paper.edges())


def test_everything_that_25_rests_on_goes_back_to_1_in_order() -> None:
    found = paper.rests_on("25")
    assert found[0] == "1"
    assert found[-1] == "23.9"
    assert list(found) == sorted(found, key=LABELS.index)
    assert {"5b", "10", "12", "13a", "20:x", "23.8:1"} <= set(found)
    assert "5a" not in found  # the tension
    assert "26" not in found
    assert paper.rests_on("1") == ()


def test_only_assumptions_rest_on_nothing() -> None:
    alone = {one.display for one in paper.FORMULAS if not (one.step.premises or one.is_ours)}
    # the law, the coordinates, ρ, L, two series, the turning system and what is assumed small
    assert alone == {"1", "2", "6", "8.1", "12.1", "12.2", "17", "19"}
    ours = {one.display for one in paper.FORMULAS if one.is_ours and not one.step.premises}
    # the two circles, the energy, u and h, the turning points and their radii
    assert ours == {"A1", "A2", "B6", "C1", "C3", "C5", "C10"}


def test_a_premise_that_is_not_named_is_refused() -> None:
    one = paper.formula("25")
    with pytest.raises(KeyError, match="does not name"):
        premises(one)["23.8:1"]


@pytest.mark.parametrize(
    ("premise", "old", "new", "label"),
    [
        ("9:2", r"x\ddot{y}", r"2x\ddot{y}", "10.8:1"),
        ("23.5", "5b^2", "6b^2", "23.6:1"),
        ("20:x", "- b", "+ b", "20.3:1"),
        ("12", r"\omega_0^2 x", r"2\omega_0^2 x", "13a"),
        ("4:z", "-", "+", "4.2"),
        ("23.9", "12ab", "13ab", "25"),
        ("25", "3", "5", "26"),
    ],
)
def test_a_formula_does_not_follow_from_a_spoilt_premise(
    premise: str, old: str, new: str, label: str
) -> None:
    relations = {one: paper.right(one) for one in LABELS}
    spoilt = paper.formula(premise).right.replace(old, new)
    relations[premise] = read(spoilt)
    assert relations[premise] != paper.right(premise)
    one = paper.formula(label)
    assert not one.proof(paper.right(label), Premises(one.step.premises, relations))


@pytest.mark.parametrize("label", ["7", "11", "27", "", "nonsense", "(25)"])
def test_unknown_equation(label: str) -> None:
    with pytest.raises(paper.UnknownLabel, match="no equation"):
        paper.parts(label)
    with pytest.raises(paper.UnknownLabel):
        paper.rests_on(label)


def test_a_display_has_its_parts() -> None:
    assert [one.label for one in paper.parts("2")] == ["2:x", "2:y", "2:z"]
    assert [one.label for one in paper.parts("5b")] == ["5b"]
    with pytest.raises(paper.UnknownLabel, match="no formula '2'"):
        paper.formula("2")


@pytest.mark.parametrize(
    "latex", [r"\tan \theta = 1", "x = = y", "(x = y", "= x", r"x \gg y", "x = y = l", "x^y", "ß"]
)
def test_what_the_paper_does_not_write_is_not_read(latex: str) -> None:
    with pytest.raises(NotationError):
        read(latex)


def test_zero_is_decided() -> None:
    s, c = sin(theta), cos(theta)
    assert is_zero(s**2 + c**2 - 1)
    assert not is_zero(s**2 - c**2)
    assert is_zero(cos(3 * omega * t) - 4 * cos(omega * t) ** 3 + 3 * cos(omega * t))
    assert is_zero(sqrt(1 - s**2) - c)
    root = sqrt(1 - rho**2 / l**2)
    assert is_zero(root**3 / root - 1 + rho**2 / l**2)
    assert not is_zero(root - 1)
    assert is_zero(Add(a, -a))
    assert is_constant_multiple(2 * s * x, -3 * s * x)
    assert not is_constant_multiple(s * x, c * x)
    assert not is_constant_multiple(a * x, b * x)


def test_rows_and_formulas_travel_between_processes() -> None:
    row = paper.examined("25")
    assert pickle.loads(pickle.dumps(row)) == row
