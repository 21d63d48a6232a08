"""One pass for everything: the steps of the integration are counted, and the bits compared."""

from __future__ import annotations

import copy
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kugelpendel as kp
from kugelpendel import _core
from kugelpendel.motion import AskedEvent, EventKind, SteppedMotion

METRE = kp.Pendulum(length=1.0, gravity=9.81)

MOTIONS: dict[str, Callable[[], SteppedMotion]] = {
    "real": lambda: kp.RealMotion(
        METRE,
        kp.Launch.ellipse(0.2, 0.05),
        site=kp.Site(0.8),
        drag=kp.Drag(1e-4, 0.01),
        suspension=kp.Suspension(1e-3, 0.3),
    ),
    "driven": lambda: kp.RealMotion(
        METRE,
        kp.Launch.ellipse(0.1, 0.0),
        drag=kp.Drag(1e-3),
        drive=kp.Drive(3e-4, phase=0.3),
    ),
    "flies": lambda: kp.RealMotion(METRE, kp.Launch.angles(0.0, 0.0, 6.5), thread="flies"),
    "plane": lambda: kp.PlaneMotion(METRE, kp.Launch.apsides(0.5, 0.2)),
    "cubic": lambda: kp.CubicMotion(METRE, kp.Launch.apsides(0.5, 0.2)),
}


@pytest.fixture(params=MOTIONS)
def make(request: pytest.FixtureRequest) -> Callable[[], SteppedMotion]:
    return MOTIONS[request.param]


def steps(work: Callable[[], object]) -> int:
    """Steps of integration that some work takes."""
    before = _core.steps_taken()
    work()
    return _core.steps_taken() - before


class TestSteps:
    def test_position_and_velocity_in_turn(self, make: Callable[[], SteppedMotion]) -> None:
        """Forty stretches, one after the other: at most 2.5 times one call for all positions."""
        times = np.linspace(0.0, 400.0, 4001)
        whole = steps(lambda: make().position(times))
        motion = make()

        def in_turn() -> None:
            for stretch in np.array_split(times, 40):
                motion.position(stretch)
                motion.velocity(stretch)

        assert whole > 400
        assert steps(in_turn) <= 2.5 * whole  # reached: 2.0

    def test_any_mixture_over_ascending_stretches(self, make: Callable[[], SteppedMotion]) -> None:
        """Five questions to a stretch cost five passes, not the way from the launch each time."""
        times = np.linspace(0.0, 400.0, 4001)
        whole = steps(lambda: make().position(times))
        motion = make()

        def mixed() -> None:
            for stretch in np.array_split(times, 40):
                outer = motion.events("outer", stretch[0], stretch[-1])
                motion.position(outer)
                motion.tension(stretch)
                motion.velocity(outer)
                motion.position(stretch)

        assert steps(mixed) <= 5.5 * whole

    def test_one_walk_is_one_pass(self, make: Callable[[], SteppedMotion]) -> None:
        times = np.linspace(0.0, 400.0, 4001)
        whole = steps(lambda: make().position(times))

        def walked() -> None:
            walk = make().walk()
            for stretch in np.array_split(times, 40):
                walk.to(stretch[-1], stretch, ("outer", "inner", ("azimuth", 0.1)))

        # Each leg does the step at its beginning anew at most.
        assert steps(walked) <= whole + 40

    def test_going_back_costs_little(self, make: Callable[[], SteppedMotion]) -> None:
        motion = make()
        whole = steps(lambda: motion.position(2000.0))
        random = np.random.default_rng(1)
        for t in random.uniform(0.0, 2000.0, 20):
            assert steps(lambda t=t: motion.position(t)) <= whole / 400 + 2

    @pytest.mark.parametrize("kind", [kp.PlaneMotion, kp.CubicMotion])
    def test_late_times_cost_what_early_ones_do(
        self, kind: type[kp.PlaneMotion | kp.CubicMotion]
    ) -> None:
        """Ten thousand points after 24 h: at most twice what they cost at the launch."""
        motion = kind(kp.Pendulum(67.0, 9.81), kp.Launch.apsides(3.0, 1.0))
        span = np.linspace(0.0, 60.0, 10_000)
        early = steps(lambda: motion.position(span))
        motion.position(86_400.0)
        assert steps(lambda: motion.position(86_400.0 + span)) <= 2 * early
        # Walking on costs what is new.
        assert steps(lambda: motion.position(86_460.0 + span)) <= 1.1 * early + 1

    def test_the_counter_counts(self) -> None:
        motion = MOTIONS["real"]()
        once = steps(lambda: motion.position(100.0))
        assert once > 100
        assert steps(lambda: motion.position(100.0)) == 0


