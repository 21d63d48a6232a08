"""What (13) alone says about its rates: on its paths, and by quadrature of its first integral."""

import runpy
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.observables import measured_rates

UNIT = kp.Pendulum(1.0, 1.0)
_POINTS = 400


@pytest.fixture(scope="module")
def page(repository: Path) -> dict:
    return runpy.run_path(str(repository / "docs/scripts/motions.py"))


def by_quadrature(a: float, b: float) -> tuple[Any, Any]:
    """ω and Ω of (13) between the turning radii a, b.

    (13) is central, and with s = x² + y² the chain rule gives d(v²)/ds = −v² − 1 + s/2, solved by
    v² = C e^(−s) + s/2 − 3/2. Then ṡ² = 4(s v² − λ²), λ² = s v² at both turning points.
    """
    s, u = mp.mpf(a) ** 2, mp.mpf(b) ** 2
    constant = (mp.mpf(3) / 2 * (s - u) - (s * s - u * u) / 2) / (s * mp.exp(-s) - u * mp.exp(-u))
    momentum = s * (constant * mp.exp(-s) + s / 2 - mp.mpf(3) / 2)

    def stay(angle: Any) -> tuple[Any, Any]:
        here = (s + u) / 2 + (s - u) / 2 * mp.cos(angle)
        square = 4 * (here * (constant * mp.exp(-here) + here / 2 - mp.mpf(3) / 2) - momentum)
        return (s - u) / 2 * mp.sin(angle) / mp.sqrt(square), here

    # The midpoint rule of a periodic analytic function converges like a power of a²: 60 digits.
    parts = [stay(mp.pi * (k + mp.mpf(1) / 2) / _POINTS) for k in range(_POINTS)]
    period = 2 * mp.pi / _POINTS * sum(time for time, _ in parts)
    angle = 2 * mp.pi / _POINTS * sum(mp.sqrt(momentum) * time / here for time, here in parts)
    return mp.pi / period, (angle - mp.pi) / period


@pytest.mark.parametrize(("a", "b"), [(0.3, 0.1), (0.1, 0.05), (0.05, 0.005)])
def test_paths_have_the_rates_of_the_first_integral(page: dict, a: float, b: float) -> None:
    motion = kp.CubicMotion(UNIT, page["own_launch"](a, b))
    found = measured_rates(motion, np.pi)
    with mp.workdps(40):
        frequency, precession = by_quadrature(a, b)
    assert found.frequency == pytest.approx(float(frequency), rel=1e-13)
    # 1e-13 of noise in the azimuths, over the angle turned in 64 half swings.
    assert found.precession == pytest.approx(float(precession), rel=1e-13 / (a * b))


def test_fractions_of_the_page() -> None:
    with mp.workdps(50):
        for ratio in (0.25, 0.5):
            a, squares = mp.mpf("1e-4"), 1 + mp.mpf(ratio) ** 2
            frequency, precession = by_quadrature(a, a * ratio)
            d = (precession / (mp.mpf(3) / 8 * a * a * ratio) - 1) / (a * a * squares)
            assert abs(d - mp.mpf(13) / 96) < 1e-8
            fourth = (frequency - 1 + a * a * squares / 16) / a**4
            expected = -mp.mpf(45) / 1024 * (1 + mp.mpf(ratio) ** 4) + mp.mpf(105) / 512 * ratio**2
            assert abs(fourth - expected) < 1e-8


def test_page_is_what_is_measured(page: dict, repository: Path) -> None:
    stored = (repository / "docs/motions.md").read_text(encoding="utf-8")
    assert page["written"](stored) == stored


def test_percentage_of_the_page() -> None:
    assert round(100 * (13 / 96) / (7 / 32)) == 62
