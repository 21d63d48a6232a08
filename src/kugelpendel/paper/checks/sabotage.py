"""The check is checked: everything that is said of a formula is spoilt, one thing at a time.

Mutants spoil a formula's meaning (`mutants`); here its sign, step, conditions, premises and print
are spoilt, and the way it is typeset. Each sabotage must make the check for its kind find a fault.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from kugelpendel.paper.algebra.notation import NotationError, Relation, read
from kugelpendel.paper.checks.faults import ALL
from kugelpendel.paper.checks.mutants import spoilt
from kugelpendel.paper.checks.wording.figures import figure, says
from kugelpendel.paper.checks.wording.sentences import stands
from kugelpendel.paper.derivation import conditions
from kugelpendel.paper.derivation.graph import FORMULAS, right
from kugelpendel.paper.derivation.model import Condition, Formula, StepKind
from kugelpendel.paper.derivation.statements import FIGURE, STATEMENT

SIGNS = {"=": "=", "≈": r"\approx", "≪": r"\ll"}
_TURNED = {r"\neq": "=", r"\geq": "<", "=": r"\neq", r"\ll": r"\geq"}
_CONDITIONS = tuple(q for q in vars(conditions).values() if isinstance(q, Condition))


@dataclass(frozen=True)
class Sabotage:
    """A formula in which one thing is wrong: its kind, what was done, and the formula."""

    kind: str
    change: str
    formula: Formula


def sabotages(one: Formula) -> Iterator[Sabotage]:
    """Spoil everything that is said of a formula."""
    yield from _signs(one)
    yield from _kinds(one)
    yield from _details(one)
    yield from _remainders(one)
    yield from _conditions(one)
    yield from _premises(one)
    yield from _prints(one)


def is_noticed(spoiled: Sabotage) -> bool:
    """Whether the check for that kind of thing finds a fault."""
    check = ALL["step" if spoiled.kind in ("kind", "detail") else spoiled.kind]
    return bool(check(spoiled.formula))


def _signs(one: Formula) -> Iterator[Sabotage]:
    op = right(one.label).op
    if op:
        for other in SIGNS.values():
            if other != SIGNS[op]:
                spoiled = replace(one, right=_with_sign(one.right, SIGNS[op], other))
                yield Sabotage("sign", f"{other} for {SIGNS[op]}", spoiled)


def _with_sign(latex: str, old: str, new: str) -> str:
    before, _, after = latex.partition(old)
    return f"{before}{new} {after}"


def _with_step(one: Formula, sort: str, change: str, **changes: object) -> Sabotage:
    return Sabotage(sort, change, replace(one, step=replace(one.step, **changes)))  # pyright: ignore[reportArgumentType]


def _kinds(one: Formula) -> Iterator[Sabotage]:
    for kind in StepKind:
        if kind not in (one.step.kind, StepKind.STATE):
            yield _with_step(one, "kind", kind.value, kind=kind)


def _details(one: Formula) -> Iterator[Sabotage]:
    pieces = one.step.detail.split(",") if one.step.detail else []
    for at, piece in enumerate(pieces):
        for wrong in _wrong(piece):
            others = [*pieces[:at], wrong, *pieces[at + 1 :]]
            yield _with_step(one, "detail", wrong, detail=",".join(others))
    yield _with_step(one, "detail", "another", detail="" if pieces else r"\frac{1}{l}")


def _wrong(piece: str) -> Iterator[str]:
    """The factor or function doubled, inverted, and with each of its letters exchanged."""
    bare = piece.replace(r"\quad", "").strip()
    if bare.startswith(r"\pm"):
        term = bare.removeprefix(r"\pm")
        yield term
        yield rf"\pm 2{term}"
        return
    first, equals, second = bare.partition("=")
    for spoiled in (f"2 ({first})", rf"\frac{{1}}{{l}} ({first})", f"{first} l"):
        yield f"{spoiled} {equals} {second}" if equals else spoiled
    for old, new in ((r"\theta", r"\phi"), (r"\sin", r"\cos"), ("a", "b"), (r"\omega", r"\Omega")):
        if old in bare.replace(r"\frac", "").replace(r"\theta", "" if old == "a" else r"\theta"):
            yield bare.replace(old, new)
            return


def _remainders(one: Formula) -> Iterator[Sabotage]:
    said = one.step.neglected
    if not said:
        yield _with_step(one, "neglected", "something", neglected=r"\frac{\rho^4}{l^4}")
        return
    yield _with_step(one, "neglected", "nothing", neglected="")
    for change in (f"2 ({said})", f"-({said})", rf"\frac{{1}}{{l}} ({said})", f"{said} + {said}"):
        yield _with_step(one, "neglected", change, neglected=change)
    for old, new in (("4}", "3}"), ("8}", "4}"), ("^2", "^3"), ("2ab", "2a"), ("3ab", "4ab")):
        if old in said:
            changed = said.replace(old, new, 1)
            yield _with_step(one, "neglected", f"{new} for {old}", neglected=changed)


def _conditions(one: Formula) -> Iterator[Sabotage]:
    own = one.step.conditions
    for at, condition in enumerate(own):
        others = (*own[:at], *own[at + 1 :])
        yield _with_step(one, "condition", f"without {condition.key}", conditions=others)
        for turned in _turned(condition):
            changed = (*own[:at], replace(condition, latex=turned), *own[at + 1 :])
            yield _with_step(one, "condition", turned, conditions=changed)
    for condition in _CONDITIONS:
        if condition not in own:
            more = (*own, condition)
            yield _with_step(one, "condition", f"with {condition.key}", conditions=more)


def _turned(condition: Condition) -> Iterator[str]:
    sign = next((q for q in _TURNED if q in condition.latex), None)
    if sign is not None:
        yield condition.latex.replace(sign, _TURNED[sign])


def _premises(one: Formula) -> Iterator[Sabotage]:
    own = one.step.premises
    for at, name in enumerate(own):
        others = (*own[:at], *own[at + 1 :])
        yield _with_step(one, "premise", f"without ({name})", premises=others)
    circular = (*own, one.label)
    yield _with_step(one, "premise", "itself", premises=circular)
    later = FORMULAS[-1].label
    if later != one.label:
        yield _with_step(one, "premise", f"also ({later})", premises=(*own, later))


def _prints(one: Formula) -> Iterator[Sabotage]:
    if one.is_misprinted:
        yield Sabotage("printed", "the right one", replace(one, printed=one.right))
    for old, new in (("+", "-"), ("^2", "^3"), (r"\sin", r"\cos"), ("l", "a"), ("=", r"\approx ")):
        if old in one.printed:
            changed = one.printed.replace(old, new, 1)
            yield Sabotage("printed", f"{new} for {old}", replace(one, printed=changed))


# -- What is typeset ------------------------------------------------------------------------------


def mistyped(one: Formula) -> Iterator[str]:
    """The formula's LaTeX with something added that would be seen, or with a piece gone."""
    latex = one.right
    yield f"{latex} ."
    yield f"{latex} \\dot{{}}"
    yield f"{latex} 0"
    if "^2" in latex:
        yield latex.replace("^2", "^{02}", 1)
        yield latex.replace("^2", "_2", 1)
    if r" \theta" in latex:
        yield latex.replace(r" \theta", r" \theta^2", 1)
    if " t " in latex:
        yield latex.replace(" t ", " t^2 ", 1)
    if "}" in latex:
        yield latex.replace("}", "", 1)