class TestLegs:
    def test_are_what_is_asked_one_by_one(self, make: Callable[[], SteppedMotion]) -> None:
        times = np.linspace(0.0, 50.0, 501)
        walk, apart = make().walk(), make()
        asked: tuple[AskedEvent, ...] = (
            "outer",
            "inner",
            "bottom",
            ("azimuth", 0.4),
            ("radius", 0.15),
            "slack",
            "taut",
        )
        legs = [walk.to(s[-1], s, asked) for s in np.array_split(times, 7)]
        for name in ("position", "velocity", "tension"):
            together = np.concatenate([getattr(leg, name) for leg in legs])
            np.testing.assert_array_equal(together, getattr(apart, name)(times))
        for event in asked:
            kind, value = event if isinstance(event, tuple) else (event, None)
            found = np.concatenate([leg.events[event].times for leg in legs])
            np.testing.assert_array_equal(found, apart.events(kind, 0.0, 50.0, value))
            # Where the thread is taut again its jerk changes the velocity: the passage is before.
            names = ("position",) if event == "taut" else ("position", "velocity", "tension")
            for name in names:
                there = np.concatenate([getattr(leg.events[event], name) for leg in legs])
                # Their time is rounded to a binary64 number.
                np.testing.assert_allclose(there, getattr(apart, name)(found), rtol=0, atol=1e-11)

    @settings(max_examples=20, deadline=None)
    @given(cuts=st.lists(st.floats(0.0, 60.0), max_size=12), name=st.sampled_from(sorted(MOTIONS)))
    def test_no_event_is_lost_or_doubled(self, cuts: list[float], name: str) -> None:
        """Wherever a walk is cut, also at the events themselves."""
        motion = MOTIONS[name]()
        outer = motion.events("outer", 0.0, 60.0)
        edges = np.unique([*cuts, *outer[::3], 60.0])
        walk = motion.walk()
        found = [walk.to(float(edge), events=("outer",)).events["outer"].times for edge in edges]
        np.testing.assert_array_equal(np.concatenate(found), outer)

    def test_work_can_be_cut_anywhere(self, make: Callable[[], SteppedMotion]) -> None:
        """Legs that end after no time at all go 64 steps, and nothing is lost between them."""
        times = np.linspace(0.0, 100.0, 1001)
        motion, walk, legs, rest = make(), make().walk(), [], times
        whole = steps(lambda: motion.position(times))
        before = _core.steps_taken()
        while walk.time < 100.0:
            legs.append(walk.to(100.0, rest, ("outer", "bottom"), within=0.0))
            rest = rest[len(legs[-1].times) :]
        assert len(legs) > 5
        # Each leg does one step anew.
        assert _core.steps_taken() - before <= whole + 2 * len(legs)
        position = np.concatenate([leg.position for leg in legs])
        np.testing.assert_array_equal(position, motion.position(times))
        kinds: tuple[EventKind, ...] = ("outer", "bottom")
        for event in kinds:
            found = np.concatenate([leg.events[event].times for leg in legs])
            np.testing.assert_array_equal(found, motion.events(event, 0.0, 100.0))

    def test_a_walk_can_be_copied(self) -> None:
        walk = MOTIONS["real"]().walk()
        walk.to(10.0)
        other = copy.copy(walk)
        first = walk.to(20.0, [15.0])
        second = other.to(20.0, [15.0])
        np.testing.assert_array_equal(first.velocity, second.velocity)
        assert walk.time == other.time == 20.0

    def test_ends_with_the_motion(self) -> None:
        launch = kp.Launch.angles(0.0, 0.0, 6.5)
        end = float(kp.ExactMotion(METRE, launch).slack_time)
        walk = kp.RealMotion(METRE, launch).walk()
        times = np.linspace(0.0, 2 * end, 101)
        leg = walk.to(2 * end, times, ("slack",))
        assert leg.ending == walk.ending == "slack"
        assert leg.until == pytest.approx(end, rel=4e-16)
        assert leg.times[-1] <= leg.until < times[len(leg.times)]
        np.testing.assert_array_equal(leg.events["slack"].times, leg.until)
        assert leg.events["slack"].tension == pytest.approx(0.0, abs=1e-12)
        nothing = walk.to(3 * end, [2.5 * end])
        assert (len(nothing.times), nothing.ending) == (0, "slack")

    def test_of_the_plan_view_end_at_the_support(self) -> None:
        motion = kp.PlaneMotion(METRE, kp.Launch.plane(0.3, 0.2, 0.2, 6.0))
        leg = motion.walk().to(100.0)
        assert leg.ending == "level"
        assert leg.until == motion.span[1]

    @pytest.mark.parametrize(
        ("arguments", "sentence"),
        [
            ((5.0,), "has come to 10 s and goes on from there, not to 5"),
            ((np.inf,), "not to inf"),
            ((20.0, [15.0, 12.0]), "must ascend from 10 s to 20 s.*from 15 s to 12 s"),
            ((20.0, [5.0]), "must ascend"),
            ((20.0, [21.0]), "must ascend"),
            ((20.0, [np.nan]), "finite"),
            ((20.0, (), ("apsis",)), "must be one of 'outer'"),
            ((20.0, (), ("azimuth",)), "needs a value, the azimuth in rad"),
            ((20.0, (), (("radius", np.inf),)), "The radius must be finite, but it is inf m"),
            ((20.0, (), (("outer", 1.0),)), "does not take a value"),
        ],
    )
    def test_bad_legs(self, arguments: tuple, sentence: str) -> None:
        walk = MOTIONS["real"]().walk()
        walk.to(10.0)
        with pytest.raises(kp.InvalidInput, match=sentence):
            walk.to(*arguments)

    def test_bad_walks(self) -> None:
        with pytest.raises(kp.InvalidInput, match=r"single motion.*shape \(2,\)"):
            kp.RealMotion(METRE, kp.Launch.ellipse([0.1, 0.2], 0.0)).walk()
        with pytest.raises(kp.InvalidInput, match="begins at a time ≥ 0 s, but asked for is -1"):
            MOTIONS["real"]().walk(-1.0)


