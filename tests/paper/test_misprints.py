"""Every misprint is one: its formula is rejected, with the smallest numbers that show it."""

from collections import Counter

import pytest

from kugelpendel import paper
from kugelpendel.paper.algebra.dimensions import is_homogeneous
from kugelpendel.paper.algebra.notation import components, read
from kugelpendel.paper.algebra.symbols import CARTESIAN, z, zd
from kugelpendel.paper.checks.signs import sign
from kugelpendel.paper.derivation.graph import premises

DISPLAYED = [one for one in paper.MISPRINTS if not one.in_words and one.kind != "word"]


def spaceless(latex: str) -> str:
    return latex.replace(" ", "")


def test_every_misprinted_formula_is_listed_and_no_other() -> None:
    wrong = {one.label for one in paper.FORMULAS if one.is_misprinted}
    assert {one.where for one in DISPLAYED} == wrong


@pytest.mark.parametrize("misprint", DISPLAYED, ids=lambda one: one.key)
def test_misprint_is_in_the_printed_formula_and_its_correction_in_the_right_one(
    misprint: paper.Misprint,
) -> None:
    one = paper.formula(misprint.where)
    printed, right = misprint.printed.split(r" + \dots")[0], misprint.right.split(r" + \dots")[0]
    assert spaceless(printed) in spaceless(one.printed)
    assert spaceless(right) in spaceless(one.right)


@pytest.mark.parametrize("misprint", DISPLAYED, ids=lambda one: one.key)
def test_counterexample_of_a_displayed_misprint(misprint: paper.Misprint) -> None:
    found = paper.counterexample(misprint.key)
    assert found is not None
    assert found.values
    assert found.excess != "0"


@pytest.mark.parametrize(
    "misprint", [one for one in DISPLAYED if one.known == "dimension"], ids=lambda one: one.key
)
def test_dimension_gives_it_away(misprint: paper.Misprint) -> None:
    assert not is_homogeneous(paper.printed(misprint.where))


def test_the_other_displayed_misprints_need_the_identity() -> None:
    by_dimension = {one.where for one in DISPLAYED if one.known == "dimension"}
    for one in DISPLAYED:
        if one.where not in by_dimension:
            assert is_homogeneous(paper.printed(one.where)), one.key


def test_missing_numbers() -> None:
    numbers = {one.number.rstrip("abc") for one in paper.FORMULAS}
    missing = [k for k in range(1, 27) if str(k) not in numbers]
    assert missing == [7, 11, 14, 15, 21, 22, 24]
    # the numbers are those of Olsson's article, so that the gaps are no misprints
    assert not [one for one in paper.MISPRINTS if "Nummer" in one.right]
    assert [f.display for f in paper.FORMULAS if f.number == "6" and ":1" in f.label] == [
        "6",
        "6b",
        "6c",
    ]


def test_keys_and_links_are_sound() -> None:
    keys = {one.key: one for one in paper.MISPRINTS}
    labels = [one.label for one in paper.FORMULAS]
    assert len(keys) == len(paper.MISPRINTS)
    order = [labels.index(one.where) for one in paper.MISPRINTS]
    assert order == sorted(order)
    for one in paper.MISPRINTS:
        assert set(one.travels) <= set(labels)
        if one.origin:
            assert one.where in keys[one.origin].travels, one.key
    with pytest.raises(KeyError):
        paper.counterexample("nonsense")


def test_errors_stay_where_they_do_not_travel() -> None:
    """A line after a misprinted one follows from the right one; the printed line would spoil it."""
    for label in ("6b:2", "6c:3", "6.1:2", "10.2", "10.7:8", "13a", "20.2", "20.5:2", "23.3"):
        one = paper.formula(label)
        assert not one.is_misprinted
        assert one.proof(paper.printed(label), premises(one))


def test_12_as_printed_fails_already_at_small_whole_numbers() -> None:
    found = paper.counterexample("length-power-in-12")
    assert found is not None
    assert dict(found.values) == {"l": "2", r"\omega_0": "1", "x": "1", r"\dot{x}": "1"}
    assert found.excess == "1/4"  # 1/3 instead of 1/12