def is_refused(one: Formula, latex: str) -> bool:
    """Whether a mistyped formula cannot be read, or says something else that is not proved."""
    try:
        relation = read(latex, right(one.head).lhs if one.head else None)
    except NotationError:
        return True
    return relation != right(one.label) and not one.proof.true_in_numbers(relation)


def spoilt_statements(relation: Relation) -> tuple[Relation, ...]:
    """The ways to spoil a statement of the wording: its meaning, and its sign."""
    signs = (op for op in ("=", "≈", "≪") if relation.op and op != relation.op)
    turned = tuple(Relation(relation.lhs, op, relation.rhs) for op in signs)
    return (*turned, *(mutant.relation for mutant in spoilt(relation)))


_FIGURES = ("zwei", "dritte", "vierter", "Quadrat", "two", "third", "fourth", "square", "8", "12")
_QUANTITY = re.compile(r"\$(@?[^$]+)\$")
_EXCHANGED = (
    (r"\theta", r"\phi"), (r"\phi", r"\theta"), (r"\Omega", r"\omega_0"), ("x", "z"), ("a", "z"),
    ("^2", "^3"), ("+", "-"), ("-", "+"),
)  # fmt: skip


def spoilt_sentences(texts: Iterable[tuple[str, str]]) -> Iterator[tuple[str, str, str]]:
    """Spoil the wording: the place, the kind and the text with one claim in it changed.

    Every figure says other numbers, statements get other names or are written out, and quantities
    are exchanged for others that do not stand where the sentence speaks of.
    """
    for place, text in texts:
        for found in FIGURE.finditer(text):
            for word in _FIGURES:
                if not says(word, figure(found[2])):
                    yield place, "figure", _changed(text, found, f"[{word}]({found[2]})")
        for found in STATEMENT.finditer(text):
            yield place, "statement", _changed(text, found, "$@nonsense$")
            yield place, "statement", _changed(text, found, "$x = 2y$")
        for found in _QUANTITY.finditer(text):
            for old, new in () if found[1].startswith("@") else _EXCHANGED:
                wrong = found[1].replace(old, new, 1)
                if wrong != found[1] and not stands(wrong, place, text):
                    yield place, "quantity", _changed(text, found, f"${wrong}$")
                    break


def _changed(text: str, found: re.Match[str], new: str) -> str:
    return text[: found.start()] + new + text[found.end() :]
