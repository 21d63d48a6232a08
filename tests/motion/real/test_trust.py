"""What `EnvelopeMotion.trust` says of itself holds at the edges: mixtures of all that acts."""

from __future__ import annotations

import math
import re
import warnings

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.observables import osculating_ellipse

HOUR = 3600.0
WIDE = 0.6
"""Of b in a: beyond, an ellipse is next to a circle, and its azimuth means little."""


def drawn(seed: int) -> tuple[kp.Pendulum, kp.Launch, kp.Forces]:
    """A pendulum with up to four of what can act, each by the share of a swing that it changes."""
    random = np.random.default_rng(seed)
    pendulum = kp.Pendulum(random.uniform(0.5, 30.0), 9.81)
    omega0 = float(pendulum.angular_frequency)
    amplitude = random.choice([0.05, 0.2, 0.5, 0.7, 0.9]) * random.uniform(0.9, 1.0)
    a = amplitude * float(pendulum.length)
    names = ["site", "linear", "quadratic", "stiff", "lossy", "drive"]
    acting = set(random.choice(names, size=random.integers(1, 5), replace=False))
    share = {name: 10.0 ** random.uniform(-7.0, -3.5) * (name in acting) for name in names}
    lossy = share["lossy"] * omega0
    # Drag enough that no direction gains energy.
    linear, quadratic = share["linear"] * omega0 + lossy / 2, share["quadratic"] / a
    stiff = share["stiff"] * omega0 * random.choice([-1.0, 1.0])
    axes = random.uniform(-1.5, 1.5, 2)
    phase = random.uniform(0.05, 1.2)
    decay = linear + 4 / (3 * math.pi) * quadratic * omega0 * a
    push = math.pi * a * decay / math.cos(phase)
    forces = kp.Forces(
        site=kp.Site(random.uniform(-1.5, 1.5)) if "site" in acting else None,
        drag=kp.Drag(linear, quadratic) if decay else None,
        suspension=kp.Suspension(stiff, axes[0], lossy, axes[1]) if stiff or lossy else None,
        drive=kp.Drive(push, phase=phase) if "drive" in acting and decay else None,
    )
    b = a * random.uniform(-0.4, 0.4)
    return pendulum, kp.Launch.ellipse(a, b, random.uniform(-1.5, 1.5)), forces


def averaged(pendulum: kp.Pendulum, launch: kp.Launch, forces: kp.Forces) -> kp.EnvelopeMotion:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return kp.EnvelopeMotion(pendulum, launch, forces)


@pytest.mark.parametrize("duration", [HOUR, 6 * HOUR])
@pytest.mark.parametrize("seed", range(30))
def test_the_bound_holds(seed: int, duration: float) -> None:
    pendulum, launch, forces = drawn(seed)
    mean = averaged(pendulum, launch, forces)
    full = kp.RealMotion(pendulum, launch, forces, thread="rod")
    swing = 2 * math.pi / float(pendulum.angular_frequency)
    starts = np.linspace(0.0, duration - 2 * swing, 12)
    times = np.concatenate([full.events("outer", at, at + 1.2 * swing) for at in starts])
    a, b = mean.semi_axes(times).T
    if (np.abs(b) > WIDE * a).any():
        pytest.xfail("The ellipse comes next to a circle, which trust excludes.")
    _, _, azimuth = osculating_ellipse(
        full.position(times), full.velocity(times), pendulum, full.rotation, times
    )
    off = np.angle(np.exp(2j * (azimuth - mean.azimuth(times)))) / 2
    off = np.abs(np.unwrap(off, period=math.pi)).max()
    assert off < mean._motions.azimuth_error(duration) + 1e-8


def test_says_how_far_the_azimuth_is_off_over_a_day() -> None:
    for seed in range(30):
        mean = averaged(*drawn(seed))
        said = re.search(r"azimuth is within (\S+)° over 24 h", mean.trust)
        if said is None:
            assert "without forces, exact" in mean.trust
            continue
        bound = math.degrees(mean._motions.azimuth_error(24 * HOUR))
        assert float(said[1]) == pytest.approx(bound, rel=0.06)


def test_warns_where_the_azimuth_may_be_far_off() -> None:
    pendulum, site = kp.Pendulum(20.0, 9.81), kp.Site(math.radians(49))
    with pytest.warns(UserWarning, match=r"may be off by \d+° within 24 h\. Use RealMotion, or sm"):
        kp.EnvelopeMotion(pendulum, kp.Launch.ellipse(18.0, 0.0), site=site)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        kp.EnvelopeMotion(pendulum, kp.Launch.ellipse(8.0, 0.0), site=site)


def test_there_is_one_warning() -> None:
    pendulum, site = kp.Pendulum(20.0, 9.81), kp.Site(math.radians(49))
    strong = kp.Suspension(0.03)
    with pytest.warns(UserWarning, match="changes a swing by") as caught:
        kp.EnvelopeMotion(pendulum, kp.Launch.ellipse(18.0, 3.0), site=site, suspension=strong)
    assert len(caught) == 1