class TestEvents:
    motion = kp.RealMotion(METRE, kp.Launch.apsides(0.4, 0.1))
    exact = kp.ExactMotion(METRE, kp.Launch.apsides(0.4, 0.1))

    def test_bottom_is_the_lowest_point(self) -> None:
        found = self.motion.events("bottom", 0.0, 20.0)
        np.testing.assert_array_equal(found, self.motion.events("inner", 0.0, 20.0))
        # Over the top the closest approach to the axis is the lowest or the highest point.
        loop = kp.RealMotion(METRE, kp.Launch.angles(0.1, 0.0, 9.0, 1.0), thread="rod")
        bottom, inner = (loop.events(kind, 0.0, 20.0) for kind in ("bottom", "inner"))
        heights = loop.position(inner)[:, 2]
        np.testing.assert_array_equal(bottom, inner[heights > 0])
        assert 0 < bottom.size < inner.size

    def test_radius_is_passed_four_times_a_swing(self) -> None:
        found = self.motion.events("radius", 0.0, 20 * float(self.exact.radial_period), value=0.25)
        assert found.size == 40
        radii = np.linalg.norm(self.exact.position(found)[:, :2], axis=-1)
        np.testing.assert_allclose(radii, 0.25, rtol=1e-13)
        assert self.motion.events("radius", 0.0, 20.0, value=0.5).size == 0

    def test_of_the_plan_view(self) -> None:
        motion = kp.PlaneMotion(METRE, kp.Launch.apsides(0.4, 0.1))
        events: tuple[tuple[EventKind, float | None], ...] = (
            ("outer", None), ("bottom", None), ("azimuth", 1.0), ("radius", 0.3)
        )  # fmt: skip
        for kind, value in events:
            found = motion.events(kind, 0.1, 20.0, value)
            expected = self.motion.events(kind, 0.1, 20.0, value)
            np.testing.assert_allclose(found, expected, rtol=1e-13)


