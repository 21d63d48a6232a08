"""The full equations: against the closed form, an integrator that is not ours, and formulas."""

from __future__ import annotations

import pickle
import resource
import signal
import threading
from typing import ClassVar

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.motion.real.real_oracle import integrated

import kugelpendel as kp

LABORATORY = kp.Pendulum(length=1.0, gravity=9.81)
HALL = kp.Pendulum(length=4.803, gravity=9.81)
OMEGA = float(HALL.angular_frequency)


@pytest.mark.parametrize(
    "launch",
    [
        kp.Launch.ellipse(0.2, 0.1),
        kp.Launch.ellipse(1e-6, -1e-7, azimuth=1.0),
        kp.Launch.ellipse(0.8, 0.3),
        kp.Launch.apsides(0.5, 0.5),
        kp.Launch.apsides(0.99, 0.0),
        kp.Launch.angles(2.5, 0.3, 0.0, 3.0),
        kp.Launch.angles(0.0, 0.0, 7.0),
        kp.Launch.at_rest(np.pi / 2),
    ],
    ids=["ellipse", "tiny", "wide", "cone", "plane", "above", "over the top", "horizontal"],
)
def test_a_thousand_periods_of_the_ideal_pendulum(launch: kp.Launch) -> None:
    exact = kp.ExactMotion(LABORATORY, launch)
    real = kp.RealMotion(LABORATORY, launch, thread="rod")
    # What rounding leaves grows with the time and goes by the launch: 4e-11 here and, below 20°,
    # 1e-13; over sixty launches over the top 7e-11 in the median and up to 3e-10.
    times = np.linspace(0.0, 2000 * exact.radial_period, 401)
    error = np.linalg.norm(real.position(times) - exact.position(times), axis=-1)
    assert error.max() < 1e-10
    error = np.linalg.norm(real.velocity(times) - exact.velocity(times), axis=-1)
    assert error.max() < 1e-9
    np.testing.assert_allclose(real.tension(times), exact.tension(times), rtol=0, atol=4e-9)
    off = np.linalg.norm(real.position(times), axis=-1) - 1
    assert np.abs(off).max() < 1e-15 * 4
    back = -times[:40]
    np.testing.assert_allclose(real.position(back), exact.position(back), rtol=0, atol=1e-10)


def test_the_error_grows_slowly() -> None:
    exact = kp.ExactMotion(LABORATORY, kp.Launch.ellipse(0.2, 0.1))
    real = kp.RealMotion(LABORATORY, kp.Launch.ellipse(0.2, 0.1))
    ends = np.array([10, 100, 1000]) * 2 * exact.radial_period
    windows = ends[:, np.newaxis] + np.linspace(-2.0, 0.0, 21)
    apart = np.linalg.norm(real.position(windows) - exact.position(windows), axis=-1).max(axis=-1)
    # Never faster than the square of the time.
    assert apart[2] < 1e-12
    assert apart[2] < 1e4 * max(apart[0], 1e-16)


forces = st.fixed_dictionaries(
    {
        "gamma": st.floats(0, 0.05),
        "c": st.floats(0, 0.3),
        "up": st.floats(-0.1, 0.1),
        "north": st.floats(0.001, 0.1),
        "delta": st.floats(-0.1, 0.1),
        "chi": st.floats(-3, 3),
        "fading": st.floats(-0.05, 0.05),
        "chi_d": st.floats(-3, 3),
    }
)


@settings(max_examples=25, deadline=None)
@given(
    acting=forces,
    theta=st.floats(0.01, 2.0),
    rates=st.tuples(st.floats(-1, 1), st.floats(-2, 2)),
)
def test_all_forces_by_another_integrator(
    acting: dict[str, float], theta: float, rates: tuple[float, float]
) -> None:
    """A hundred times stronger than any real ones, so that a wrong term is seen."""
    rotation = np.hypot(acting["up"], acting["north"])
    latitude = np.arctan2(acting["up"], acting["north"])
    site = _spinning(rotation, latitude)
    motion = kp.RealMotion(
        LABORATORY,
        kp.Launch.angles(theta, 0.4, *rates),
        site=site,
        drag=kp.Drag(acting["gamma"], acting["c"]),
        suspension=kp.Suspension(acting["delta"], acting["chi"], acting["fading"], acting["chi_d"]),
        thread="rod",
    )
    times = np.linspace(0.0, 6.0, 25)
    np.testing.assert_allclose(
        motion.position(times), integrated(motion, times, **acting), rtol=0, atol=3e-9
    )


