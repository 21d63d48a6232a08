"""The checker is checked: formulas spoilt at every place of their tree are rejected."""

import random

import pytest

from kugelpendel import paper
from kugelpendel.paper.checks.mutants import mutants
from kugelpendel.paper.checks.run import says_the_same, verdict
from kugelpendel.paper.derivation.graph import premises

LABELS = [formula.label for formula in paper.FORMULAS]


@pytest.mark.parametrize("label", LABELS)
def test_no_mutant_survives(label: str) -> None:
    row = paper.examined(label)
    assert row.symbolic
    assert row.numeric
    assert row.survivors == ()
    assert row.killed >= 2
    # equal ones are few: the whole equation negated or doubled, or sin² + cos² written as 1
    assert row.equal <= 2
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

    from kugelpendel.paper.proofs.numeric import in_world
    from kugelpendel.paper.proofs.symbolic import Proof
    from kugelpendel.paper.proofs.worlds import kinematic

    def blind(relation, _):
        return [relation.lhs - relation.lhs]

    numeric = in_world(kinematic)
    weak = replace(paper.formula("2:x"), proof=Proof(blind, lambda relation: iter([True])))
    fates = [verdict(weak, mutant) for mutant in mutants(weak, paper.right("2:x"))]
    assert "survivor" in fates
    assert all(numeric(paper.right("2:x")))


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