class TestEnds:
    def test_of_the_plan_view_have_the_tension_of_their_law(self) -> None:
        times = np.linspace(0.0, 10.0, 101)
        plane = kp.PlaneMotion(METRE, kp.Launch.apsides(0.4, 0.1))
        exact = kp.ExactMotion(METRE, kp.Launch.apsides(0.4, 0.1))
        np.testing.assert_allclose(plane.tension(times), exact.tension(times), rtol=1e-12)
        cubic = kp.CubicMotion(METRE, kp.Launch.apsides(0.04, 0.01)).tension(times)
        exact = kp.ExactMotion(METRE, kp.Launch.apsides(0.04, 0.01)).tension(times)
        # Off by the third order and what it makes of the phase.
        np.testing.assert_allclose(cubic, exact, rtol=1e-5)

    def test_span_knows_where_the_thread_goes_slack(self) -> None:
        launch = kp.Launch.angles(0.0, 0.0, 6.5)
        end = float(kp.ExactMotion(METRE, launch).slack_time)
        assert kp.RealMotion(METRE, launch).span == pytest.approx((-end, end), rel=1e-15)
        assert kp.RealMotion(METRE, launch, thread="rod").span == (-np.inf, np.inf)
        assert kp.RealMotion(METRE, launch, thread="flies").span == (0.0, np.inf)
        both = kp.RealMotion(METRE, kp.Launch.angles(0.0, 0.0, [1.0, 6.5]))
        assert both.span == pytest.approx((-end, end), rel=1e-15)

    def test_a_free_swing_has_no_end_and_needs_no_search(self) -> None:
        drag = kp.Drag(1e-3)
        motion = kp.RealMotion(METRE, kp.Launch.ellipse(0.3, 0.0), site=kp.Site(0.8), drag=drag)
        before = _core.steps_taken()
        assert motion.span[1] == np.inf
        # Backwards the drag gives: some ln(1/0.3)/γ earlier the bob came from above the support.
        assert -1600 < motion.span[0] < -1200
        assert motion.position(motion.span[0])[2] < 0
        assert _core.steps_taken() - before < 50_000

    def test_a_later_end_is_known_once_it_is_reached(self) -> None:
        """Beyond the search: backwards the drag lifts the bob, after some hours."""
        motion = kp.RealMotion(METRE, kp.Launch.ellipse(0.3, 0.0), drag=kp.Drag(4e-5))
        assert motion.span[0] == -np.inf
        with pytest.raises(kp.MotionEnded, match="goes slack at -"):
            motion.position(-1e5)
        assert -1e5 < motion.span[0] < -1e4

    def test_backwards_in_time_quadratic_drag_may_have_no_past(self) -> None:
        motion = kp.RealMotion(
            METRE, kp.Launch.angles(2.5, 0.3, 0.0, 3.0), drag=kp.Drag(0.0, 0.01), thread="rod"
        )
        first = motion.span[0]
        assert -1000 < first < -1
        with pytest.raises(kp.MotionEnded, match=rf"beyond all bounds towards {first:.6g}"):
            motion.position(first - 1.0)
        assert np.isfinite(motion.position(0.999 * first)).all()


INTERRUPTED = {
    "events of a swing that takes years to follow": (
        "kp.RealMotion(kp.Pendulum(0.83), kp.Launch.ellipse(0.03, 1e9)).events('outer', 0, 1e3)"
    ),
    "walk": (
        "kp.RealMotion(kp.Pendulum(1.0), kp.Launch.ellipse(0.1, 0.0), site=kp.Site(0.8))"
        ".walk().to(1e9)"
    ),
    "plane": "kp.PlaneMotion(kp.Pendulum(1.0), kp.Launch.ellipse(0.1, 0.05)).position(1e9)",
    "cubic": "kp.CubicMotion(kp.Pendulum(1.0), kp.Launch.ellipse(0.1, 0.05)).velocity(-1e9)",
    "ensemble": (
        "kp.RealMotion(kp.Pendulum(1.0), kp.Launch.ellipse(np.linspace(0.1, 0.2, 9), 0.0))"
        ".position(1e9)"
    ),
    "constructor": (
        "kp.RealMotion(kp.Pendulum(1.0), kp.Launch.ellipse(np.linspace(0.1, 0.2, 3 * 10**6), 0.01))"
    ),
}


@pytest.mark.parametrize("name", INTERRUPTED)
def test_ctrl_c_ends_what_lasts(name: str) -> None:
    script = (
        "import numpy as np, sys, time\n"
        "import kugelpendel as kp\n"
        "print('begun', flush=True)\n"
        "try:\n"
        f"    {INTERRUPTED[name]}\n"
        "except KeyboardInterrupt:\n"
        "    print(time.monotonic(), flush=True)\n"
        "    import os; os._exit(3)\n"
    )
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as one:
        assert one.stdout is not None
        assert one.stdout.readline() == "begun\n"
        time.sleep(1.5)
        sent = time.monotonic()
        os.kill(one.pid, signal.SIGINT)
        seen = one.stdout.readline()
        assert one.wait(30) == 3
    # 0.2 s, and what the scheduler of a busy machine takes.
    assert float(seen) - sent < 0.6
