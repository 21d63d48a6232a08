"""What every frozen parameter has: a shape, equality, a hash, a spelling, and a way to a pickle."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Generic, Self, cast

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.errors import InvalidInput, Told
from kugelpendel.parameters._derived import Origin
from kugelpendel.parameters._numbers import (
    Numbers,
    Scalar_co,
    Scalars,
    as_numbers,
    column,
    common_shape,
    equal,
    hashed,
    unfit,
)

LONGEST = 200
"""Characters of a representation."""


class Given(Generic[Scalar_co]):
    """Numbers that belong together; arrays among them broadcast to an ensemble.

    A single case that makes no sense is refused at once. A bad case of an ensemble is kept, and
    becomes NaN with a reason in the motion. What makes sense is written in the core.

    Written on the standard library's dataclasses and not on attrs: `import kugelpendel` may take
    half as long again as NumPy and no more, and importing attrs would be a good part of that half.
    """

    part: ClassVar[str]
    """What the core calls it, as in "drag"."""
    units: ClassVar[dict[str, str]]
    """The SI unit of each of its numbers, under the names and in the order of the constructor."""
    strengths: ClassVar[tuple[str, ...]] = ()
    """The names of those without which it does nothing, where it is a force."""
    follows: ClassVar[dict[str, str]] = {}
    """The SI units of attributes that follow from its numbers and are told beside them."""

    def _give(self, names: str, *optional: str, **given: ArrayLike | None) -> None:
        """Keep the numbers.

        Parameters
        ----------
        names
            For the sentence where the shapes do not fit together.
        optional
            The names of those that may be None.
        given
            Under the names of `units`.
        """
        for name, value in given.items():
            known = value
            if type(value) is not float and not (value is None and name in optional):
                what = f"{self.part}.{name}"
                known = as_numbers(cast("ArrayLike", value), what, self.units[name])
            object.__setattr__(self, name, known)
        try:
            single = self.shape == ()
        except ValueError:
            raise unfit(names, tuple(self.named.values())) from None
        if single and (problem := self._problem()) is not None:
            raise InvalidInput.told(problem)

    def _derived_from(self, **origins: Origin) -> Self:
        """Note what some of the numbers were derived from, under their names."""
        object.__setattr__(self, "_origins", origins)
        return self

    def origin(self, name: str) -> Origin | None:
        """What a number was derived from, where it was and that is known; the core's name of it."""
        origins: dict[str, Origin] = getattr(self, "_origins", {})
        return origins.get(name.removeprefix(f"{self.part}."))

    def _problem(self) -> Told | None:
        """What the core says is wrong with a single case, if anything is."""
        return _core.problem({name: float(value) for name, value in self.prefixed.items()})

    @property
    def named(self) -> dict[str, Scalars]:
        """The numbers that were given, in SI, by their names."""
        values: dict[str, Scalars | None] = {name: getattr(self, name) for name in self.units}
        return {name: value for name, value in values.items() if value is not None}

    @property
    def values(self) -> tuple[Scalars, ...]:
        """The numbers, in SI and in the order of the constructor."""
        return tuple(self.named.values())

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single case."""
        return common_shape(tuple(self.named.values()))

    @property
    def prefixed(self) -> dict[str, Scalars]:
        """The numbers that were given by the names that the core has, as in "drag.linear"."""
        return {f"{self.part}.{name}": value for name, value in self.named.items()}

    def columns(self, shape: tuple[int, ...]) -> dict[str, Numbers]:
        """What the core takes for an ensemble of this shape, by the names that it has."""
        return {name: column(value, shape) for name, value in self.prefixed.items()}

    def __reduce__(self) -> tuple[Callable[..., Self], tuple[Scalars | None, ...]]:
        return (type(self), tuple(self.named.get(name) for name in self.units))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        ours, theirs = self.named, other.named
        return list(ours) == list(theirs) and equal(tuple(ours.values()), tuple(theirs.values()))

    def __hash__(self) -> int:
        return hash((type(self), tuple(self.named), hashed(tuple(self.named.values()))))

    def __repr__(self) -> str:
        return spelled(type(self).__name__, self.named, self.units)


def spelled(name: str, values: dict[str, Scalars], units: dict[str, str]) -> str:
    """Name, values and units, in at most 200 characters: ``Drag(linear=1e-05 1/s)``."""
    parts = (f"{key}={_spelled_value(value)} {units[key]}" for key, value in values.items())
    text = f"{name}({', '.join(part.rstrip() for part in parts)})"
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 2]}…)"


def _spelled_value(value: Scalars) -> str:
    if not isinstance(value, np.ndarray):
        return f"{value:.12g}"
    flat = value.ravel()
    if flat.size <= 3:
        return str(value.tolist())
    return f"[{flat[0]:.6g} … {flat[-1]:.6g}: {' × '.join(map(str, value.shape))}]"


def require_type(what: str, given: object, *wanted: type, way_out: str = "") -> None:
    """Raise InvalidInput for what is no instance of these classes of this package.

    Parameters
    ----------
    what
        For the sentence, such as "The pendulum".
    way_out
        What to write; a call of the first class unless given.
    """
    if not isinstance(given, wanted):
        names = " or ".join(f"kugelpendel.{kind.__name__}" for kind in wanted)
        raise wrong_type(what, given, names, way_out or f"write kp.{wanted[0].__name__}(…)")


def wrong_type(what: str, given: object, wanted: str, way_out: str) -> InvalidInput:
    """The error for what was given in place of what is wanted, both in words."""
    seen = f"{given!r:.60} of type {type(given).__name__}"
    return InvalidInput.of("wrong_type", what=what, wanted=wanted, seen=seen, way_out=way_out)
