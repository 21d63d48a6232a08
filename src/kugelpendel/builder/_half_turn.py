"""The turning of a swing through all azimuths, by the averaged equations and by running it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from kugelpendel.builder import _measured
from kugelpendel.builder._case import Case
from kugelpendel.parameters import Drag, Suspension

MOMENTS = 80
"""Turning points that a run reads in half a turn."""

_MOST_SWINGS = 100_000
"""A half turn of more swings is not run."""

_STEPS = 1000
"""In half a turn of the Earth's, to find how long a run has to be."""

_LONGEST = 3.0
"""Half turns of the Earth's, after which a run ends however slow the turning is."""


@dataclass(frozen=True)
class HalfTurn:
    """What the averaged equations for b ≪ a say of half a turn of the swing.

    Attributes
    ----------
    alone
        The one cause beside the Earth.
    slowest, fastest
        rad/s, counter-clockwise; slowest is 0 where the swing stalls, and of the other sign where
        it turns back, which it does as fast as it turned before.
    duration
        s, of the half turn, or until a swing that turns back is fastest on its way.
    """

    alone: Suspension
    slowest: float
    fastest: float
    duration: float

    @property
    def stalls(self) -> bool:
        """Whether the turning stops, for good or to go back."""
        return self.slowest * self.fastest <= 0


@dataclass(frozen=True)
class Run:
    """What `RealMotion` gives: rates as in `HalfTurn`, largest |b|, m, and over what time, s."""

    slowest: float
    fastest: float
    widest: float
    duration: float


def by_anisotropy(case: Case, stiff: float, axis: float) -> HalfTurn:
    """From the first integral ψ'² = ψ'0² + (3/16) ω0 δ (a/l)² (cos 2(ψ0−χ) − cos 2(ψ−χ))."""
    start = -case.earth + 3 / 8 * case.omega * case.a * case.b / case.length**2
    size = 3 / 16 * case.omega * stiff * (case.a / case.length) ** 2
    offset = start**2 + size * math.cos(2 * (case.azimuth - axis))
    way = math.copysign(1.0, start)
    fastest = way * math.sqrt(max(offset + abs(size), 0.0))
    slowest = way * math.sqrt(offset - abs(size)) if offset > abs(size) else -fastest
    duration = _duration(case, start, size, axis)
    return HalfTurn(Suspension(stiff, axis), slowest, fastest, duration)


def _duration(case: Case, start: float, size: float, axis: float) -> float:
    """Until the swing has turned by half a turn, or has turned back and is fastest on its way, s.

    ψ'' = S sin 2(ψ−χ), which is the derivative of the first integral, in steps of velocity Verlet.
    """
    earth = math.pi / abs(case.earth)
    step = earth / _STEPS
    azimuth, rate = case.azimuth, start
    for k in range(round(_LONGEST * _STEPS)):
        pull = size * math.sin(2 * (azimuth - axis))
        azimuth += step * rate + step**2 / 2 * pull
        after = rate + step / 2 * (pull + size * math.sin(2 * (azimuth - axis)))
        back = rate * start < 0 and abs(after) < abs(rate)
        if back or abs(azimuth - case.azimuth) >= math.pi:
            return (k + 1) * step
        rate = after
    return _LONGEST * earth


def by_damping(case: Case, damping: float, axis: float) -> HalfTurn:
    """From ψ' = −Ω_z + (Δγ/2) sin 2(ψ−χd), for b = 0."""
    earth, size = abs(case.earth), abs(damping) / 2
    way = -math.copysign(1.0, case.earth)
    alone = Suspension(0.0, 0.0, damping, axis)
    if size >= earth:  # comes to rest, so half a turn of the Earth's is as good as any time
        return HalfTurn(alone, 0.0, way * (earth + size), math.pi / earth)
    duration = min(math.pi / math.sqrt(earth**2 - size**2), _LONGEST * math.pi / earth)
    return HalfTurn(alone, way * (earth - size), way * (earth + size), duration)


def half_turns(case: Case) -> list[HalfTurn]:
    """One for each of the suspension's anisotropies that is not zero."""
    if case.suspension is None or not case.earth:
        return []
    stiff, axis, damping, damping_axis = (float(value) for value in case.suspension.values)
    turns = [by_anisotropy(case, stiff, axis)] if stiff else []
    return [*turns, *([by_damping(case, damping, damping_axis)] if damping else [])]


def is_run(case: Case, turn: HalfTurn) -> bool:
    """Whether it is asked for and short enough."""
    return case.checked and turn.duration < _MOST_SWINGS * case.swing


def run(case: Case, turn: HalfTurn) -> Run | None:
    """Follow the full equations, with the Earth and the one cause, without a drive."""
    if not is_run(case, turn):
        return None
    # Uneven damping opens no ellipse, and one would turn by itself.
    b = case.b if turn.alone.anisotropy else 0.0
    launch = case.launch(b, turning=True)
    # As much drag as it takes that no direction gains energy; it leaves the turning as it is.
    drag = Drag(abs(float(turn.alone.damping_anisotropy)) / 2)
    motion = case.run(launch, site=True, drag=drag, suspension=turn.alone, fine=False)
    moments = np.linspace(0.0, turn.duration, MOMENTS)
    course = _measured.Course.of(motion, case.swing, moments, case.worked)
    way = math.copysign(1.0, turn.fastest)
    rates = np.sort(way * course.rates)
    slowest, fastest = way * float(rates[0]), way * float(rates[-1])
    return Run(slowest, fastest, float(course.inner.max()), turn.duration)
