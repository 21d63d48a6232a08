"""What a proof has compared is shown as it was, and a false formula leaves something."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from kugelpendel import paper
from kugelpendel.paper.algebra.calculus import carry_out, is_zero
from kugelpendel.paper.algebra.notation import read
from kugelpendel.paper.algebra.writing import written
from kugelpendel.paper.checks.mutants import mutants

Examined = Callable[[str], paper.Row]
LABELS = [formula.label for formula in paper.FORMULAS]


@pytest.mark.parametrize("label", LABELS)
def test_everything_compared_vanishes_and_is_shown(label: str, examined: Examined) -> None:
    row = examined(label)
    found = row.evidence
    assert found is not None
    assert found.holds
    assert (found.symbolic, found.numeric) == (row.symbolic, row.numeric) == (True, True)
    assert found.residuals
    assert len(found.points) == 3
    assert all(float(point.rest) <= float(point.allowed) for point in found.points)
    assert len({point.values for point in found.points}) == 3
    step = paper.formula(label).step
    assert (found.kind, found.conditions) == (step.kind, step.conditions)
    assert (found.neglected_order is None) == (not found.neglected)


@pytest.mark.parametrize("label", LABELS)
def test_what_is_written_is_read_back(label: str, examined: Examined) -> None:
    relation = paper.right(label)
    for side in (relation.lhs, relation.rhs):
        back = read(written(side)).lhs
        assert back == carry_out(side) or is_zero(back - carry_out(side))
    found = examined(label).evidence
    assert found is not None
    for residual in found.residuals:
        read(residual.latex)


def test_the_letters_of_a_point_are_those_of_the_formula() -> None:
    (first, *_) = paper.evidence("25").points
    assert [name for name, _ in first.values] == ["l", "a", "b", r"\omega_0", r"\Omega"]
    assert dict(first.values)["a"].endswith("e-12")  # small, and no digit of it is lost
    (first, *_) = paper.evidence("20:x").points
    assert [name for name, _ in first.values] == ["a", "b", "x", r"\Omega t", r"\omega t"]


def test_numbers_have_fifty_digits_and_give_the_rest() -> None:
    (first, *_) = paper.evidence("3").points
    numbers = dict(first.values)
    assert len(numbers["l"]) > 50
    assert numbers["l"] == numbers["r"]
    assert float(first.rest) < 1e-50


def test_a_mutant_leaves_something() -> None:
    one, relation = paper.formula("25"), paper.right("25")
    doubled = next(m for m in mutants(one, relation) if m.change.startswith("factor"))
    found = [trial.holds for trial in one.proof.trials(doubled.relation)]
    assert not any(found)
    spoilt = replace(paper.evidence("25").residuals[0], is_zero=False)
    assert not replace(paper.evidence("25"), residuals=(spoilt,)).holds


def test_a_row_holds_the_evidence_and_counts_the_mutants(examined: Examined) -> None:
    row = examined("25")
    assert row.evidence == paper.evidence("25")
    assert row.mutants == len(mutants(paper.formula("25"), paper.right("25"))) > 10
    assert row.holds


def test_several_are_proved_in_their_order() -> None:
    seen: list[tuple[int, int, str]] = []
    found = paper.proved(["3", "2:x"], lambda *one: seen.append((*one[:2], one[2].label)))
    assert [one.label for one in found] == ["3", "2:x"]
    assert seen == [(1, 2, "3"), (2, 2, "2:x")]
    with pytest.raises(paper.UnknownLabel):
        paper.proved(["7"])


def test_unknown_formula() -> None:
    with pytest.raises(paper.UnknownLabel):
        paper.evidence("7")
