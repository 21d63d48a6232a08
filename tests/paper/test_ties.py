"""What is proved is what runs: the paper's equations hold along the exact motion.

Accelerations are differences of the exact velocities, of eighth order: with a step of 0.02/ω0 their
error is about 1e-12 of the largest one.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from sympy import Expr, lambdify

import kugelpendel as kp
from kugelpendel import paper
from kugelpendel.paper.algebra.symbols import (
    Omega,
    T,
    a,
    b,
    g,
    l,
    m,
    omega,
    omega0,
    phi,
    phid,
    phidd,
    rho,
    t,
    theta,
    thetad,
    thetadd,
    x,
    xd,
    xdd,
    y,
    yd,
    ydd,
)

LENGTH, GRAVITY, MASS = 1.3, 9.81, 0.7
OMEGA0 = np.sqrt(GRAVITY / LENGTH)
PENDULUM = kp.Pendulum(length=LENGTH, gravity=GRAVITY, mass=MASS)
STEP = 0.02 / OMEGA0
WEIGHTS = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
CONSTANTS = {l: LENGTH, g: GRAVITY, m: MASS, omega0: OMEGA0}


Letters = dict[Any, Any]  # a letter of the paper → its number or array


def number(expression: Expr, letters: Letters) -> Any:
    known = CONSTANTS | letters
    needed = sorted(expression.free_symbols, key=str)
    return lambdify(needed, expression, "numpy")(*(known[q] for q in needed))


def acceleration(motion: kp.ExactMotion, times: np.ndarray) -> np.ndarray:
    total = sum(
        w * (motion.velocity(times + k * STEP) - motion.velocity(times - k * STEP))
        for k, w in WEIGHTS.items()
    )
    return total / STEP


def state(motion: kp.ExactMotion, times: np.ndarray) -> Letters:
    """x, y, θ, φ, their first two rates and T, from positions and velocities."""
    px, py, pz = np.moveaxis(motion.position(times), -1, 0)
    vx, vy, vz = np.moveaxis(motion.velocity(times), -1, 0)
    ax, ay, az = np.moveaxis(acceleration(motion, times), -1, 0)
    distance = np.hypot(px, py)
    # z = l cos θ and φ = arg(x + iy), differentiated twice
    theta_rate = -vz / distance
    theta_push = -(az + pz * theta_rate**2) / distance
    swept, swept_rate = px * vy - py * vx, px * ay - py * ax
    phi_rate = swept / distance**2
    phi_push = swept_rate / distance**2 - 2 * swept * (px * vx + py * vy) / distance**4
    return {
        x: px, y: py, xd: vx, yd: vy, xdd: ax, ydd: ay, rho: distance,
        theta: np.arctan2(distance, pz), phi: np.arctan2(py, px), thetad: theta_rate,
        phid: phi_rate, thetadd: theta_push, phidd: phi_push, T: motion.tension(times),
    }  # fmt: skip


def random_states(highest: float, count: int = 40) -> Letters:
    """One state from each of many motions, from launches up to the angle `highest`."""
    rng = np.random.default_rng(12)
    launch = kp.Launch.angles(
        rng.uniform(0.3, highest, count),
        rng.uniform(-3, 3, count),
        rng.uniform(-1, 1, count) * OMEGA0 / 2,
        rng.uniform(0.2, 1, count) * OMEGA0,
    )
    motion = kp.ExactMotion(PENDULUM, launch)
    times = np.array([0.37])
    return {q: np.asarray(v)[..., 0] for q, v in state(motion, times).items()}


@pytest.mark.parametrize("label", ["5b", "5c", "8:2", "9:1", "9:2"])
def test_angles_and_angular_momentum(label: str) -> None:
    states = random_states(2.5)
    difference = paper.right(label).difference.doit()
    if difference.has(paper.right("8:2").lhs.func) and label == "8:2":
        difference = l**2 * paper.right("6.3").rhs  # d/dt carried out by 6.3
    assert np.abs(number(difference, states)).max() < 1e-9 * OMEGA0**2


def test_5a_is_the_tension() -> None:
    states = random_states(2.5)
    pull = number(paper.right("5a").rhs, states)
    assert np.allclose(pull, states[T], rtol=0, atol=1e-12 * MASS * GRAVITY)


@pytest.mark.parametrize("label", ["10", "10.9", "12"])
def test_exact_cartesian_equations_on_the_lower_half(label: str) -> None:
    states = random_states(1.2)
    below = np.cos(states[theta]) > 0.1  # the conditions: lower half, off the equator
    assert below.sum() > 20
    left = number(paper.right(label).lhs, states)[below]
    assert np.abs(left).max() < 1e-9 * LENGTH**2 * OMEGA0**2


def test_12_as_printed_is_not_what_runs() -> None:
    left = number(paper.printed("12").lhs, random_states(1.2))
    assert np.abs(left).max() > 0.1 * LENGTH * OMEGA0**2


def test_12_fails_on_the_upper_half_as_its_condition_says() -> None:
    states = random_states(2.9)
    above = np.cos(states[theta]) < -0.1
    assert above.any()
    left = number(paper.right("12").lhs, states)[above]
    expected = -2 * OMEGA0**2 * states[x][above] * np.cos(states[theta][above])
    assert np.allclose(left, expected, atol=1e-8 * LENGTH * OMEGA0**2)


def ellipse(size: float, ratio: float = 0.4) -> kp.ExactMotion:
    return kp.ExactMotion(PENDULUM, kp.Launch.apsides(size * LENGTH, ratio * size * LENGTH))


@pytest.mark.parametrize("label", ["13a", "13b"])
def test_13_lacks_what_its_remainder_says(label: str) -> None:
    (lacking,) = (one for one in paper.remainders() if one.label == label)
    times = np.linspace(0.1, 5, 30)
    rests = []
    for size in (0.1, 0.05):
        states = state(ellipse(size), times)
        left = number(paper.right(label).lhs, states)
        expected = -number(lacking.term, states)
        assert np.abs(left - expected).max() < 2 * size**2 * np.abs(expected).max()
        rests.append(np.abs(left).max())
    assert np.log2(rests[0] / rests[1]) == pytest.approx(5, abs=0.05)


def test_16_is_the_motion_of_a_very_small_ellipse() -> None:
    """What (16) lacks grows like ω0 t a²/16l²: 4e-11 of a here."""
    wide, narrow = 1e-5 * LENGTH, 4e-6 * LENGTH
    motion = kp.ExactMotion(PENDULUM, kp.Launch.ellipse(wide, narrow))
    times = np.linspace(0, 2, 20)
    letters = {a: wide, b: narrow, t: times}
    for k, q in enumerate("xy"):
        found = number(paper.right(f"16:{q}").rhs, letters)
        assert np.allclose(motion.position(times)[:, k], found, rtol=0, atol=2e-10 * wide)


def in_turning_frame(motion: kp.ExactMotion, size: float) -> Letters:
    spectrum = motion.spectrum(2)
    first = {k: np.abs(spectrum.amplitude[spectrum.order == k])[0] for k in (-1, 1)}
    return {
        a: first[1] + first[-1], b: first[1] - first[-1],
        omega: motion.frequency, Omega: motion.precession,
    }  # fmt: skip


def test_20_is_the_first_harmonics_of_the_exact_motion() -> None:
    """Left over are the third harmonics, 3(a² − b²)/64 l² of a to leading order."""
    times = np.linspace(0, 30, 200)
    for size in (0.2, 0.1):
        motion = ellipse(size)
        letters = in_turning_frame(motion, size) | {t: times}
        third = number(paper.third_harmonic(), letters)
        found = number(paper.right("20:x").rhs, letters)
        rest = motion.position(times)[:, 0] - found
        assert np.abs(rest).max() < 0.07 * size**3 * LENGTH
        assert np.abs(rest - third).max() < size**2 * np.abs(third).max()


def test_third_harmonics_are_those_of_the_spectrum() -> None:
    size = 0.05
    spectrum = ellipse(size).spectrum(2)
    letters = in_turning_frame(ellipse(size), size)
    share = -3 / 64 * (letters[a] ** 2 - letters[b] ** 2) / LENGTH**2
    for order, axis in ((3, letters[a] + letters[b]), (-3, letters[a] - letters[b])):
        amplitude = spectrum.amplitude[spectrum.order == order][0]
        expected = share * axis / 2
        # relative to the first harmonics' sign at t = 0
        sign = np.sign(spectrum.amplitude[spectrum.order == 1][0].real)
        assert amplitude.real * sign == pytest.approx(expected, rel=2 * size**2)


RUNNING: list[tuple[str, Callable[..., Any], int]] = [
    ("25", kp.olsson.precession, 1),
    ("26", kp.olsson.frequency, 2),
]


@pytest.mark.parametrize(("label", "runs", "power"), RUNNING)
def test_25_and_26_are_what_the_library_computes(
    label: str, runs: Callable[..., Any], power: int
) -> None:
    rng = np.random.default_rng(3)
    axes = {a: rng.uniform(-1, 1, 50) * LENGTH, b: rng.uniform(-1, 1, 50) * LENGTH}
    found = np.asarray(runs(axes[a], axes[b], LENGTH, GRAVITY)) ** power
    assert np.allclose(found, number(paper.right(label).rhs, axes), rtol=2e-15)


@pytest.mark.parametrize("ratio", [0.05, 0.4, 0.9, -0.4])
def test_25_and_26_are_the_exact_motion_to_leading_order(ratio: float) -> None:
    """(25) is low by (7/32)(a² + b²)/l²; what (26) lacks is of fourth order."""
    gaps = []
    for size in (0.02, 0.01):
        motion = ellipse(size, ratio)
        letters = {a: size * LENGTH, b: ratio * size * LENGTH}
        turning = number(paper.right("25").rhs, letters)
        square = number(paper.right("26").rhs, letters)
        low = motion.precession / turning - 1
        assert low == pytest.approx(7 / 32 * size**2 * (1 + ratio**2), rel=20 * size**2)
        gaps.append(motion.frequency**2 - square)
    assert np.log2(abs(gaps[0] / gaps[1])) == pytest.approx(4, abs=0.01)


def test_the_circle_and_the_line_are_limits_of_25_and_26() -> None:
    size = 0.02
    cone = kp.ExactMotion(PENDULUM, kp.Launch.apsides(size * LENGTH, size * LENGTH))
    exact = np.sqrt(GRAVITY / (LENGTH * np.sqrt(1 - size**2)))
    letters = {a: size * LENGTH, b: size * LENGTH}
    both = number(paper.right("25").rhs, letters) + np.sqrt(number(paper.right("26").rhs, letters))
    assert cone.frequency + cone.precession == pytest.approx(exact, rel=1e-14)
    assert both == pytest.approx(exact, rel=size**4)
    line = kp.ExactMotion(PENDULUM, kp.Launch.at_rest(size))
    letters = {a: np.sin(size) * LENGTH, b: 0.0}
    assert line.precession == 0 == number(paper.right("25").rhs, letters)
    assert line.frequency**2 == pytest.approx(number(paper.right("26").rhs, letters), rel=size**4)


@pytest.mark.parametrize(
    ("label", "make"),
    [("12", kp.PlaneMotion), ("13a", kp.CubicMotion), ("13b", kp.CubicMotion)],
)
def test_integrated_motions_run_on_the_proved_equations(label: str, make: Any) -> None:
    """Acceleration from differences of the motion's own velocity, as above."""
    rng = np.random.default_rng(5)
    for _ in range(20):
        place, speed = rng.uniform(-0.4, 0.4, 2), rng.uniform(-0.5, 0.5, 2)
        launch = kp.Launch.plane(*(place * LENGTH), *(speed * LENGTH * OMEGA0))
        left = number(paper.right(label).lhs, state_of_plan(make(PENDULUM, launch)))
        assert np.abs(left).max() < 1e-9 * LENGTH * OMEGA0**2


def state_of_plan(motion: Any) -> Letters:
    times = np.array([0.0])
    px, py, _ = np.moveaxis(motion.position(times), -1, 0)
    vx, vy, _ = np.moveaxis(motion.velocity(times), -1, 0)
    ax, ay, _ = np.moveaxis(acceleration(motion, times), -1, 0)
    return {x: px, y: py, xd: vx, yd: vy, xdd: ax, ydd: ay, rho: np.hypot(px, py)}


@pytest.mark.parametrize(("label", "make"), [("16", kp.LinearMotion), ("20", kp.OlssonMotion)])
def test_figures_run_on_the_proved_solutions(label: str, make: Any) -> None:
    wide, narrow = 0.2 * LENGTH, -0.08 * LENGTH
    motion = make(PENDULUM, kp.Launch.apsides(wide, narrow))
    times = np.linspace(0, 30, 200)
    letters = {a: wide, b: narrow, t: times, omega: motion.frequency, Omega: motion.precession}
    for k, q in enumerate("xy"):
        found = number(paper.right(f"{label}:{q}").rhs, letters)
        assert np.allclose(motion.position(times)[:, k], found, rtol=0, atol=4e-15 * LENGTH)