def _spinning(rotation: float, latitude: float) -> kp.Site:
    """A site on a planet that turns faster than the Earth."""

    class Planet(kp.Site[float]):
        @property
        def rotation(self) -> float:
            return float(rotation)

    return Planet(latitude)


class TestEarth:
    latitude = 0.8525

    def plane_turned(self, launch: kp.Launch, hours: float) -> float:
        """Of the outer turning points, rad."""
        motion = kp.RealMotion(HALL, launch, site=kp.Site(self.latitude))
        times = motion.events("outer", 0.0, hours * 3600)
        x, y, _ = motion.position(times).T
        angle = np.unwrap(2 * np.arctan2(y, x)) / 2
        return float((angle[-1] - angle[0]) / (times[-1] - times[0]))

    def test_released_from_rest(self) -> None:
        """−Ω_z(1 − 3a²/8l²): the sideways speed that the ground gives makes an ellipse."""
        up = 7.292115e-5 * np.sin(self.latitude)
        a = 0.3
        rate = self.plane_turned(kp.Launch.ellipse(a, 0.0), 6.0)
        expected = -up * (1 - 3 / 8 * (a / HALL.length) ** 2)
        assert rate == pytest.approx(expected, rel=2e-5)
        assert abs(rate / -up - 1) > 1e-3  # the correction is seen

    def test_the_intrinsic_precession_comes_on_top(self) -> None:
        launch = kp.Launch.ellipse(0.3, 0.002)
        up = 7.292115e-5 * np.sin(self.latitude)
        intrinsic = kp.olsson.precession(0.3, 0.002 + 0.3 * up / OMEGA, HALL.length, 9.81)
        assert self.plane_turned(launch, 3.0) == pytest.approx(intrinsic - up, rel=3e-3)

    def test_southern_hemisphere_turns_the_other_way(self) -> None:
        here = kp.RealMotion(HALL, kp.Launch.ellipse(0.1, 0.0), site=kp.Site(0.6))
        there = kp.RealMotion(HALL, kp.Launch.ellipse(0.1, 0.0), site=kp.Site(-0.6))
        times = np.linspace(0, 600, 50)
        mirrored = here.position(times) * [1, -1, 1]
        np.testing.assert_allclose(there.position(times), mirrored, rtol=0, atol=1e-13)


