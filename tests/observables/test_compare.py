"""All motions beside the exact one: what each gets right, and what is refused."""

# Rows that hold have their numbers.
# pyright: reportOptionalMemberAccess=false, reportOptionalSubscript=false
# pyright: reportOptionalOperand=false, reportArgumentType=false, reportCallIssue=false

import math

import numpy as np
import pytest

import kugelpendel as kp

UNIT = kp.Pendulum(length=1.0)
NAMES = [
    "LinearMotion",
    "OlssonMotion",
    "CubicMotion",
    "SeriesMotion(6)",
    "SeriesMotion(12)",
    "PlaneMotion",
]


@pytest.fixture(scope="module")
def laboratory() -> kp.Comparison:
    return kp.compare(UNIT, kp.Launch.apsides(0.2, 0.1))


def test_every_motion_is_there(laboratory: kp.Comparison) -> None:
    assert [row.name for row in laboratory.rows] == NAMES
    for row in laboratory.rows:
        assert row.trust.endswith(".")
        assert row.reason == row.caution == ""
        assert row.errors is not None
        assert row.errors.shape == laboratory.times.shape
    with pytest.raises(kp.InvalidInput, match="No motion of this comparison"):
        laboratory.row("ExactMotion")


def test_errors_are_distances(laboratory: kp.Comparison) -> None:
    launch = kp.Launch.apsides(0.2, 0.1)
    motion, exact = kp.OlssonMotion(UNIT, launch), kp.ExactMotion(UNIT, launch)
    times = laboratory.times
    expected = np.linalg.norm(motion.position(times) - exact.position(times), axis=-1)
    row = laboratory.row("OlssonMotion")
    np.testing.assert_allclose(row.errors, expected, atol=1e-14)
    assert row.largest == row.errors.max()
    assert row.final == row.errors[-1]
    assert laboratory.amplitude == pytest.approx(0.2)
    assert times[-1] == pytest.approx(20 * 2 * math.pi / exact.frequency)


def test_rates_are_those_of_the_formulas(laboratory: kp.Comparison) -> None:
    errors = kp.validity(0.2, 0.1, 1.0)
    olsson = laboratory.row("OlssonMotion")
    assert olsson.precession == pytest.approx(errors.formula_25, abs=1e-14)
    assert olsson.period == pytest.approx(1 / (1 + errors.formula_26) - 1, abs=1e-14)
    series = laboratory.row("SeriesMotion(6)")
    assert series.precession == pytest.approx(errors.series[6].precession, abs=1e-14)
    assert laboratory.row("LinearMotion").precession == -1


def test_the_exact_equation_is_exact(laboratory: kp.Comparison) -> None:
    row = laboratory.row("PlaneMotion")
    assert row.largest < 1e-12
    assert abs(row.period) < 1e-13
    assert abs(row.precession) < 1e-11


def test_the_ladder_climbs(laboratory: kp.Comparison) -> None:
    largest = [row.largest for row in laboratory.rows]
    assert largest == sorted(largest, reverse=True)


@pytest.mark.parametrize("b", [0.1, -0.1, 0.002, -0.199])
def test_precession_of_the_cubic_law_is_low_by_the_difference_of_the_next_terms(b: float) -> None:
    a = 0.2
    scale = 0.1  # of an ellipse of this shape
    found = kp.compare(UNIT, kp.Launch.apsides(scale * a, scale * b)).row("CubicMotion")
    squares = scale**2 * (a * a + b * b)
    # From the same launch, whose inner turning radius (13) shifts by a relative order of 1e-4 too.
    assert found.precession / squares == pytest.approx(13 / 96 - 7 / 32, rel=0.05)


def test_sense_makes_no_difference() -> None:
    one, other = (kp.compare(UNIT, kp.Launch.apsides(0.2, b, 0.3)) for b in (0.05, -0.05))
    for left, right in zip(one.rows[:-1], other.rows[:-1], strict=True):
        assert left.largest == pytest.approx(right.largest, rel=1e-2)
        assert left.precession == pytest.approx(right.precession, rel=1e-4)


def test_a_swing_in_a_plane_has_no_precession_to_be_wrong() -> None:
    comparison = kp.compare(UNIT, kp.Launch.ellipse(0.2, 0.0))
    for row in comparison.rows:
        assert row.precession is None
        assert row.period is not None
        assert row.largest is not None


