"""The page and Python stand on one core: the same launches in both, compared."""

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.cli.explore.cases import Given, drawn, spoken, under_forces

import kugelpendel as kp

Numbers = NDArray[np.float64]
SWINGS = np.array([0.0, 0.013, 0.5, 1.0, 2.71, 9.99, 10.0, 37.3, 99.5, 100.0])
FIRST_TEN = SWINGS <= 10

LAWS: dict[str, Callable[[kp.Pendulum, kp.Launch, kp.Forces], kp.Motion]] = {
    "exact": lambda pendulum, launch, _: kp.ExactMotion(pendulum, launch),
    "linear": lambda pendulum, launch, _: kp.LinearMotion(pendulum, launch),
    "ellipse": lambda pendulum, launch, _: kp.OlssonMotion(pendulum, launch),
    "cubic": lambda pendulum, launch, _: kp.CubicMotion(pendulum, launch),
    "averaged": kp.EnvelopeMotion,
    "real": kp.RealMotion,
    "rod": lambda *given: kp.RealMotion(*given, thread="rod"),
}

ASK = """
return given.cases.map((one, index) => {
  try {
    const motion = core.motion(one, given.law);
    const positions = Array.from(motion.positions(Float64Array.from(given.times[index])));
    motion.free();
    return { positions };
  } catch (error) {
    return { refused: error.kind, seen: error.seen };
  }
});
"""


def in_python(case: Given, law: str, times: Numbers) -> tuple[Numbers | None, str]:
    """Positions in m, NaN beyond an end, or the kind of what is refused."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter(
                "ignore", UserWarning
            )  # how far an average holds is not asked here
            motion = LAWS[law](*spoken(case))
    except kp.InvalidInput as error:
        return None, error.kind
    positions = np.full((times.size, 3), np.nan)
    try:
        positions[:] = motion.position(times)
    except kp.MotionEnded as end:
        before = times <= end.time
        positions[before] = motion.position(times[before])
    return positions, ""


def is_steep(case: Given, law: str) -> bool:
    """Whether any two roundings part by more than a hundred times within these swings.

    A rod does so where it all but stands upright, the averages where swings come close to the
    level of the support.
    """
    pendulum, launch, _ = spoken(case)
    motion = kp.ExactMotion(pendulum, launch)
    if law == "averaged":
        return float(motion.turning_radii[0] / pendulum.length) > 0.95
    return law == "rod" and kp.IdealSummary.of(motion).largest_angle > 2.8


@pytest.fixture(scope="module")
def cases() -> list[Given]:
    return drawn()


@pytest.fixture(scope="module")
def swings(cases: list[Given]) -> Numbers:
    """The period of each, s; that of small swings on the separatrix."""
    periods = []
    for case in cases:
        pendulum, launch, _ = spoken(case)
        frequency = float(kp.ExactMotion(pendulum, launch).frequency)
        periods.append(2 * np.pi / (frequency or float(pendulum.angular_frequency)))
    return np.array(periods)


def test_the_rates_are_the_same_to_the_last_digits(engine: Any, cases: list[Given]) -> None:
    script = (
        "return given.map((one) => { const s = core.summary(one); "
        "return [s.frequency, s.precession]; });"
    )
    found = np.array(engine(script, cases))
    motions = [kp.ExactMotion(*spoken(case)[:2]) for case in cases]
    wanted = np.array([[float(m.frequency), float(m.precession)] for m in motions])
    assert len(cases) >= 200
    units = np.abs(found - wanted) / np.spacing(np.abs(wanted))
    assert units.max() <= 2, cases[int(units.max(axis=1).argmax())]


@pytest.mark.parametrize(
    ("law", "ten", "hundred"),
    [
        ("exact", 1e-14, 1e-14),
        ("linear", 1e-14, 1e-14),
        ("ellipse", 1e-14, 1e-14),
        ("cubic", 1e-12, 2e-11),
        ("averaged", 1e-12, 2e-11),
        ("real", 1e-12, 2e-11),
        ("rod", 1e-12, 2e-11),
    ],
)
def test_the_bob_is_at_the_same_place(
    engine: Any, cases: list[Given], swings: Numbers, law: str, ten: float, hundred: float
) -> None:
    acted = under_forces(cases) if law in ("averaged", "real", "rod") else cases
    times = swings[:, np.newaxis] * SWINGS
    found = engine(ASK, {"cases": acted, "law": law, "times": times.tolist()})
    compared = 0
    for case, moments, one in zip(acted, times, found, strict=True):
        wanted, kind = in_python(case, law, moments)
        assert one.get("refused", "") == kind, case
        if wanted is None or is_steep(case, law):
            continue
        positions = np.array(one["positions"], dtype=float).reshape(-1, 3)
        assert (np.isnan(positions) == np.isnan(wanted)).all(), case
        gap = np.linalg.norm(positions - wanted, axis=1) / case["pendulum"]["length"]
        gap = np.nan_to_num(gap)
        assert gap[FIRST_TEN].max() <= ten, (case, gap)
        assert gap.max() <= hundred, (case, gap)
        compared += 1
    assert compared >= 60