class TestDrag:
    def test_linear(self) -> None:
        motion = kp.RealMotion(HALL, kp.Launch.ellipse(0.01, 0.0), drag=kp.Drag.from_half_life(600))
        times = motion.events("outer", 0.0, 1200.0)
        reached = np.linalg.norm(motion.position(times)[:, :2], axis=-1)
        np.testing.assert_allclose(reached, 0.01 * 0.5 ** (times / 600), rtol=2e-6)

    def test_angular_momentum_fades_at_twice_the_rate(self) -> None:
        motion = kp.RealMotion(HALL, kp.Launch.ellipse(2.0, 0.7), drag=kp.Drag(0.01))
        times = np.linspace(0, 100, 30)
        (x, y, _), (vx, vy, _) = motion.position(times).T, motion.velocity(times).T
        np.testing.assert_allclose(
            x * vy - y * vx, 2.0 * 0.7 * OMEGA * np.exp(-0.02 * times), rtol=1e-12
        )

    @pytest.mark.parametrize("b", [0.0, 1e-9, 1e-6])
    def test_quadratic(self, b: float) -> None:
        """A plane swing from rest: the speed passes through zero at every turning point.

        There |v| is not smooth, and a series that steps across it goes on with the wrong sign.
        """
        c, a = 0.01, 0.05
        motion = kp.RealMotion(HALL, kp.Launch.ellipse(a, b), drag=kp.Drag(0.0, c))
        times = motion.events("outer", 0.0, 2000.0)
        reached = np.linalg.norm(motion.position(times)[:, :2], axis=-1)
        mean = a / (1 + 4 / (3 * np.pi) * c * OMEGA * a * times)
        np.testing.assert_allclose(reached, mean, rtol=3e-4)

    @pytest.mark.parametrize("a", [0.004, 0.13, 1.7])
    @pytest.mark.parametrize("b", [0.0, 1e-13])
    def test_every_turning_point_is_found(self, a: float, b: float) -> None:
        """Where the steps of quadratic drag have their ends."""
        launch = kp.Launch.ellipse(a, b)
        motion = kp.RealMotion(HALL, launch, drag=kp.Drag(0.0, 0.03))
        half = float(kp.ExactMotion(HALL, launch).radial_period)
        times = motion.events("outer", half / 2, 40.3 * half)
        np.testing.assert_allclose(np.diff(times), half, rtol=0.05)
        assert times.size in (40, 41)  # the period shortens as the swing fades

    @pytest.mark.parametrize("b", [0.0, 1e-7, 1e-4, 1e-2])
    def test_quadratic_by_energy(self, b: float) -> None:
        """What is lost is the work of the drag: d(energy)/dt = −c|v|³."""
        c = 0.02
        motion = kp.RealMotion(HALL, kp.Launch.ellipse(1.0, b), drag=kp.Drag(0.0, c))
        times = np.linspace(0.0, 20.0, 200_001)
        speed = np.linalg.norm(motion.velocity(times), axis=-1)
        energy = speed**2 / 2 + 9.81 * (HALL.length - motion.position(times)[:, 2])
        work = np.trapezoid(c * speed**3, times)
        assert energy[0] - energy[-1] == pytest.approx(work, rel=1e-7)

    def test_faster_than_anything_real_at_rest(self) -> None:
        motion = kp.RealMotion(HALL, kp.Launch.at_rest(0.0), drag=kp.Drag(0.1, 10.0))
        np.testing.assert_array_equal(motion.position([0.0, 5.0])[:, :2], 0)


class TestSuspension:
    delta = 2e-3 * OMEGA

    @pytest.mark.parametrize(("azimuth", "extra"), [(0.7, 1.0), (0.7 + np.pi / 2, 0.0)])
    def test_two_frequencies(self, azimuth: float, extra: float) -> None:
        """ω0 + δ along the stiff axis, ω0 across it."""
        motion = kp.RealMotion(
            HALL, kp.Launch.ellipse(1e-5, 0.0, azimuth), suspension=kp.Suspension(self.delta, 0.7)
        )
        times = motion.events("outer", 0.0, 500.0)
        period = 2 * (times[-1] - times[0]) / (times.size - 1)
        squared = OMEGA**2 + 2 * OMEGA * self.delta * extra
        assert 2 * np.pi / period == pytest.approx(np.sqrt(squared), rel=1e-9)

    @pytest.mark.parametrize(("azimuth", "rate"), [(0.7, 0.012), (0.7 + np.pi / 2, 0.008)])
    def test_two_dampings(self, azimuth: float, rate: float) -> None:
        motion = kp.RealMotion(
            HALL,
            kp.Launch.ellipse(1e-4, 0.0, azimuth),
            drag=kp.Drag(0.01),
            suspension=kp.Suspension(damping_anisotropy=0.004, damping_axis=0.7),
        )
        times = motion.events("outer", 0.0, 200.0)
        reached = np.linalg.norm(motion.position(times)[:, :2], axis=-1)
        np.testing.assert_allclose(reached, 1e-4 * np.exp(-rate * times), rtol=1e-4)


