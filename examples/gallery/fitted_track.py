"""A narrow error bar that is wrong.

A camera looks at a pendulum not quite straight down, so that one scale of its picture is 1.5 %
short. Nothing in the residuals shows it: χ² is as it should be. Whoever fits without thinking of
the camera finds the amplitude with an error bar that excludes the truth many times over. The
headline of `kugelpendel.tracks.fit` allows for a tilt of a stated size, and covers the truth.

    python fitted_track.py [FIGURE.png]
"""

import sys

import numpy as np

import kugelpendel as kp
from kugelpendel import plot

TILT = 0.015
MOTION = kp.RealMotion(
    kp.Pendulum(length=2.0),
    kp.Launch.apsides(0.15, 0.01, azimuth=0.35),
    site=kp.Site(np.radians(50)),
    drag=kp.Drag(1e-4),
)


def main(figure: str = "fitted_track.png") -> dict[str, float]:
    """Print by how many of its errors each fit misses the amplitude, and draw the track."""
    track = kp.tracks.synthesise(MOTION, 900.0, 10.0, noise=5e-4, tilt=TILT, tilt_axis=0.35, seed=1)
    ellipses = kp.tracks.ellipses(track)
    found = kp.tracks.fit(ellipses, length=2.0)
    averaged = kp.EnvelopeMotion(MOTION.pendulum, MOTION.launch, MOTION.forces)
    true = float(averaged.semi_axes(found.time)[0])
    print(f"χ²/ndof           {found.misfit.ratio:.2f}")
    missed: dict[str, float] = {}
    for name in ("narrow", "headline"):
        a = found.models[name].parameters["a"]
        missed[name] = abs(a.value - true) / a.stderr
        said = f"a = {1e3 * a.value:.2f} ± {1e3 * a.stderr:.2f} mm"
        print(f"{name:<18}{said}, {missed[name]:.1f} errors off")
    print(f"{'truth':<18}a = {1e3 * true:.2f} mm")
    plot.save(plot.tracks.course(ellipses, found.headline), figure)
    return missed | {"ratio": found.misfit.ratio}


if __name__ == "__main__":
    main(*sys.argv[1:])
