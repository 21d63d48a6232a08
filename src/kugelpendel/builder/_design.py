"""All answers to what a builder asks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Unpack

from kugelpendel.builder._anisotropy import anisotropy
from kugelpendel.builder._answer import Answer
from kugelpendel.builder._case import Case
from kugelpendel.builder._decay import amplitude_after, decay
from kugelpendel.builder._half_turn import MOMENTS, half_turns, is_run
from kugelpendel.builder._hanging import hanging
from kugelpendel.builder._passage import passage
from kugelpendel.builder._period import period
from kugelpendel.builder._timing import timing
from kugelpendel.builder._turning import foucault, intrinsic, release, shares, total
from kugelpendel.parameters import (
    ForceParts,
    Forces,
    InvalidInput,
    Pendulum,
    Wire,
    as_numbers,
    gathered,
)

_QUESTIONS: tuple[Callable[[Case], Iterator[Answer]], ...] = (
    period, foucault, intrinsic, release, total, decay, anisotropy, timing, passage, hanging,
)  # fmt: skip


@dataclass(frozen=True)
class Design:
    """What a builder asked, answered.

    Attributes
    ----------
    case
        What was asked about.
    answers
        All of them, in the order of their groups.
    """

    case: Case
    answers: tuple[Answer, ...]

    def __getitem__(self, name: str) -> Answer:
        """The answer of that name. Raises InvalidInput for a name that no answer has."""
        for answer in self.answers:
            if answer.name == name:
                return answer
        names = ", ".join(answer.name for answer in self.answers)
        raise InvalidInput(f"This design has no answer {name!r}; it has {names}.")

    @property
    def rates(self) -> dict[str, float]:
        """What each cause adds to the rate of the plane at the start, rad/s."""
        return shares(self.case)

    def amplitude(self, time: float) -> float:
        """Of the swing without a drive after so many seconds, m: the drag's closed form."""
        return amplitude_after(self.case, time)


def design(
    pendulum: Pendulum,
    a: float,
    b: float = 0.0,
    *,
    azimuth: float = 0.0,
    forces: Forces | None = None,
    wire: Wire | None = None,
    share: float = 0.01,
    after: float = 3600.0,
    radius: float | None = None,
    time: float | None = None,
    checked: bool = True,
    done: Callable[[int, int], None] | None = None,
    **parts: Unpack[ForceParts],
) -> Design:
    """Answer what a builder asks of one pendulum.

    Parameters
    ----------
    pendulum
        Length, gravity and mass.
    a, b
        m, the swing's outer and inner turning radius as seen from a frame that does not turn;
        0 < a < length, |b| ≤ a/2, b positive counter-clockwise seen from above.
    azimuth
        rad, of the swing at the start, counter-clockwise from x.
    forces
        What acts; questions about the rest are left out.
    wire
        That it hangs on, where it has one.
    share
        Of the Foucault rate, that the intrinsic rate may reach, between 0 and 1.
    after
        s, time after which the amplitude is asked.
    radius
        m, to be passed; a/2 unless given.
    time
        s after the closest approach, for the place there; an eighth of a swing unless given.
    checked
        Whether `RealMotion` is run beside the formulas.
    done
        Told, now and then, how many of how many steps are done.
    parts
        In place of `forces`: site, drag, suspension, bob, drive.

    Returns
    -------
    Design
        Its answers, each with formula, source and check.

    Raises
    ------
    InvalidInput
        For ensembles, numbers out of their range, a bob that does not fit, and a site whose given
        gravity is not the pendulum's.

    Notes
    -----
    Formulas for b ≪ a ≪ l are first orders; the check beside each says how good they are here.
    """
    numbers = (
        _one(a, "The amplitude a", "m"), _one(b, "b", "m"), _one(azimuth, "The azimuth", "rad"),
    )  # fmt: skip
    asked = (
        _one(share, "The share of the Foucault rate", "1"), _one(after, "The time after", "s"),
        None if radius is None else _one(radius, "The radius to pass", "m"),
        None if time is None else _one(time, "The time after the closest approach", "s"),
    )  # fmt: skip
    steps, taken = 0, 0

    def worked() -> None:
        nonlocal taken
        taken += 1
        if done is not None:
            done(taken, steps)

    acting = gathered("A design", forces, parts)
    every = (acting.site, acting.drag, acting.suspension, acting.bob, acting.drive)
    case = Case(pendulum, *numbers, *every, wire, *asked, checked, worked)
    runs = sum(is_run(case, turn) for turn in half_turns(case))
    steps = len(_QUESTIONS) + MOMENTS * runs
    answers: list[Answer] = []
    for question in _QUESTIONS:
        answers.extend(question(case))
        worked()
    return Design(case, tuple(answers))


def _one(value: float, name: str, unit: str) -> float:
    number = as_numbers(value, name, unit)
    if not isinstance(number, float):
        raise InvalidInput(f"{name} must be one number in {unit}, but it is {value!r}.")
    return number