def test_a_checked_day() -> None:
    """Six hours of all of it, from the notes that this project started with."""
    motion = kp.RealMotion(
        HALL,
        kp.Launch.ellipse(0.12, 0.0),
        site=kp.Site(np.arcsin(4.8e-5 / 7.292115e-5)),
        drag=kp.Drag(2e-5),
        suspension=kp.Suspension(1e-4 * OMEGA, 0.5),
    )
    near = 6 * 3600
    outer = motion.position(motion.events("outer", near - 3, near + 3))[1]
    inner = motion.position(motion.events("inner", near - 3, near + 3))[1]
    assert np.hypot(*outer[:2]) == pytest.approx(0.07360213, rel=2e-4)
    assert np.hypot(*inner[:2]) == pytest.approx(0.0255412, rel=5e-4)
    turned = np.arctan2(outer[1], outer[0]) - -2.28416707
    assert abs((turned + np.pi / 2) % np.pi - np.pi / 2) < 2e-4


def test_bob_changes_the_gravity_that_acts() -> None:
    bob = kp.Bob(radius=0.1, density=8000.0)
    motion = kp.RealMotion(HALL, kp.Launch.ellipse(1e-5, 0.0), bob=bob)
    factor = float(np.asarray(bob.gravity_factor(HALL.length)))
    assert motion.tension(0.0) == pytest.approx(9.81, rel=1e-9)  # of 1 kg that hangs still
    assert motion.angular_frequency == pytest.approx(OMEGA * np.sqrt(factor), rel=1e-15)
    times = motion.events("outer", 0.0, 300.0)
    period = 2 * (times[-1] - times[0]) / (times.size - 1)
    assert 2 * np.pi / period == pytest.approx(motion.angular_frequency, rel=1e-11)


class TestDrive:
    def test_push_changes_the_velocity_by_its_strength(self) -> None:
        push, radius = 0.02, 0.1
        motion = kp.RealMotion(
            HALL,
            kp.Launch.ellipse(0.3, 0.0),
            drag=kp.Drag(0.01),
            drive=kp.Drive(push, radius=radius),
        )
        free = kp.RealMotion(HALL, kp.Launch.ellipse(0.3, 0.0), drag=kp.Drag(0.01))
        bottom = free.next_event("inner")
        times = np.linspace(bottom, bottom + 0.3, 30_001)
        places = free.position(times)
        when = times[np.linalg.norm(places[:, :2], axis=-1) > radius][0]
        before, after = motion.velocity([when - 2e-5, when + 2e-5])
        tilt = radius / HALL.length
        gained = np.linalg.norm(after) - np.linalg.norm(before)
        assert gained == pytest.approx(push * np.sqrt(1 - tilt**2), rel=5e-3)

    @pytest.mark.parametrize("when", [{"phase": 0.3}, {"radius": 0.05}])
    def test_settles_where_gain_and_loss_balance(self, when: dict[str, float]) -> None:
        """Twice a period p·cos φ of speed comes in, and γ takes it out."""
        push, gamma = 0.0005, 1e-3
        drive = kp.Drive(push, **when)
        motion = kp.RealMotion(HALL, kp.Launch.ellipse(0.15, 0.0), drag=kp.Drag(gamma), drive=drive)
        times = motion.events("outer", 9000.0, 9100.0)
        reached = np.linalg.norm(motion.position(times)[:, :2], axis=-1)
        # The change of the amplitude in half a period, p cos φ/ω0, against γ a π/ω0.
        if "phase" in when:
            expected = push * np.cos(when["phase"]) / (np.pi * gamma)
        else:
            a = push / (np.pi * gamma)
            for _ in range(50):
                a = push * np.sqrt(1 - (when["radius"] / a) ** 2) / (np.pi * gamma)
            expected = a
        np.testing.assert_allclose(reached, expected, rtol=3e-3)

    def test_no_way_back(self) -> None:
        motion = kp.RealMotion(
            HALL,
            kp.Launch.ellipse(0.1, 0.0),
            drag=kp.Drag(0.01),
            drive=kp.Drive(1e-3, phase=0.0),
        )
        assert motion.span == (0.0, np.inf)
        with pytest.raises(kp.InvalidInput, match=r"before its launch.*-1 s"):
            motion.position(-1.0)

    def test_one_that_pumps_without_end(self) -> None:
        with pytest.raises(kp.InvalidInput, match=r"push of 0\.001 m/s pumps without end.*drag"):
            kp.RealMotion(HALL, kp.Launch.ellipse(0.1, 0.0), drive=kp.Drive(1e-3, phase=0.0))


