"""Everything that acts on a pendulum beside gravity and its thread."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, TypedDict, Unpack, overload

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters._bob import Bob
from kugelpendel.parameters._derived import Origin
from kugelpendel.parameters._drag import Drag
from kugelpendel.parameters._drive import Drive
from kugelpendel.parameters._given import LONGEST, Given, require_type
from kugelpendel.parameters._launch import Launch
from kugelpendel.parameters._numbers import Numbers, Scalar, Scalar_co
from kugelpendel.parameters._pendulum import Pendulum
from kugelpendel.parameters._site import Site
from kugelpendel.parameters._suspension import Suspension


class ForceParts(TypedDict, Generic[Scalar_co], total=False):
    """The parts of `Forces` as keywords; a single part goes with an ensemble of the others."""

    site: Site[Scalar_co] | Site[float] | None
    drag: Drag[Scalar_co] | Drag[float] | None
    suspension: Suspension[Scalar_co] | Suspension[float] | None
    bob: Bob[Scalar_co] | Bob[float] | None
    drive: Drive[Scalar_co] | Drive[float] | None


FORCE_PARTS: dict[str, type[Given]] = {
    "site": Site,
    "drag": Drag,
    "suspension": Suspension,
    "bob": Bob,
    "drive": Drive,
}
"""What the parts of `Forces` are made of, in the order in which they are told."""


@dataclass(frozen=True, init=False, repr=False)
class Forces(Generic[Scalar_co]):
    """What acts on a pendulum: one object for all of it; None for what is not there.

    Parameters
    ----------
    site
        Where it hangs: the ground turns, and x is east and y north.
    drag
        Of the air.
    suspension
        What it lacks in symmetry, and its own damping.
    bob
        Its size: buoyancy, air carried along and moments of inertia change the gravity that acts.
    drive
        A push in every half swing.

    Raises
    ------
    InvalidInput
        For an unknown part and one of another type, and for shapes that do not broadcast.
    """

    site: Site[Scalar_co] | Site[float] | None
    drag: Drag[Scalar_co] | Drag[float] | None
    suspension: Suspension[Scalar_co] | Suspension[float] | None
    bob: Bob[Scalar_co] | Bob[float] | None
    drive: Drive[Scalar_co] | Drive[float] | None

    @overload
    def __init__(self: Forces[float], **parts: Unpack[ForceParts[float]]) -> None: ...

    @overload
    def __init__(self: Forces[Scalar], **parts: Unpack[ForceParts[Scalar]]) -> None: ...

    def __init__(self, **parts: Unpack[ForceParts]):
        _refuse_unknown("Forces", parts)
        for name in FORCE_PARTS:
            object.__setattr__(self, name, parts.get(name))
        for name, part in self.parts.items():
            way_out = f"write {name}=kp.{FORCE_PARTS[name].__name__}(…)"
            require_type(name, part, FORCE_PARTS[name], way_out=way_out)
        try:
            _ = self.shape
        except ValueError:
            raise unfit_parts(*self.parts.values()) from None

    @property
    def parts(self) -> dict[str, Given]:
        """Those that are there, by their names."""
        given: dict[str, Given | None] = {name: getattr(self, name) for name in FORCE_PARTS}
        return {name: part for name, part in given.items() if part is not None}

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () where everything is one number."""
        return np.broadcast_shapes(*(part.shape for part in self.parts.values()))

    @property
    def acts(self) -> bool:
        """Whether anything acts that the ideal pendulum does without.

        A bob alone changes the gravity of the ideal pendulum, and nothing else.
        """
        strengths = (getattr(part, s) for part in self.parts.values() for s in part.strengths)
        return any(np.any(np.asarray(strength) != 0) for strength in strengths)

    @overload
    def effective_pendulum(self: Forces[float], pendulum: Pendulum[float]) -> Pendulum[float]: ...

    @overload
    def effective_pendulum(self, pendulum: Pendulum) -> Pendulum: ...

    def effective_pendulum(self, pendulum: Pendulum) -> Pendulum:
        """The point mass that moves like this bob: its gravity takes in buoyancy and inertia.

        Its weight is that of the bob, so that the thread's pull is right but for buoyancy. Raises
        InvalidInput for a single bob that does not fit the pendulum; in an ensemble such a case
        is NaN.
        """
        if self.bob is None:
            return pendulum
        length, gravity, mass = pendulum.values
        factor = self.bob.gravity_factor(length)
        return Pendulum(length, np.multiply(gravity, factor), np.divide(mass, factor))

    def columns(self, shape: tuple[int, ...]) -> dict[str, Numbers]:
        """What the core takes for an ensemble of this shape, by the names that it has."""
        columns: dict[str, Numbers] = {}
        for part in self.parts.values():
            columns |= part.columns(shape)
        return columns

    def origin(self, name: str) -> Origin | None:
        """What the number of that name in the core was derived from, where that is known."""
        part = self.parts.get(name.partition(".")[0])
        return None if part is None else part.origin(name)

    def __reduce__(self) -> tuple[Callable[..., Forces], tuple[Given | None, ...]]:
        return (_again, tuple(getattr(self, name) for name in FORCE_PARTS))

    def __repr__(self) -> str:
        text = f"Forces({', '.join(f'{name}={part!r}' for name, part in self.parts.items())})"
        return text if len(text) <= LONGEST else f"{text[: LONGEST - 2]}…)"


