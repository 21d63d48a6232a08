"""A careless simulation refutes a true theory.

How fast does the ellipse of a pendulum turn? Formula (25) says 3/8·ω0·ab/l². Whoever doubts it and
integrates the equations of motion with SciPy's default tolerances finds it wrong by 2 % after 100
swings, and by more the longer it takes. It is not: at this size it is good to 0.024 %, and the 2 %
are the integrator's.

    python careless_integration.py [FIGURE.png]
"""

import sys

import numpy as np
from matplotlib.figure import Figure
from scipy.integrate import solve_ivp

import kugelpendel as kp

PENDULUM = kp.Pendulum(length=1.0, gravity=1.0)  # lengths in l, times in 1/ω0
A, B = 0.05, 0.005  # displaced by A, pushed sideways with B·ω0
SWINGS = 100
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7)  # the first is SciPy's default

EXACT = kp.ExactMotion(PENDULUM, kp.Launch.ellipse(A, B))
FORMULA = kp.olsson.precession(A, B, PENDULUM.length, PENDULUM.gravity)


def law(t: float, state: np.ndarray) -> np.ndarray:
    """Gravity along z, which points down, and the thread's pull towards the support."""
    position, velocity = state[:3], state[3:]
    pull = (velocity @ velocity + PENDULUM.gravity * position[2]) / (position @ position)
    return np.concatenate([velocity, [0, 0, PENDULUM.gravity] - pull * position])


def at_outer_turning_point(t: float, state: np.ndarray) -> float:
    """Zero where the bob stops going outwards."""
    return state[:2] @ state[3:5]


at_outer_turning_point.direction = -1


def turned(**tolerances: float) -> tuple[np.ndarray, np.ndarray]:
    """Times of the outer turning points, s, and how far the ellipse has turned, rad."""
    start = np.concatenate([EXACT.position(0.0), EXACT.velocity(0.0)])
    end = (SWINGS + 0.25) * 2 * np.pi / EXACT.frequency
    found = solve_ivp(law, (0, end), start, events=at_outer_turning_point, **tolerances)
    x, y = found.y_events[0][:, :2].T
    return found.t_events[0], np.unwrap(np.arctan2(y, x), period=np.pi)


def precession(times: np.ndarray, azimuth: np.ndarray) -> float:
    """rad/s, between the first and the last turning point."""
    return (azimuth[-1] - azimuth[0]) / (times[-1] - times[0])


def draw(default: tuple[np.ndarray, np.ndarray], errors: dict[float, float]) -> Figure:
    figure = Figure(figsize=(11, 4.6), layout="constrained", dpi=130)
    left, right = figure.subplots(1, 2)

    times, azimuth = default
    swings = times * EXACT.frequency / (2 * np.pi)
    ahead = azimuth - EXACT.precession * times
    left.plot(swings, np.degrees(ahead), ".", color="#b8443a")
    left.annotate(
        "solve_ivp, defaults", (swings[-60], np.degrees(ahead[-60])), (-8, -12), ha="right",
        textcoords="offset points", color="#b8443a",
    )  # fmt: skip
    left.plot(swings, np.degrees((FORMULA - EXACT.precession) * times), color="#2a6f97")
    left.annotate(
        "formula (25)", (swings[-1], 0), (0, -16), ha="right", textcoords="offset points",
        color="#2a6f97",
    )  # fmt: skip
    all_in_all = np.degrees(EXACT.precession * times[-1])
    left.set(
        xlabel="swings",
        ylabel="ahead of the exact azimuth by (°)",
        title=f"An ellipse that turns by {all_in_all:.2f}° in {SWINGS} swings",
    )

    right.loglog(errors.keys(), 100 * np.array(list(errors.values())), "o-", color="#b8443a")
    formula = 100 * abs(FORMULA / EXACT.precession - 1)
    right.axhline(formula, linestyle="--", color="#2a6f97")
    right.annotate(
        f"formula (25): {formula:.2g} %",
        (TOLERANCES[-1], formula),
        (0, 5),
        textcoords="offset points",
    )
    default_error = 100 * errors[TOLERANCES[0]]
    right.annotate(
        f"SciPy's default: {default_error:.2g} %",
        (TOLERANCES[0], default_error),
        (-8, 4),
        textcoords="offset points",
        ha="right",
    )
    right.set(
        xlabel="relative tolerance of the integration",
        ylabel="error of the precession (%)",
        title="Whose error is it?",
    )
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    return figure


def main(path: str) -> dict[float, float]:
    """Print and draw, and give the error of the precession by tolerance."""
    print(f"exact             Ω = {EXACT.precession:.6e} ω0")
    print(f"formula (25)      {100 * (FORMULA / EXACT.precession - 1):+.3f} %")
    default, errors = turned(), {}
    for tolerance in TOLERANCES:
        first = tolerance == TOLERANCES[0]
        track = default if first else turned(rtol=tolerance, atol=1e-3 * tolerance)
        error = precession(*track) / EXACT.precession - 1
        errors[tolerance] = abs(error)
        name = "defaults" if first else f"rtol = {tolerance:g}"
        print(f"{name:<17} {100 * error:+.2g} %")
    draw(default, errors).savefig(path)
    print(f"In {path}: the figure")
    return errors


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "careless_integration.png")
