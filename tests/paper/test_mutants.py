"""The checker is checked: formulas spoilt at every place of their tree are rejected."""

import random
from collections.abc import Callable

import pytest

from kugelpendel import paper
from kugelpendel.paper.algebra.notation import NotationError
from kugelpendel.paper.checks import run
from kugelpendel.paper.checks.faults import ALL
from kugelpendel.paper.checks.mutants import mutants
from kugelpendel.paper.checks.run import says_the_same, verdict
from kugelpendel.paper.derivation.graph import premises

Examined = Callable[[str], paper.Row]
LABELS = [formula.label for formula in paper.FORMULAS]
OURS = {formula.label for formula in paper.FORMULAS if formula.is_ours}


@pytest.mark.parametrize("label", LABELS)
def test_no_mutant_survives(label: str, examined: Examined) -> None:
    row = examined(label)
    assert row.symbolic
    assert row.numeric
    assert row.survivors == ()
    assert row.faults == ()
    assert row.killed >= 2
    # equal ones are few: the whole equation negated or doubled, or sin² + cos² written as 1; in a
    # chapter of ours also a factor changed that stands before all of what is zero
    assert row.equal <= (4 if label in OURS else 2)
    assert row.holds


@pytest.mark.parametrize("label", LABELS[::3])
def test_the_symbolic_proof_rejects_alone(label: str) -> None:
    one, right = paper.formula(label), paper.right(label)
    sample = random.Random(label).sample(mutants(one, right), k=2)
    for mutant in sample:
        if not says_the_same(mutant.relation, right):
            assert not one.proof(mutant.relation, premises(one)), mutant.change


@pytest.mark.parametrize("label", ["2:x", "5b", "10", "13a", "20:y", "25"])
def test_mutants_of_every_sort_are_made(label: str) -> None:
    sorts = {
        mutant.change.partition(":")[0]
        for mutant in mutants(paper.formula(label), paper.right(label))
    }
    assert {"sign", "factor", "letter"} <= sorts
    assert "exponent" in sorts or label in ("2:x", "20:y")


def test_an_equal_mutant_is_proved_equal_and_not_counted_as_killed() -> None:
    one, right = paper.formula("9:1"), paper.right("9:1")
    fates = [verdict(one, mutant) for mutant in mutants(one, right)]
    assert fates.count("equal") == 2  # all signs changed, everything doubled
    assert set(fates) == {"equal", "killed"}


def test_a_weak_proof_lets_mutants_survive() -> None:
    """The test of the test: a proof that looks at the left side only is found out."""
    from dataclasses import replace

    from kugelpendel.paper.proofs.numeric import Trial, in_world
    from kugelpendel.paper.proofs.symbolic import Proof
    from kugelpendel.paper.proofs.worlds import kinematic

    def blind(relation, _):
        return [relation.lhs - relation.lhs]

    numeric = in_world(kinematic)
    agreed = Trial(kinematic(0), rest=0, allowed=0)
    weak = replace(paper.formula("2:x"), proof=Proof(blind, lambda relation: iter([agreed])))
    fates = [verdict(weak, mutant) for mutant in mutants(weak, paper.right("2:x"))]
    assert "survivor" in fates
    assert all(trial.holds for trial in numeric(paper.right("2:x")))


def test_check_goes_through_all_or_some_and_reports() -> None:
    seen: list[tuple[int, int, str]] = []
    labels = ["25", "26", "5b"]
    rows = paper.check(
        parallel=False,
        labels=labels,
        progress=lambda done, total, row: seen.append((done, total, row.label)),
    )
    assert [row.label for row in rows] == labels
    assert seen == [(1, 3, "25"), (2, 3, "26"), (3, 3, "5b")]
    assert sum(row.mutants for row in rows) == sum(row.killed + row.equal for row in rows)


def test_check_in_parallel_gives_the_same() -> None:
    labels = ["5.1", "23.9"]
    alone = paper.check(parallel=False, labels=labels)
    together = paper.check(parallel=True, labels=labels)
    assert [(r.label, r.killed, r.equal) for r in alone] == [
        (r.label, r.killed, r.equal) for r in together
    ]


def test_check_of_an_unknown_formula() -> None:
    with pytest.raises(paper.UnknownLabel):
        paper.check(labels=["7"])


@pytest.mark.parametrize("label", ["3", "5b", "8:1", "10.7:1", "12.1", "20.6", "23.6:1", "25"])
def test_every_sabotage_of_what_is_said_is_noticed(label: str) -> None:
    """The whole of them, `kugelpendel derive --check`, takes most of a minute."""
    row = paper.examined(label)
    assert row.unnoticed == ()
    assert row.holds
    made = {kind for kind, _, _ in row.sabotages}
    always = {"sign", "kind", "detail", "neglected", "condition", "premise", "printed", "typeset"}
    assert made == always
    assert all(tried == noticed > 0 for _, tried, noticed in row.sabotages)


def test_a_check_that_sees_nothing_is_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The test of the test: with a blind check of the conditions their sabotages go unnoticed."""
    monkeypatch.setitem(ALL, "condition", lambda one: ())
    row = paper.examined("6.3")
    assert any(change.startswith("condition: without off-axis") for change in row.unnoticed)
    assert not row.holds


def test_what_cannot_be_read_is_a_fault_and_no_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    def unreadable(label: str) -> None:
        raise NotationError("'x^y' has an exponent that is not a whole number.")

    monkeypatch.setattr(run, "right", unreadable)
    row = paper.examined("25")
    assert not row.holds
    assert row.faults == ("cannot be read: 'x^y' has an exponent that is not a whole number.",)
