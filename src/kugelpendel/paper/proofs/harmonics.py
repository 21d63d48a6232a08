"""The exact equation (12) with an ellipse and its third harmonics, balanced in numbers."""

from __future__ import annotations

from functools import cache
from random import Random

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.sympy_names import mp, mpc, mpf
from kugelpendel.paper.proofs.worlds import DIGITS, Number, World, circles, draw

_BEATS = 16  # sums over so many phases are exact for harmonics that no order asked for reaches
_ROUNDS = 8


@cache
def harmonic(seed: int, exponent: int) -> World:
    """An ellipse of the size ε = 10^−exponent, its semi-axes those of the first harmonics.

    Its third harmonics and both frequencies are found by balancing them in (12); a fifth harmonic
    would change the frequencies in the eighth order only.
    """
    rng = Random(f"harmonic {seed}")
    with mp.workdps(DIGITS + 8 * exponent):
        eps = mpf(10) ** (-exponent)
        wide, narrow = eps * draw(rng, 0.8, 1.4), eps * draw(rng, 0.2, 0.6) * rng.choice((1, -1))
        swing, turning = _balanced({1: (wide + narrow) / 2, -1: (wide - narrow) / 2})
        length, rate = draw(rng, 0.7, 1.5), draw(rng, 1, 3)
        constants = {
            s.l: length, s.omega0: rate, s.a: wide * length, s.b: narrow * length,
            s.omega: swing * rate, s.Omega: turning * rate, s.rho: draw(rng, 0.1, 0.2),
        }  # fmt: skip
        return World({**constants, **circles(constants)}, {})


def _balanced(waves: dict[int, Number]) -> tuple[Number, Number]:
    """ω and Ω, with l and ω0 as units, for the first harmonics; each round is ε² nearer."""
    waves = {**waves, 3: mpf(0), -3: mpf(0)}
    swing, turning = mpf(1), mpf(0)
    for _ in range(_ROUNDS):
        driven = _driven(waves, swing, turning)
        forward, backward = (mp.sqrt(driven[k] / waves[k]) for k in (1, -1))
        swing, turning = (forward + backward) / 2, (forward - backward) / 2
        for k in (3, -3):
            waves[k] = (driven[k] - waves[k]) / ((turning + k * swing) ** 2 - 1)
    return swing, turning


def _driven(waves: dict[int, Number], swing: Number, turning: Number) -> dict[int, Number]:
    """The harmonics of what (12) has besides the acceleration."""
    found = dict.fromkeys(waves, mpf(0))
    for beat in range(_BEATS):
        phase = 2 * mp.pi * beat / _BEATS
        turns = {k: mp.expj(k * phase) for k in waves}
        place = sum(size * turns[k] for k, size in waves.items())
        speed = sum(mpc(0, turning + k * swing) * size * turns[k] for k, size in waves.items())
        outward = (mp.conj(place) * speed).real
        below = 1 - abs(place) ** 2
        force = place * (outward**2 / below + abs(speed) ** 2 + mp.sqrt(below))
        for k in waves:
            found[k] += (force * mp.conj(turns[k])).real / _BEATS
    return found
