"""Whether the plane goes round in an uneven clamp: the portrait beside motions that are followed.

    python benchmarks/portrait.py        random pendulums, each against the averaged motion,
                                         and every thirtieth against the full equations

Drawn at random, from a fixed seed: lengths from 0.5 to 70 m, latitudes of both hemispheres, |δ|
from 0.03 to 10 times |Ω_z| and of both signs, a/l from 1e-3 to 0.13, |b| up to 0.3 a, all azimuths.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

import kugelpendel as kp

COUNT = 450
SOME = 30
SEED = 20260101
EARTH = 7.292115e-5


@dataclass(frozen=True)
class Drawn:
    """One pendulum in its clamp, and the portrait of its launch."""

    pendulum: kp.Pendulum
    site: kp.Site
    suspension: kp.Suspension
    launch: kp.Launch
    portrait: kp.Portrait


def draw(random: np.random.Generator) -> Drawn:
    length = random.uniform(0.5, 70.0)
    site = kp.Site(random.uniform(-1.5, 1.5))
    earth = float(site.vertical_rotation)
    size = abs(earth) * 10 ** random.uniform(math.log10(0.03), 1.0)
    suspension = kp.Suspension(size * random.choice([-1.0, 1.0]), random.uniform(-1.5, 1.5))
    a = length * 10 ** random.uniform(-3.0, math.log10(0.13))
    b, azimuth = a * random.uniform(-0.3, 0.3), random.uniform(-1.5, 1.5)
    pendulum = kp.Pendulum(length, site.gravity)
    # With the speed against the floor that gives this ellipse in a frame that does not turn.
    still = kp.ExactMotion(pendulum, kp.Launch.apsides(a, b, azimuth))
    x, y, _ = still.position(0.0)
    vx, vy, _ = still.velocity(0.0)
    launch = kp.Launch.plane(x, y, vx + earth * y, vy - earth * x)
    portrait = kp.Portrait(pendulum, a, b, azimuth, kp.Forces(site=site, suspension=suspension))
    return Drawn(pendulum, site, suspension, launch, portrait)


def followed(drawn: Drawn, *, full: bool) -> tuple[bool, float]:
    """Whether the plane goes round, and its mean rate, over four times round the orbit."""
    given = (drawn.pendulum, drawn.launch)
    acting = {"site": drawn.site, "suspension": drawn.suspension}
    times = np.linspace(0.0, 4 * drawn.portrait.orbit.period, 4001)
    if full:
        motion = kp.RealMotion(*given, **acting, thread="rod", tolerance=1e-12)
        _, _, azimuth = kp.ellipse(motion, times)
    else:
        azimuth = kp.EnvelopeMotion(*given, **acting).azimuth(times)
    turned = float(azimuth[-1] - azimuth[0])
    return abs(turned) > 2 * math.pi, turned / float(times[-1])


def main() -> None:
    random = np.random.default_rng(SEED)
    counts = dict.fromkeys(("round", "to and fro", "stands"), 0)
    agree = {False: 0, True: 0}
    asked = {False: 0, True: 0}
    apart: dict[bool, list[float]] = {False: [], True: []}
    for index in range(COUNT):
        drawn = draw(random)
        orbit = drawn.portrait.orbit
        counts[orbit.verdict] += 1
        swings = 4 * orbit.period / (2 * math.pi) * float(drawn.pendulum.angular_frequency)
        for full in (False, True):
            if full and (index % SOME or swings > 2e5):
                continue
            goes, rate = followed(drawn, full=full)
            same = goes == (orbit.verdict == "round")
            asked[full] += 1
            agree[full] += same
            if same:
                off = abs(rate - orbit.rate) / abs(float(drawn.site.vertical_rotation))
                apart[full].append(off)
            else:
                print(drawn.portrait, orbit, rate)
    print(f"{COUNT} pendulums, seed {SEED}: {counts}")
    for full, name in ((False, "averaged motion has"), (True, "full equations have")):
        print(f"as the {name} it: {agree[full]} of {asked[full]}; "
              f"mean rates within {np.quantile(apart[full], 0.99):.1e} |Ω_z| in 99 of 100, "
              f"{max(apart[full]):.1e} at most")  # fmt: skip


if __name__ == "__main__":
    main()