class TestThread:
    looping = kp.Launch.angles(0.0, 0.0, 6.5)

    def test_ends_when_the_closed_form_says(self) -> None:
        exact = kp.ExactMotion(LABORATORY, self.looping)
        motion = kp.RealMotion(LABORATORY, self.looping)
        end = exact.slack_time
        assert motion.next_event("slack") == pytest.approx(end, rel=4e-16)
        motion.position(np.linspace(0, end * (1 - 1e-12), 7))
        with pytest.raises(kp.MotionEnded, match=rf"goes slack at {end:.8g}.*s, where the motion"):
            motion.position([0.0, 5.0])

    def test_ensemble_is_nan_from_the_end_on(self) -> None:
        launch = kp.Launch.angles(0.0, 0.0, [1.0, 6.5])
        found = kp.RealMotion(LABORATORY, launch).position([0.1, 5.0])
        assert np.isfinite(found[0]).all()
        assert np.isfinite(found[1, 0]).all()
        assert np.isnan(found[1, 1]).all()

    def test_flies_on_a_parabola_and_is_caught(self) -> None:
        motion = kp.RealMotion(LABORATORY, self.looping, thread="flies")
        slack, taut = motion.events("slack", 0, 20), motion.events("taut", 0, 20)
        assert slack.size >= 5
        assert (slack[:-1] < taut[: slack.size - 1]).all()
        # In flight: gravity alone, and no pull.
        start, end = slack[0], taut[0]
        times = np.linspace(start, end, 11)[1:-1]
        x0, v0 = motion.position(start), motion.velocity(start)
        fall = times[:, np.newaxis] - start
        parabola = x0 + v0 * fall + np.array([0, 0, 9.81 / 2]) * fall**2
        np.testing.assert_allclose(motion.position(times), parabola, rtol=0, atol=1e-14)
        np.testing.assert_array_equal(motion.tension(times), 0)
        # The thread never stretches, and every jerk takes energy away.
        everywhere = np.linspace(0, 20, 5001)
        place, speed = motion.position(everywhere), motion.velocity(everywhere)
        assert np.linalg.norm(place, axis=-1).max() < 1 + 1e-14
        energy = (speed**2).sum(axis=-1) / 2 - 9.81 * place[:, 2]
        assert (np.diff(energy) < 1e-12).all()
        before, after = motion.velocity([end - 1e-9, end + 1e-9])
        place = motion.position(end)
        assert abs(after @ place) < 1e-6 < before @ place
        np.testing.assert_allclose(after, before - (before @ place) * place, atol=1e-6)

    def test_launched_slack(self) -> None:
        launch = kp.Launch.at_rest(2.5)
        with pytest.raises(kp.MotionEnded, match=r"goes slack at 0 s"):
            kp.RealMotion(LABORATORY, launch).position(1.0)
        falling = kp.RealMotion(LABORATORY, launch, thread="flies")
        start = falling.position(0.0)
        np.testing.assert_allclose(
            falling.position(0.1), start + np.array([0, 0, 9.81 / 2 * 0.01]), atol=1e-15
        )


