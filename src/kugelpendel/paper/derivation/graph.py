"""All formulas in the paper's order, then those of our own chapters, and what each rests on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kugelpendel.paper.algebra.notation import Relation, read
from kugelpendel.paper.derivation.model import Formula
from kugelpendel.paper.derivation.ours.areas import FORMULAS as _AREAS
from kugelpendel.paper.derivation.ours.circles import FORMULAS as _CIRCLES
from kugelpendel.paper.derivation.ours.exact import FORMULAS as _SWING
from kugelpendel.paper.derivation.ours.next_order import FORMULAS as _NEXT
from kugelpendel.paper.derivation.section1 import FORMULAS as _MOTION
from kugelpendel.paper.derivation.section2_coordinates import FORMULAS as _CARTESIAN
from kugelpendel.paper.derivation.section2_exact import FORMULAS as _EXACT
from kugelpendel.paper.derivation.section3 import FORMULAS as _INFINITESIMAL
from kugelpendel.paper.derivation.section4_ansatz import FORMULAS as _FINITE
from kugelpendel.paper.derivation.section4_balance import FORMULAS as _BALANCE
from kugelpendel.paper.proofs.symbolic import Premises

FORMULAS: tuple[Formula, ...] = (
    *_MOTION,
    *_CARTESIAN,
    *_EXACT,
    *_INFINITESIMAL,
    *_FINITE,
    *_BALANCE,
    *_CIRCLES,
    *_AREAS,
    *_SWING,
    *_NEXT,
)
_BY_LABEL = {formula.label: formula for formula in FORMULAS}


class UnknownLabel(KeyError):
    """No formula and no display of the paper has this label."""

    def __str__(self) -> str:
        return str(self.args[0])


def formula(label: str) -> Formula:
    """The formula of that label; raises UnknownLabel."""
    if label not in _BY_LABEL:
        raise UnknownLabel(f"There is no formula {label!r}; the labels are in paper.FORMULAS.")
    return _BY_LABEL[label]


def parts(label: str) -> tuple[Formula, ...]:
    """The formulas of a display, of a number that stands at several displays, or one formula."""
    if label in _BY_LABEL:
        return (_BY_LABEL[label],)
    found = tuple(f for f in FORMULAS if f.display == label)
    if not found:
        raise UnknownLabel(f"There is no equation {label!r} in the paper.")
    return found


class _RightRelations(Mapping[str, Relation]):
    """Every formula as it should be, by label, each read only when it is asked for."""

    def __getitem__(self, label: str) -> Relation:
        one = _BY_LABEL[label]
        return read(one.right, self[one.head].lhs if one.head else None)

    def __iter__(self) -> Iterator[str]:
        return iter(_BY_LABEL)

    def __len__(self) -> int:
        return len(_BY_LABEL)


_RELATIONS = _RightRelations()


def right(label: str) -> Relation:
    """What the formula should say."""
    return _RELATIONS[formula(label).label]


def printed(label: str) -> Relation:
    """What stands in the paper; a line that continues a chain is read after its right head."""
    one = formula(label)
    return read(one.printed, _RELATIONS[one.head].lhs if one.head else None)


def premises(one: Formula) -> Premises:
    """The formulas that its step may use."""
    return Premises(one.step.premises, _RELATIONS)


def edges() -> tuple[tuple[str, str], ...]:
    """(premise, formula) for every arrow of the graph, labels of single formulas."""
    return tuple(
        (premise.label, one.label)
        for one in FORMULAS
        for name in one.step.premises
        for premise in parts(name)
    )


def rests_on(label: str) -> tuple[str, ...]:
    """Labels of everything that the formula or display rests on, in the paper's order.

    Those that are asked for are not among them. Raises UnknownLabel.
    """
    wanted = [one.label for one in parts(label)]
    asked, found = set(wanted), set[str]()
    while wanted:
        for name in formula(wanted.pop()).step.premises:
            for premise in parts(name):
                if premise.label not in found:
                    found.add(premise.label)
                    wanted.append(premise.label)
    return tuple(one.label for one in FORMULAS if one.label in found - asked)


def leading_to(target: str) -> tuple[str, ...]:
    """Labels of all that the formula or display rests on, and of its own parts; all for "".

    Raises UnknownLabel.
    """
    if not target:
        return tuple(_BY_LABEL)
    return (*rests_on(target), *(one.label for one in parts(target)))