def test_a_circle_shows_no_turning_points() -> None:
    comparison = kp.compare(UNIT, kp.Launch.apsides(0.2, 0.2))
    plane = comparison.row("PlaneMotion")
    assert plane.period is plane.precession is None
    assert plane.largest < 1e-12
    assert comparison.row("OlssonMotion").precession == pytest.approx(-0.0176, abs=1e-4)


def test_rest_stays_at_rest() -> None:
    comparison = kp.compare(UNIT, kp.Launch.at_rest(0.0))
    assert comparison.amplitude == 0
    assert all(row.largest == 0 for row in comparison.rows)


def test_upper_half_is_told_and_not_computed() -> None:
    comparison = kp.compare(UNIT, kp.Launch.at_rest(2.0))
    for row in comparison.rows:
        assert row.reason.endswith("; use ExactMotion.")
        assert "use ExactMotion" in row.reason
        assert row.errors is row.largest is row.final is row.period is row.precession is None
    assert comparison.amplitude == 1


def test_integrated_motions_end_at_the_level_of_the_support() -> None:
    comparison = kp.compare(UNIT, kp.Launch.plane(0.1, 0.0, 0.0, 7.2), duration=20.0)
    assert comparison.row("OlssonMotion").reason
    plane = comparison.row("PlaneMotion")
    assert plane.largest < 1e-12
    assert plane.final is None
    assert "ends after" in plane.caution
    assert plane.period is plane.precession is None
    end = float(plane.caution.split()[3])
    height = 1.0 - kp.ExactMotion(UNIT, kp.Launch.plane(0.1, 0.0, 0.0, 7.2)).position(end)[2]
    assert 0.8 < height < 1


def test_separatrix() -> None:
    comparison = kp.compare(kp.Pendulum(1.0, 9.0), kp.Launch.plane(0.0, 0.0, 0.0, 6.0))
    assert comparison.row("OlssonMotion").reason
    assert comparison.row("PlaneMotion").period is None


def test_orders_can_be_chosen() -> None:
    comparison = kp.compare(UNIT, kp.Launch.apsides(0.1, 0.05), orders=[2, 8])
    assert [row.name for row in comparison.rows[3:5]] == ["SeriesMotion(2)", "SeriesMotion(8)"]
    assert len(kp.compare(UNIT, kp.Launch.apsides(0.1, 0.05), orders=[]).rows) == 4


@pytest.mark.parametrize("order", [0, 3, -2, 14, 2.5])
def test_orders_that_do_not_exist(order: int) -> None:
    with pytest.raises(kp.InvalidInput, match=f"2, 4, 6, 8, 10, 12, but it is {order}"):
        kp.compare(UNIT, kp.Launch.apsides(0.1, 0.05), orders=[order])


@pytest.mark.parametrize("duration", [0.0, -1.0, math.nan, math.inf])
def test_durations_that_make_no_sense(duration: float) -> None:
    with pytest.raises(kp.InvalidInput, match=f"duration must be positive.* {duration} s"):
        kp.compare(UNIT, kp.Launch.apsides(0.1, 0.05), duration)


def test_durations_that_take_too_long() -> None:
    with pytest.raises(kp.InvalidInput, match=r"20000 swings, 401\d\d.\d s"):
        kp.compare(UNIT, kp.Launch.apsides(0.1, 0.05), 1e8)


def test_ensembles_are_refused() -> None:
    with pytest.raises(kp.InvalidInput, match=r"ensemble of shape \(2,\)"):
        kp.compare(UNIT, kp.Launch.apsides([0.1, 0.2], 0.05))


def test_bad_launches_are_refused() -> None:
    with pytest.raises(kp.InvalidInput, match="2 m"):
        kp.compare(UNIT, kp.Launch.apsides(2.0, 0.05))


def test_warnings_become_cautions() -> None:
    comparison = kp.compare(UNIT, kp.Launch.apsides(0.95, 0.5))
    assert "use a higher order, or ExactMotion" in comparison.row("SeriesMotion(6)").caution
    assert comparison.row("PlaneMotion").caution == ""


def test_somebody_is_told_how_far_the_integrated_motions_are() -> None:
    told: list[tuple[int, int]] = []
    made = kp.compare(UNIT, kp.Launch.ellipse(0.3, 0.1), done=lambda *far: told.append(far))
    both = 2 * len(made.times)
    assert {total for _, total in told} == {both}
    taken = [some for some, _ in told]
    assert taken == sorted(taken)
    assert taken[-1] == both
    assert len(taken) >= 100
