"""Everything that is said of a formula besides itself, compared with what is so."""

from __future__ import annotations

from collections.abc import Callable

from kugelpendel.paper.algebra.notation import NotationError, read
from kugelpendel.paper.checks.printed_text import is_as_printed
from kugelpendel.paper.checks.remainders import as_said
from kugelpendel.paper.checks.signs import sign
from kugelpendel.paper.checks.steps import requirements
from kugelpendel.paper.checks.steps.operations import is_done
from kugelpendel.paper.derivation.graph import FORMULAS, parts, premises, right
from kugelpendel.paper.derivation.misprints import MISPRINTS
from kugelpendel.paper.derivation.model import Formula


def of_sign(one: Formula) -> tuple[str, ...]:
    """Whether the relation sign is the one that the numbers ask for."""
    found = read(one.right, right(one.head).lhs if one.head else None).op
    wanted = sign(one.label)
    return () if found == wanted else (f"has the sign {found}, where {wanted} is right",)


def of_step(one: Formula) -> tuple[str, ...]:
    """Whether the kind of step, with what it is done with, leads to the formula."""
    if is_done(one):
        return ()
    detail = f" with {one.step.detail}" if one.step.detail else ""
    return (f"is not what the step “{one.step.kind.value}”{detail} leads to",)


def of_remainder(one: Formula) -> tuple[str, ...]:
    """Whether what is said to be neglected is what is dropped."""
    try:
        said = as_said(one)
    except NotationError as error:
        return (f"neglects what cannot be read: {error}",)
    return () if said else (f"does not neglect what it says: “{one.step.neglected}”",)


def of_conditions(one: Formula) -> tuple[str, ...]:
    """Whether the conditions are those that the step needs."""
    return requirements.faults(one)


def of_premises(one: Formula) -> tuple[str, ...]:
    """Whether the premises come before, all of them are used, and no other is."""
    labels = [formula.label for formula in FORMULAS]
    at = labels.index(one.label)
    found = [
        f"rests on ({part.label}), which does not come before it"
        for name in one.step.premises
        for part in parts(name)
        if labels.index(part.label) >= at
    ]
    named = premises(one)
    try:
        one.proof(right(one.label), named)
    except KeyError as error:
        return (*found, str(error.args[0]))
    idle = [name for name in one.step.premises if name not in named.used]
    return (*found, *(f"names ({name}), which its proof does not use" for name in idle))


def of_print(one: Formula) -> tuple[str, ...]:
    """Whether it is printed as in the paper, and each difference is listed and no other."""
    if one.is_ours:
        return ("is not in the paper and cannot be misprinted",) if one.is_misprinted else ()
    found: list[str] = []
    if not is_as_printed(one):
        found.append("is not printed as it stands in the paper")
    listed = [
        misprint
        for misprint in MISPRINTS
        if misprint.where == one.label and misprint.kind != "word" and not misprint.in_words
    ]
    if bool(listed) != one.is_misprinted:
        found.append("differs from print and no misprint says so, or the other way round")
    for misprint in listed:
        pieces = ((misprint.printed, one.printed), (misprint.right, one.right))
        if not all(
            _bare(piece.partition(r" + \dots")[0]) in _bare(whole) for piece, whole in pieces
        ):
            found.append(f"does not hold what the misprint {misprint.key} says")
    return tuple(found)


def _bare(latex: str) -> str:
    return latex.replace(" ", "")


ALL: dict[str, Callable[[Formula], tuple[str, ...]]] = {
    "sign": of_sign,
    "step": of_step,
    "neglected": of_remainder,
    "condition": of_conditions,
    "premise": of_premises,
    "printed": of_print,
}
"""One check for each kind of thing that is said of a formula, by the name of its sabotages."""


def faults(one: Formula) -> tuple[str, ...]:
    """Give a sentence for each thing that is not as it says, without the formula's name."""
    return tuple(fault for check in ALL.values() for fault in check(one))