class TestEvents:
    motion = kp.RealMotion(LABORATORY, kp.Launch.apsides(0.4, 0.1, 0.3))
    exact = kp.ExactMotion(LABORATORY, kp.Launch.apsides(0.4, 0.1, 0.3))

    def test_apsides(self) -> None:
        half = self.exact.radial_period
        outer = self.motion.events("outer", 0.1, 20.0)
        np.testing.assert_allclose(outer, half * np.arange(1, outer.size + 1), rtol=1e-14)
        inner = self.motion.events("inner", 0.0, 20.0)
        np.testing.assert_allclose(inner, half * (np.arange(inner.size) + 0.5), rtol=1e-14)

    def test_azimuth(self) -> None:
        times = self.motion.events("azimuth", 0.0, 10.0, value=1.1)
        assert times.size >= 4
        x, y, _ = self.exact.position(times).T
        np.testing.assert_allclose(np.arctan2(y, x), 1.1, atol=1e-14)
        # Once a revolution.
        steps = np.diff(times) / (2 * self.exact.radial_period)
        np.testing.assert_allclose(steps, 1, atol=0.1)

    def test_the_next_one(self) -> None:
        half = self.exact.radial_period
        first = self.motion.next_event("outer", after=0.1)
        assert first == pytest.approx(half, rel=1e-14)
        assert self.motion.next_event("outer", after=first) == pytest.approx(2 * half, rel=1e-14)

    def test_one_that_never_comes(self) -> None:
        with pytest.raises(kp.EventNotFound, match=r'"slack" does not come within 100 s after 5 s'):
            self.motion.next_event("slack", after=5.0, within=100.0)
        assert self.motion.events("slack", 0.0, 100.0).size == 0

    @pytest.mark.parametrize(
        ("arguments", "sentence"),
        [
            (("apsis", 0, 1), "must be one of 'outer'.*'apsis'"),
            (("azimuth", 0, 1), "needs a value"),
            (("outer", 0, 1, 0.3), "does not take a value"),
            (("azimuth", 0, 1, np.nan), "must be finite, but it is nan rad"),
            (("outer", 2, 1), "from 2.0 s to 1.0 s"),
            (("outer", -1, 1), "from -1.0 s to 1.0 s"),
            (("outer", 0, np.inf), "to inf s"),
            (("outer", 0, [1, 2]), "must be one number"),
        ],
    )
    def test_bad_requests(self, arguments: tuple, sentence: str) -> None:
        with pytest.raises(kp.InvalidInput, match=sentence):
            self.motion.events(*arguments)

    def test_not_of_an_ensemble(self) -> None:
        with pytest.raises(kp.InvalidInput, match=r"single motion.*shape \(2,\)"):
            kp.RealMotion(LABORATORY, kp.Launch.ellipse([0.1, 0.2], 0.0)).events("outer", 0, 1)