def _again(*parts: Any) -> Forces:
    return Forces(**dict(zip(FORCE_PARTS, parts, strict=True)))


class ActedOn(Generic[Scalar_co]):
    """What has `forces`, and each of their parts under its own name; None for what is not there."""

    @property
    def forces(self) -> Forces[Scalar_co] | Forces[float]:
        """Everything that acts beside gravity and the thread."""
        raise NotImplementedError

    @property
    def site(self) -> Site[Scalar_co] | Site[float] | None:
        """Where it hangs; None for a ground that does not turn."""
        return self.forces.site

    @property
    def drag(self) -> Drag[Scalar_co] | Drag[float] | None:
        """Of the air; None for a vacuum."""
        return self.forces.drag

    @property
    def suspension(self) -> Suspension[Scalar_co] | Suspension[float] | None:
        """None for a perfect one."""
        return self.forces.suspension

    @property
    def bob(self) -> Bob[Scalar_co] | Bob[float] | None:
        """None for a point mass."""
        return self.forces.bob

    @property
    def drive(self) -> Drive[Scalar_co] | Drive[float] | None:
        """None for a free pendulum."""
        return self.forces.drive


def gathered(
    what: str, forces: Forces[Scalar] | Forces[float] | None, parts: ForceParts[Scalar]
) -> Forces[Scalar] | Forces[float]:
    """What acts on a motion, given as one object or by its parts.

    Parameters
    ----------
    what
        The name of the motion, for sentences.
    forces
        `Forces`, or None.
    parts
        By the names of `ForceParts`.

    Raises
    ------
    InvalidInput
        For both at once, for something else in place of forces, and for unknown parts.
    """
    _refuse_unknown(what, parts)
    if forces is None:
        return Forces(**parts)
    require_type("forces", forces, Forces, way_out="write kp.Forces(drag=…)")
    given = [name for name, part in parts.items() if part is not None]
    if given:
        raise InvalidInput.of("parts_twice", seen=", ".join(given))
    return forces


def _refuse_unknown(what: str, parts: ForceParts) -> None:
    for name in parts:
        if name not in FORCE_PARTS:
            known = ", ".join(FORCE_PARTS)
            raise InvalidInput.of("unknown_part", what=what, seen=name, known=known)


def unfit_parts(*parts: Any) -> InvalidInput:
    """What to raise where the shapes of parts do not broadcast."""
    shapes = ", ".join(f"{type(part).__name__} {part.shape}" for part in parts)
    return InvalidInput.of("shapes", names="what was given", shapes=shapes)


def require_given(motion: str, pendulum: Any, launch: Any) -> None:
    """Raise InvalidInput unless a motion is given a pendulum and a launch, in this order."""
    given = ((pendulum, Pendulum), (launch, Launch))
    if all(isinstance(part, kind) for part, kind in given):
        return
    call = f"kp.{motion}(kp.Pendulum(length), kp.Launch.ellipse(a, b))"
    swapped = all(
        isinstance(part, kind) for (part, _), (_, kind) in zip(given, given[::-1], strict=True)
    )
    way_out = f"the pendulum comes first: {call}" if swapped else f"write {call}"
    require_type(f"The pendulum of {motion}", pendulum, Pendulum, way_out=way_out)
    require_type(f"The launch of {motion}", launch, Launch, way_out=way_out)
