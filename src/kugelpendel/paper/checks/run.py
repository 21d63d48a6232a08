"""Runs all proofs and checks, and the mutants and sabotages against them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from functools import partial
from time import perf_counter
from typing import Literal

from kugelpendel.paper.algebra.calculus import is_constant_multiple, is_zero
from kugelpendel.paper.algebra.notation import NotationError, Relation
from kugelpendel.paper.checks.evidence import evidence
from kugelpendel.paper.checks.faults import faults
from kugelpendel.paper.checks.mutants import Mutant, mutants
from kugelpendel.paper.checks.pool import Progress, one_by_one
from kugelpendel.paper.checks.row import Row
from kugelpendel.paper.checks.sabotage import (
    is_noticed,
    is_refused,
    mistyped,
    sabotages,
    spoilt_sentences,
    spoilt_statements,
)
from kugelpendel.paper.checks.signs import sign
from kugelpendel.paper.checks.wording import sentences, statements
from kugelpendel.paper.derivation.graph import FORMULAS, formula, premises, right
from kugelpendel.paper.derivation.model import Formula, StepKind
from kugelpendel.paper.derivation.statements import LANGUAGES, STATEMENTS

Verdict = Literal["killed", "equal", "survivor"]


def subjects() -> tuple[str, ...]:
    """Give all that can be checked: labels of formulas, names of statements, languages."""
    return (*(one.label for one in FORMULAS), *STATEMENTS, *LANGUAGES)


def check(
    parallel: bool = True,
    progress: Progress[Row] | None = None,
    labels: Iterable[str] | None = None,
    thorough: bool = True,
) -> tuple[Row, ...]:
    """Prove every formula and all that is said of it, and reject what is spoilt.

    Parameters
    ----------
    parallel
        In as many processes as there are processors; otherwise in this one.
    progress
        Called after each subject with how many are done, of how many, and its row.
    labels
        Some of `subjects()`; all of them by default.
    thorough
        Whether to sabotage steps, conditions, premises, print and wording too; the formulas are
        always mutated.

    Returns
    -------
    One row per subject, in the order asked for.

    Raises
    ------
    UnknownLabel
        A label that no subject has.
    """
    wanted = list(subjects()) if labels is None else list(labels)
    for label in wanted:
        if label not in STATEMENTS and label not in LANGUAGES:
            formula(label)
    one = partial(examined, thorough=thorough)
    return tuple(one_by_one(one, wanted, progress, parallel))


def examined(label: str, thorough: bool = True) -> Row:
    """Examine one subject: its proofs, what is said of it, and the fate of what is spoilt."""
    start = perf_counter()
    try:
        if label in STATEMENTS:
            return _statement(label)
        if label in LANGUAGES:
            return _sentences(label, thorough)
        return _formula(formula(label), thorough)
    except NotationError as error:
        step = (
            StepKind.STATE
            if label in STATEMENTS or label in LANGUAGES
            else formula(label).step.kind
        )
        seconds = perf_counter() - start
        return Row(label, step, False, False, 0, 0, (), seconds, (f"cannot be read: {error}",))


def _formula(one: Formula, thorough: bool) -> Row:
    """A formula of the paper."""
    start = perf_counter()
    relation, found = right(one.label), evidence(one.label)
    fates = [(mutant, verdict(one, mutant)) for mutant in mutants(one, relation)]
    counted, unnoticed = _sabotaged(one) if thorough else ((), ())
    return Row(
        label=one.label,
        step=one.step.kind,
        symbolic=found.symbolic,
        numeric=found.numeric,
        killed=sum(fate == "killed" for _, fate in fates),
        equal=sum(fate == "equal" for _, fate in fates),
        survivors=tuple(mutant.change for mutant, fate in fates if fate == "survivor"),
        seconds=perf_counter() - start,
        faults=faults(one),
        sabotages=counted,
        unnoticed=unnoticed,
        evidence=found,
    )


Counts = tuple[tuple[str, int, int], ...]


def _sabotaged(one: Formula) -> tuple[Counts, tuple[str, ...]]:
    """How many sabotages of each kind were made and noticed, and which were not."""
    made, noticed, unnoticed = Counter[str](), Counter[str](), list[str]()
    tried = [(q.kind, q.change, partial(is_noticed, q)) for q in sabotages(one)]
    tried += [("typeset", latex, partial(is_refused, one, latex)) for latex in mistyped(one)]
    for kind, change, found in tried:
        made[kind] += 1
        noticed[kind] += (seen := found())
        if not seen:
            unnoticed.append(f"{kind}: {change}")
    return tuple((kind, made[kind], noticed[kind]) for kind in made), tuple(unnoticed)


def _statement(name: str) -> Row:
    """A formula of the wording: proved or not, and its spoilt forms."""
    start = perf_counter()
    relation = statements.statement(name)
    wrong = spoilt_statements(relation)
    passed = [q for q in wrong if statements.holds(name, q)]
    alive = [q for q in passed if not says_the_same(q, relation)]
    proved = statements.holds(name)
    return Row(
        label=name,
        step=StepKind.STATE,
        symbolic=proved,
        numeric=proved,
        killed=len(wrong) - len(passed),
        equal=len(passed) - len(alive),
        survivors=tuple(f"{q.lhs} {q.op} {q.rhs}" for q in alive),
        seconds=perf_counter() - start,
    )


def _sentences(language: str, thorough: bool) -> Row:
    """The sentences of a language: what they claim beside the statements, and spoilt ones."""
    start = perf_counter()
    texts = list(sentences.texts(language))
    found = tuple(fault for place, text in texts for fault in sentences.faults(place, text))
    made, noticed, unnoticed = Counter[str](), Counter[str](), list[str]()
    for place, kind, wrong in spoilt_sentences(texts) if thorough else ():
        made[kind] += 1
        noticed[kind] += (seen := bool(sentences.faults(place, wrong)))
        if not seen:
            unnoticed.append(f"{kind}: {place}: {wrong}")
    return Row(
        label=language,
        step=StepKind.STATE,
        symbolic=not found,
        numeric=not found,
        killed=0,
        equal=0,
        survivors=(),
        seconds=perf_counter() - start,
        faults=found,
        sabotages=tuple((kind, made[kind], noticed[kind]) for kind in made),
        unnoticed=tuple(unnoticed),
    )


def verdict(one: Formula, mutant: Mutant) -> Verdict:
    """Killed by one of the two proofs; else proved equal; else it survives.

    What is false in numbers is dead, and so is what has another sign than the numbers ask for. What
    is true there may be the same equation in other words (proved), or true without following, which
    the symbolic proof rejects.
    """
    if mutant.relation.op != sign(one.label):
        return "killed"
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