def test_angular_momentum_as_printed_is_consistent_but_the_wrong_way_round() -> None:
    printed = [paper.printed(f"8.1:{k}").rhs for k in (1, 2, 3)]
    assert printed[0] == printed[1]
    assert (printed[1] - printed[2]).expand() == 0
    assert (printed[0] + paper.right("8.1:1").rhs).expand() == 0


def test_words_that_a_formula_refutes() -> None:
    # "x ẏ = y ẋ" for (9) would mean no angular momentum
    one = paper.formula("9:2")
    assert not one.proof(read(r"x\dot{y} = y\dot{x}"), premises(one))
    # the cubic terms are not small against ẍ + ω0² x: by (13a) they are its negative
    law = paper.right("13a").lhs
    balance = read(r"\ddot{x} + \omega_0^2 x = 0").lhs
    cubic = read(
        r"\frac{1}{2} \omega_0^2 \frac{x}{l^2} (x^2 + y^2) "
        r"- \frac{x}{l^2} (\dot{x}^2 + \dot{y}^2) = 0"
    ).lhs
    assert (law - (balance - cubic)).expand() == 0
    # and (23) gives that negative, not "the last two terms"
    assert (paper.right("23:1").lhs - cubic).expand() == 0


def test_how_many_there_are_of_each_kind() -> None:
    """False formulas, false words and loose signs; four formulas are wrong by an earlier error."""
    count = Counter(one.kind for one in paper.MISPRINTS)
    assert count == {"formula": 21, "word": 5, "loose": 15}
    carried = [one for one in paper.MISPRINTS if one.kind == "formula" and one.origin]
    assert [one.where for one in carried] == ["6.1:1", "10.7:5", "10.7:6", "10.7:6"]


def test_the_loose_equals_are_all_that_numbers_find() -> None:
    """One rule for all formulas: "=" between two expressions that are not the same."""
    inexact = [one.label for one in paper.FORMULAS if not one.is_ours and sign(one.label) == "≈"]
    said = [one.where for one in paper.MISPRINTS if one.kind == "loose" and one.printed == "="]
    assert inexact == said == ["12.3:1", "20.6", "20.8:1", "20.9:1", "20.10:1", "20.10:2", "23:1"]


def test_loose_bars_are_missing_at_every_size_that_may_be_negative() -> None:
    bars = [one.where for one in paper.MISPRINTS if one.known == "size"]
    assert bars == ["12.1", "19:1", "19:2", "20.6", "23.4"]


@pytest.mark.parametrize(
    ("key", "where"),
    [
        ("period-for-frequency", "19:2"),
        ("one-dot-each", "10.8:1"),
        ("equation-abbreviated", "23:1"),
        ("cubic-terms-negative", "23:1"),
        ("small-against-their-opposite", "23.4"),
    ],
)
def test_words_stand_with_the_formula_that_they_speak_of(key: str, where: str) -> None:
    (misprint,) = (one for one in paper.MISPRINTS if one.key == key)
    assert misprint.where == where


def test_counterexample_of_the_lost_square_is_where_it_shows() -> None:
    """At sin θ = 1 a sine and its square are the same; the sign beside it is right there."""
    found = paper.counterexample("lost-square-of-sine")
    assert found is not None
    assert dict(found.values)[r"\sin \theta"] == "3/5"
    assert found.excess == "-72/625"  # (9/25 − 3/5)·(3/5)·(4/5), too small


def test_printed_angular_momentum_is_the_vector_in_a_left_handed_triad() -> None:
    """With z down and x, y seen from above, r × mv by the right hand has the printed components.

    Up is −z: in (x, y, up), which is right-handed, the product of the columns is the vector.
    """
    up = {z: -z, zd: -zd}
    columns = components(paper.right("8.1:3").rhs.subs(up, simultaneous=True), CARTESIAN)
    printed = components(paper.printed("8.1:3").rhs, CARTESIAN)
    assert (columns[0] - printed[0]).expand() == 0
    assert (columns[1] - printed[1]).expand() == 0
    assert (-columns[2] - printed[2]).expand() == 0  # along z, which is against up