class TestRequests:
    around: ClassVar = {
        "site": kp.Site(0.8),
        "drag": kp.Drag(0.001, 0.01),
        "suspension": kp.Suspension(1e-3, 0.3),
    }

    def motion(self, a: float | list[float] = 0.2) -> kp.RealMotion:
        return kp.RealMotion(LABORATORY, kp.Launch.ellipse(a, 0.05), **self.around)

    def test_any_order_and_any_history_give_the_same_bits(self) -> None:
        times = np.random.default_rng(5).uniform(-40, 60, 300)
        at_once = self.motion().position(times)
        walking = self.motion()
        one_by_one = np.array([walking.position(t) for t in times])
        np.testing.assert_array_equal(one_by_one, at_once)
        order = np.argsort(times)
        np.testing.assert_array_equal(self.motion().position(times[order]), at_once[order])
        walking.events("outer", 0.0, 100.0)
        np.testing.assert_array_equal(walking.position(times), at_once)

    def test_ensembles_are_their_motions(self) -> None:
        amplitudes = [0.05, 0.1, 0.2, 0.4]
        times = np.linspace(0, 30, 11)
        together = self.motion(amplitudes).position(times)
        assert together.shape == (4, 11, 3)
        for a, row in zip(amplitudes, together, strict=True):
            np.testing.assert_array_equal(self.motion(a).position(times), row)

    def test_forces_broadcast_too(self) -> None:
        motion = kp.RealMotion(
            LABORATORY,
            kp.Launch.ellipse([[0.1], [0.2]], 0.0),
            drag=kp.Drag(np.array([0.0, 0.1, 0.2])),
        )
        assert motion.shape == (2, 3)
        single = kp.RealMotion(LABORATORY, kp.Launch.ellipse(0.2, 0.0), drag=kp.Drag(0.1))
        np.testing.assert_array_equal(motion.position(3.0)[1, 1], single.position(3.0))
        assert motion[1, 1] == single
        assert motion[:, 1].forces.drag == kp.Drag([0.1, 0.1])
        assert motion.tension([1.0, 2.0]).shape == (2, 3, 2)

    def test_one_bad_case_stops_nothing(self) -> None:
        motion = self.motion([0.2, np.nan, 2.0])
        found = motion.position(1.0)
        assert np.isfinite(found[0]).all()
        assert np.isnan(found[1:]).all()
        assert motion.reason[0] == ""
        assert "finite" in motion.reason[1]
        assert "lower half" in motion.reason[2]

    def test_sample_is_position(self) -> None:
        sampled = self.motion().sample(1.0, 0.25, 9)
        np.testing.assert_array_equal(sampled, self.motion().position(1.0 + 0.25 * np.arange(9)))

    def test_energy_comes_back_without_losses(self) -> None:
        motion = kp.RealMotion(LABORATORY, kp.Launch.ellipse(0.3, 0.1), site=kp.Site(0.8))
        times = np.linspace(0, 1000, 50)
        speed = np.linalg.norm(motion.velocity(times), axis=-1)
        energy = speed**2 / 2 + 9.81 * (1 - motion.position(times)[:, 2])
        np.testing.assert_allclose(energy, energy[0], rtol=1e-13)

    @pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-12])
    def test_a_coarser_tolerance_is_kept(self, tolerance: float) -> None:
        exact = kp.ExactMotion(LABORATORY, kp.Launch.ellipse(0.2, 0.1)).position(10.0)
        coarse = kp.RealMotion(LABORATORY, kp.Launch.ellipse(0.2, 0.1), tolerance=tolerance)
        error = np.linalg.norm(coarse.position(10.0) - exact)
        assert error < 100 * tolerance
        assert error > 1e-15

    def test_survives_a_pickle_and_a_copy(self) -> None:
        motion = self.motion()
        again = pickle.loads(pickle.dumps(motion))
        np.testing.assert_array_equal(again.position(7.0), motion.position(7.0))

    def test_memory_does_not_grow_with_the_span(self) -> None:
        motion = self.motion()
        motion.position(10.0)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        motion.position(20_000.0)
        assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 1000  # kB

    def test_can_be_interrupted(self) -> None:
        motion = self.motion()
        timer = threading.Timer(0.2, signal.raise_signal, (signal.SIGINT,))
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            motion.position(1e9)
        timer.join()
        assert np.isfinite(motion.position(1.0)).all()


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"thread": "breaks"}, "must be one of 'ends', 'flies', 'rod', but it is 'breaks'"),
        ({"tolerance": 0.0}, "between 0 and 1e-3, but it is 0"),
        ({"tolerance": np.nan}, "but it is nan"),
        ({"tolerance": "fine"}, "The tolerance must be a number"),
        (
            {"site": kp.Site(0.8, gravity=9.80)},
            r"site's gravity is 9\.8 m/s² and the pendulum's 9\.81",
        ),
        (
            {"drag": kp.Drag(np.ones(3)), "site": kp.Site(np.zeros(2))},
            r"do not fit together.*\(2,\)",
        ),
    ],
)  # fmt: skip
def test_bad_options(options: dict, sentence: str) -> None:
    with pytest.raises(kp.InvalidInput, match=sentence):
        kp.RealMotion(LABORATORY, kp.Launch.ellipse(0.1, 0.0), **options)


@pytest.mark.parametrize(
    "launch", [kp.Launch.ellipse(1.2, 0.0), kp.Launch.state((0, 0, 2), (0, 0, 0))]
)
def test_a_launch_off_the_sphere(launch: kp.Launch) -> None:
    with pytest.raises(kp.InvalidInput, match="sphere"):
        kp.RealMotion(LABORATORY, launch)


def test_bad_times() -> None:
    motion = kp.RealMotion(LABORATORY, kp.Launch.ellipse(0.1, 0.0))
    with pytest.raises(kp.InvalidInput, match="Times must be finite"):
        motion.position([0.0, np.nan])
    with pytest.raises(kp.InvalidInput, match="step must not be 0 s"):
        motion.sample(0.0, 0.0, 3)
