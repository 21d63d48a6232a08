"""Random pendulums with a known truth, and what a perfect fit of their tracks could reach."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import kugelpendel as kp
from kugelpendel.tracks.fitting._model import FORCES, SHAPE
from kugelpendel.tracks.fitting._problem import measured_of

DURATION, RATE, JITTER, NOISE = 1200.0, 10.0, 0.2, 0.005
"""s, points a second, share of the step, share of a."""

NAMES = (*SHAPE, *FORCES)


@dataclass(frozen=True)
class Case:
    """A pendulum, and what it does."""

    motion: kp.RealMotion
    truth: dict[str, float]
    noise: float
    gravity: float


def pendulum(seed: int, *, damping_anisotropy: float = 0.0, tolerance: float = 1e-17) -> Case:
    """One pendulum of the study.

    1.5 to 30 m, a/l 0.02 to 0.08, |b|/a up to 0.15, 5 to 50 % lost within the track to linear and
    quadratic drag in random shares, δ/ω0 from 5e-6 to 2e-4, random axes and latitude.

    damping_anisotropy: largest Δγ, as a share of γ; tolerance: of `RealMotion`.
    """
    random = np.random.default_rng([2026, seed])
    gravity = 9.81
    length = float(np.exp(random.uniform(np.log(1.5), np.log(30.0))))
    omega0 = float(np.sqrt(gravity / length))
    a = length * random.uniform(0.02, 0.08)
    b = a * random.uniform(-0.15, 0.15)
    lost = -np.log(1 - random.uniform(0.05, 0.5)) / DURATION
    share = random.uniform(0, 1)
    linear, quadratic = share * lost, (1 - share) * lost * 3 * np.pi / (4 * omega0 * a)
    delta = omega0 * float(np.exp(random.uniform(np.log(5e-6), np.log(2e-4))))
    axis, azimuth = random.uniform(0, np.pi, 2)
    latitude = random.uniform(-1.4, 1.4)
    uneven = damping_anisotropy * random.uniform(0, 1) * lost
    lossy = random.uniform(0, np.pi)
    site = kp.Site(latitude)
    motion = kp.RealMotion(
        kp.Pendulum(length, gravity),
        kp.Launch.ellipse(a, b, azimuth),
        site=site,
        drag=kp.Drag(linear, quadratic),
        suspension=kp.Suspension(delta, axis, uneven, lossy),
        tolerance=tolerance,
    )
    truth = {
        "rotation": float(site.vertical_rotation),
        "linear": linear,
        "quadratic": quadratic,
        "anisotropy_cos": delta * np.cos(2 * axis),
        "anisotropy_sin": delta * np.sin(2 * axis),
        "damping_anisotropy_cos": uneven * np.cos(2 * lossy),
        "damping_anisotropy_sin": uneven * np.sin(2 * lossy),
    }
    return Case(motion, truth, NOISE * a, gravity)


def shape(case: Case, time: float) -> dict[str, float]:
    """Turning radii and azimuth of the real motion near a time: six swings, cubic amplitudes.

    Not from the averaged motion, whose own error would be counted as the fit's.
    """
    length = float(case.motion.pendulum.length)
    omega0 = float(case.motion.angular_frequency)
    times = time + np.linspace(-3, 3, 601) * 2 * np.pi / omega0
    place = case.motion.position(times)
    z, tau = place[:, 0] + 1j * place[:, 1], (times - time) / (times[-1] - time)

    def basis(omega: float) -> np.ndarray:
        turn = np.exp(1j * omega * (times - time))
        slow = [tau**k for k in range(4)]
        circles = [way * one for one in slow for way in (turn, turn.conj())]
        bent = [turn**3 * one for one in slow[:2]] + [turn.conj() ** 3 * one for one in slow[:2]]
        return np.stack([*circles, *bent, *slow[:2]], axis=1)

    omega = omega0
    for _ in range(4):
        found = np.linalg.lstsq(basis(omega), z, rcond=None)[0]
        omega += 0.5 * float((found[2] / found[0] - found[3] / found[1]).imag) / (times[-1] - time)
    p, q = np.abs(found[:2])
    more = (3 / 64) * ((p + q) ** 2 - (p - q) ** 2) / length**2
    azimuth = 0.5 * float(np.angle(found[0] * found[1]))
    return {"a": (p + q) / (1 + more), "b": (p - q) / (1 - more), "azimuth": azimuth}


def level(colour: object, noise: float, omega: float, rate: float = RATE) -> float:
    """The true spectrum of the noise of x + iy at a frequency, as variance per point."""
    step = 1 / rate
    white = 2 * noise**2

    def coloured(memory: float) -> float:
        return white * (1 - memory**2) / abs(1 - memory * np.exp(-1j * omega * step)) ** 2

    if colour == "slow":
        return 0.5 * white + 0.5 * coloured(float(np.exp(-step / 60)))
    return coloured(float(colour)) if isinstance(colour, float) else white


def bounds(ellipses: object, truth: dict[str, float], spectrum: float) -> dict[str, float]:
    """Cramér–Rao bounds: every point counts fully, and the spectrum is the true one.

    Of the kept points of a window 1/n is the least variance of a circle, whatever the slopes and
    harmonics; a, b and ψ of a window then have the information that its points have.
    """
    changed = ellipses.copy(deep=True)  # type: ignore[attr-defined]
    points = changed["points"].values
    a, b = changed["a"].values, changed["b"].values
    p, q = 0.5 * (a + b), 0.5 * (a - b)
    covariance = np.zeros((len(a), 6, 6))
    covariance[:, 0, 0] = covariance[:, 1, 1] = spectrum / points
    covariance[:, 2, 2] = spectrum / points * (1 / p**2 + 1 / q**2) / 8
    changed["covariance"].values[:] = covariance
    measured, _ = measured_of(changed, len(a) // 2, None, 9.81, True)
    row = measured.row(truth)
    steps = measured.steps()[: len(NAMES)]
    rows = np.tile(row, (len(NAMES) + 1, 1))
    rows[1 + np.arange(len(NAMES)), np.arange(len(NAMES))] += steps
    white = measured.whitened(measured.differences(measured.predicted(rows)))
    slopes = ((white[1:] - white[0]) / steps[:, None]).T
    errors = np.sqrt(np.diag(np.linalg.inv(slopes.T @ slopes)))
    return dict(zip(NAMES, errors.tolist(), strict=True))
