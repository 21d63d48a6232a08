"""Runs all proofs, and the mutants against them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from contextlib import suppress
from multiprocessing import get_context
from time import perf_counter
from typing import Literal

from kugelpendel.paper.algebra.calculus import is_constant_multiple, is_zero
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.checks.mutants import Mutant, mutants
from kugelpendel.paper.derivation.graph import FORMULAS, formula, premises, right
from kugelpendel.paper.derivation.model import Formula, Row

Verdict = Literal["killed", "equal", "survivor"]
Progress = Callable[[int, int, Row], None]


def check(
    parallel: bool = True,
    progress: Progress | None = None,
    labels: Iterable[str] | None = None,
) -> tuple[Row, ...]:
    """Proves every formula, symbolically and in numbers, and rejects its mutants.

    Parameters
    ----------
    parallel
        In as many processes as there are processors; otherwise in this one.
    progress
        Called after each formula with how many are done, of how many, and its row.
    labels
        Of single formulas; all of them by default.

    Returns
    -------
    One row per formula, in the paper's order. Raises UnknownLabel.
    """
    wanted = (
        [one.label for one in FORMULAS] if labels is None else [formula(q).label for q in labels]
    )
    rows: list[Row] = []
    workers = min(os.cpu_count() or 1, len(wanted))
    if not parallel or workers < 2:
        return tuple(_note(examined(label), rows, len(wanted), progress) for label in wanted)
    # spawn: a forked child of a process with threads (a progress bar's) may hang
    with (
        ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool,
        suppress(BrokenExecutor),
    ):
        for row in pool.map(examined, wanted):
            _note(row, rows, len(wanted), progress)
    # where no process can be started (a script read from standard input), this one goes on
    for label in wanted[len(rows) :]:
        _note(examined(label), rows, len(wanted), progress)
    return tuple(rows)


def _note(row: Row, rows: list[Row], total: int, progress: Progress | None) -> Row:
    rows.append(row)
    if progress is not None:
        progress(len(rows), total, row)
    return row


def examined(label: str) -> Row:
    """One formula's proofs and the fate of its mutants."""
    start = perf_counter()
    one, relation = formula(label), right(label)
    fates = [(mutant, verdict(one, mutant)) for mutant in mutants(one, relation)]
    return Row(
        label=label,
        step=one.step.kind,
        symbolic=one.proof(relation, premises(one)),
        numeric=one.proof.true_in_numbers(relation),
        killed=sum(fate == "killed" for _, fate in fates),
        equal=sum(fate == "equal" for _, fate in fates),
        survivors=tuple(mutant.change for mutant, fate in fates if fate == "survivor"),
        seconds=perf_counter() - start,
    )


def verdict(one: Formula, mutant: Mutant) -> Verdict:
    """Killed by one of the two proofs; else proved equal; else it survives.

    What is false in numbers is dead. What is true there may be the same equation in other words
    (proved), or true without following, which the symbolic proof rejects.
    """
    if not one.proof.true_in_numbers(mutant.relation, quick=True):
        return "killed"
    if says_the_same(mutant.relation, right(one.label)):
        return "equal"
    if not one.proof.true_in_numbers(mutant.relation):
        return "killed"
    return "survivor" if one.proof(mutant.relation, premises(one)) else "killed"


def says_the_same(first: Relation, second: Relation) -> bool:
    """Whether one relation is a number times the other, or has the same sides, identically."""
    if first.op != second.op:
        return False
    if first.op == "≪":  # of an order less: a number before either side says nothing
        return is_constant_multiple(first.lhs, second.lhs) and is_constant_multiple(
            first.rhs, second.rhs
        )
    if first.op == "=" and is_constant_multiple(first.difference, second.difference):
        return True
    return is_zero(first.lhs - second.lhs) and is_zero(first.rhs - second.rhs)
