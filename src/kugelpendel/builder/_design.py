"""All answers to what a builder asks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Unpack

from kugelpendel import _core
from kugelpendel.builder._answer import DesignAnswer
from kugelpendel.builder._case import Case
from kugelpendel.builder._decay import decay
from kugelpendel.builder._drive import drive as drives
from kugelpendel.builder._passage import passage
from kugelpendel.builder._period import period
from kugelpendel.builder._suspension import steps
from kugelpendel.builder._suspension import suspension as suspensions
from kugelpendel.builder._turning import budget, foucault, intrinsic, release, total
from kugelpendel.builder._wire import wire as wires
from kugelpendel.observables import Portrait
from kugelpendel.parameters import (
    ForceParts,
    Forces,
    InvalidInput,
    Pendulum,
    Wire,
    gathered,
    one_number,
    one_truth,
    require_type,
)

_QUESTIONS: tuple[Callable[[Case], Iterator[DesignAnswer]], ...] = (
    period, foucault, intrinsic, release, total, decay, suspensions, drives, passage, wires,
)  # fmt: skip


@dataclass(frozen=True)
class Design:
    """What a builder asked, and the answers.

    Attributes
    ----------
    pendulum, a, b, azimuth, forces, wire
        As given to `design`.
    answers
        All of them, in the order of their groups.
    budget
        What each cause but a drive adds to the rate of the plane at the start, rad/s: "earth",
        "intrinsic" and, with a suspension, "anisotropy" and "damping".
    """

    pendulum: Pendulum
    a: float
    b: float
    azimuth: float
    forces: Forces
    wire: Wire | None
    answers: tuple[DesignAnswer, ...]
    budget: dict[str, float]

    def __getitem__(self, key: str) -> DesignAnswer:
        """The answer of that key. Raises InvalidInput for a key that no answer has."""
        for answer in self.answers:
            if isinstance(key, str) and answer.key == key:  # pyright: ignore[reportUnnecessaryIsInstance]
                return answer
        raise InvalidInput(
            f"This design has no answer {key!r:.60}; it has {', '.join(self.keys())}."
        )

    def __contains__(self, key: object) -> bool:
        """Whether an answer has that key."""
        return key in self.keys()

    def keys(self) -> tuple[str, ...]:
        """Those of the answers, in their order."""
        return tuple(answer.key for answer in self.answers)

    @property
    def portrait(self) -> Portrait:
        """The map of the clamp for swings of this size, with this one on it."""
        return Portrait(self.pendulum, self.a, self.b, self.azimuth, self.forces)

    def amplitude(self, time: float) -> float:
        """Of the swing without a drive after so many seconds, m: the drag's closed form."""
        drag = self.forces.drag
        linear, quadratic = (0.0, 0.0) if drag is None else drag.values
        omega = self.forces.effective_pendulum(self.pendulum).angular_frequency
        fading = _core.Decay(float(linear), float(quadratic), float(omega))
        return fading.after(self.a, one_number(time, "The time", "s"))


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
        Whether `RealMotion` is run beside the formulas; what would take more than 100 000 swings
        is not run.
    done
        Told, now and then, how many of how many steps are done.
    parts
        In place of `forces`: site, drag, suspension, bob, drive.

    Returns
    -------
    Design
        Its answers by their keys, each with formula, source and check.

    Raises
    ------
    InvalidInput
        For ensembles, numbers out of their range, a bob that does not fit, and a site whose given
        gravity is not the pendulum's.

    Notes
    -----
    Formulas for b ≪ a ≪ l are first orders; the check beside each says how good they are here, and
    where a check contradicts its formula, the note says so.
    """
    require_type("The pendulum", pendulum, Pendulum)
    numbers = (
        one_number(a, "The amplitude a", "m"),
        one_number(b, "b", "m"),
        one_number(azimuth, "The azimuth", "rad"),
    )
    asked = (
        one_number(share, "The share of the Foucault rate", ""),
        one_number(after, "The time after", "s"),
        None if radius is None else one_number(radius, "The radius to pass", "m"),
        None if time is None else one_number(time, "The time after the closest approach", "s"),
    )
    count, taken = 0, 0

    def worked() -> None:
        nonlocal taken
        taken += 1
        if done is not None:
            done(taken, count)

    acting = gathered("A design", forces, parts)
    if wire is not None:
        require_type("The wire", wire, Wire)
    is_checked = one_truth(checked, "The option checked")
    case = Case(pendulum, *numbers, acting, wire, *asked, is_checked, worked)
    count = len(_QUESTIONS) + steps(case)
    answers: list[DesignAnswer] = []
    for question in _QUESTIONS:
        answers.extend(question(case))
        worked()
    return Design(pendulum, *numbers, acting, wire, tuple(answers), budget(case))
