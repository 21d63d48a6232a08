"""What can be read off every case of a sweep: its name, its unit, and how it is measured."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from kugelpendel.motion import EnvelopeMotion, ExactMotion, Motion, RealMotion
from kugelpendel.parameters import InvalidInput, Numbers
from kugelpendel.sweeps._readings import READINGS

_ALL = frozenset({"exact", "averaged", "real"})
_AVERAGED = frozenset({"averaged"})
_INTEGRATED = frozenset({"averaged", "real"})
_NONE: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Quantity:
    """One thing that a sweep may read.

    Attributes
    ----------
    name
        In the file's list, and of the variable in the data set.
    unit
        In SI; "1" for a pure number.
    per_time
        Whether there is a value for each of the times that are asked for.
    motions
        Those that can be asked for it: "exact", "averaged", "real".
    text
        What it means.
    until
        The motions of which it is looked for up to the last of the times, so that one is needed.
    holds
        "number"; "rate" for an angular velocity of the plane, which is said in degrees an hour;
        "truth" for 0 or 1; "axis" for a direction without a front end, the same after half a turn.
    grounded
        Whether it makes sense on a turning ground only.
    """

    name: str
    unit: str
    per_time: bool
    motions: frozenset[str]
    text: str
    until: frozenset[str] = _NONE
    holds: Literal["number", "rate", "truth", "axis"] = "number"
    grounded: bool = False


_ROWS = (
    Quantity("frequency", "rad/s", False, frozenset({"exact"}), "frequency of the swing, ω"),
    Quantity(
        "precession", "rad/s", False, frozenset({"exact"}),
        "rate at which the ellipse turns by itself, Ω, counter-clockwise", holds="rate",
    ),
    Quantity("period", "s", False, frozenset({"exact"}), "period of the swing, 2π/ω"),
    Quantity(
        "azimuth", "rad", True, _ALL,
        "azimuth of the long axis, continuous from the launch, counter-clockwise",
    ),
    Quantity("a", "m", True, _ALL, "half the length of the swing"),
    Quantity("b", "m", True, _ALL, "half the width of the swing, positive counter-clockwise"),
    Quantity(
        "mean_rate", "rad/s", True, _ALL,
        "mean rate of the azimuth from the launch on, counter-clockwise", holds="rate",
    ),
    Quantity("largest_b", "m", False, _ALL, "largest |b| from the launch on", _INTEGRATED),
    Quantity(
        "quarter_turn", "s", False, _ALL,
        "time in which the plane turns by a quarter of a turn; infinite where it does not",
        _INTEGRATED,
    ),
    Quantity(
        "stalls", "1", False, _AVERAGED,
        "whether the plane, with all that acts, turns back or stands instead of going round",
        holds="truth", grounded=True,
    ),
    Quantity(
        "final_direction", "rad", False, _AVERAGED,
        "azimuth about which a plane that stalls comes to stay, or where it is when a tenth of the "
        "amplitude is left; from 0 to half a turn",
        holds="axis", grounded=True,
    ),
    Quantity(
        "stands_since", "s", False, _INTEGRATED,
        "since when the plane stands at the end of the times; infinite where it does not",
        _INTEGRATED, grounded=True,
    ),
    Quantity(
        "clamp_stalls", "1", False, _AVERAGED,
        "whether the clamp by itself, without drag and drive, makes the plane turn back",
        holds="truth",
    ),
    Quantity(
        "slowest_rate", "rad/s", False, _AVERAGED,
        "least rate of the plane in the Earth's sense, between the first and the last of the "
        "times, or from the launch to the only one",
        _AVERAGED, "rate",
    ),
    Quantity(
        "fastest_rate", "rad/s", False, _AVERAGED,
        "largest rate of the plane in the Earth's sense, in the same time",
        _AVERAGED, "rate",
    ),
    Quantity(
        "least_tension", "N", False, frozenset({"exact", "real"}),
        "least pull of the thread; below zero only a rod holds the motion", frozenset({"real"}),
    ),
    Quantity(
        "largest_tension", "N", False, frozenset({"exact", "real"}),
        "largest pull of the thread", frozenset({"real"}),
    ),
    Quantity(
        "error_25", "1", False, frozenset({"exact"}),
        "relative error of the precession by Olsson's (25)",
    ),
    Quantity(
        "error_26", "1", False, frozenset({"exact"}),
        "relative error of the frequency by Olsson's (26)",
    ),
    Quantity(
        "averaging_error", "rad", True, frozenset({"real"}),
        "how far the azimuth of the averaged equations is off",
    ),
)  # fmt: skip

QUANTITIES: dict[str, Quantity] = {quantity.name: quantity for quantity in _ROWS}
"""All that can be read, by name."""


def measure(motion: Motion, names: Sequence[str], times: Numbers) -> dict[str, Numbers]:
    """Read quantities off every case of an ensemble.

    Parameters
    ----------
    motion
        An exact, averaged or real ensemble of the shape (n,).
    names
        Of `QUANTITIES`, each once.
    times
        s after the launch, ascending; none where nothing that is read needs them.

    Returns
    -------
    dict
        By name, arrays of the shape (n,), or (n, len(times)) for what is read at times. NaN where a
        case is bad or has ended, and where there is no answer: no plane in less than a swing, no
        final direction of a plane that goes round.

    Raises
    ------
    InvalidInput
        For what `require_readable` refuses.

    Notes
    -----
    The bits of a case depend on neither the other cases nor the count of threads. Errors: those of
    the motion, and what `PlaneCourse`, `PlanePace` and `RealCourse` say of readings between times.
    """
    kind = _kind(motion)
    require_readable(kind, names, times, grounded=motion_is_grounded(motion))
    readings = READINGS[kind](motion, np.ascontiguousarray(times, np.float64))
    return {name: np.ascontiguousarray(getattr(readings, name)) for name in names}


def motion_is_grounded(motion: Motion) -> bool:
    """Whether a motion has a site, so that the ground turns under it."""
    return getattr(motion, "site", None) is not None


def require_readable(kind: str, names: Sequence[str], times: Numbers, *, grounded: bool) -> None:
    """Raise InvalidInput for quantities that a motion of a kind cannot be asked for.

    Parameters
    ----------
    kind
        "exact", "averaged" or "real".
    names
        Of quantities.
    times
        s, at which or up to which they are read.
    grounded
        Whether there is a site.
    """
    for name in names:
        quantity = QUANTITIES.get(name)
        if quantity is None:
            raise InvalidInput.of("sweep_no_quantity", quantities=name, known=", ".join(QUANTITIES))
        if kind not in quantity.motions:
            able = ", ".join(f'"{motion}"' for motion in sorted(quantity.motions))
            raise InvalidInput.of("sweep_not_of_motion", quantities=name, motion=kind, able=able)
        if (quantity.per_time or kind in quantity.until) and not np.size(times):
            raise InvalidInput.of("sweep_no_times", quantities=name)
        if quantity.grounded and not grounded:
            raise InvalidInput.of("sweep_no_ground", quantities=name)
    values = np.asarray(times, np.float64).ravel()
    if values.size and not (values[0] >= 0 and np.isfinite(values).all()):
        wrong = values[~((values >= 0) & np.isfinite(values))]
        raise InvalidInput.of("sweep_time_before", times=(float(wrong[0]), "s"))
    falling = np.flatnonzero(np.diff(values) <= 0)
    if falling.size:
        first = int(falling[0])
        earlier, later = float(values[first]), float(values[first + 1])
        raise InvalidInput.of("sweep_times_order", times=(earlier, "s"), after=(later, "s"))
    if "mean_rate" in names and values[0] == 0:
        raise InvalidInput.of("sweep_mean_rate", times=(0.0, "s"))


def _kind(motion: Motion) -> str:
    kinds = {"exact": ExactMotion, "averaged": EnvelopeMotion, "real": RealMotion}
    for kind, made in kinds.items():
        if isinstance(motion, made):
            return kind
    raise InvalidInput(
        f"A sweep reads exact, averaged and real motions, but this is {type(motion).__name__}."
    )
