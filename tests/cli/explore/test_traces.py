"""Traces and frames in the page: what is drawn is where the bob was, and memory stays as it is."""

from typing import Any

import numpy as np
import pytest

import kugelpendel as kp

ROSETTE = {
    "pendulum": {"length": 2.0},
    "launch": {"kind": "plane", "x": 0.9, "y": 0.0, "vx": 0.0, "vy": 0.7},
}
LAWS = ("exact", "linear", "cubic", "real")
SPACING, CAPACITY = 0.013, 64

FOLLOW = """
const motion = core.motion(given.job, given.law);
const trace = motion.trace(given.spacing, given.capacity);
const seen = given.times.map((time) => {
  while (!trace.follow(time));
  const { head, count, capacity, changedFrom, points } = trace;
  return { head, count, capacity, changedFrom, points: Array.from(points) };
});
trace.free();
motion.free();
return seen;
"""


def in_order(seen: dict[str, Any]) -> np.ndarray:
    """The points of a ring that are filled, from the oldest to the bob."""
    points = np.array(seen["points"]).reshape(-1, 3)
    assert len(points) == seen["capacity"] + 1
    assert (points[-1] == points[0]).all()
    places = (seen["head"] - np.arange(seen["count"])[::-1]) % seen["capacity"]
    return points[places]


def wanted(motion: kp.Motion, time: float, count: int) -> np.ndarray:
    """The same from Python: x, y in lengths and 1 − cos θ."""
    newest = int(time / SPACING)
    times = [*(SPACING * np.arange(newest - count + 2, newest + 1)), time]
    x, y, z = motion.position(times).T / 2.0
    return np.stack([x, y, 1 - z], axis=-1)


@pytest.mark.parametrize("law", LAWS)
def test_a_trace_is_where_the_bob_was(engine: Any, law: str) -> None:
    # On, on by a part of a spacing, beyond the ring's length, back, on again, and far ahead.
    times = [0.0, 0.1, 0.105, 0.7, 3.0, 3.02, 3.1, 1.0, 1.001, 1.5, 70.0, 70.01]
    given = {"job": ROSETTE, "law": law, "spacing": SPACING, "capacity": CAPACITY, "times": times}
    pendulum, launch = kp.Pendulum(2.0), kp.Launch.plane(0.9, 0.0, 0.0, 0.7)
    motion = {
        "exact": kp.ExactMotion,
        "linear": kp.LinearMotion,
        "cubic": kp.CubicMotion,
        "real": kp.RealMotion,
    }[law](pendulum, launch)
    before = np.zeros(3 * (CAPACITY + 1))
    for time, seen in zip(times, engine(FOLLOW, given), strict=True):
        assert seen["count"] == min(int(time / SPACING) + 2, CAPACITY), time
        points = in_order(seen)
        assert np.abs(points - wanted(motion, time, seen["count"])).max() < 2e-7, time
        # What is not said to have changed has not.
        after = np.array(seen["points"])
        changed = np.flatnonzero((after != before).reshape(-1, 3)[:-1].any(axis=1))
        told = (seen["head"] - seen["changedFrom"]) % CAPACITY
        assert ((seen["head"] - changed) % CAPACITY <= told).all(), time
        before = after


def test_a_narrow_ellipse_on_a_long_wire_keeps_its_digits(engine: Any) -> None:
    job = {"pendulum": {"length": 67.0}, "launch": {"kind": "apsides", "a": 0.01, "b": 0.003}}
    script = """
    const motion = core.motion(given, "exact");
    const drawn = motion.drawn(1.0, 0.25, 100);
    motion.free();
    return Array.from(drawn);
    """
    drawn = np.array(engine(script, job)).reshape(-1, 3)
    motion = kp.ExactMotion(kp.Pendulum(67.0), kp.Launch.apsides(0.01, 0.003))
    x, y, _ = motion.position(1.0 + 0.25 * np.arange(100)).T / 67.0
    square = x**2 + y**2
    height = square / (1 + np.sqrt(1 - square))
    assert drawn[:, 0] == pytest.approx(x, rel=1e-7, abs=1e-12)
    assert drawn[:, 2] == pytest.approx(height, rel=1e-7)


def test_a_trace_ends_with_its_motion(engine: Any) -> None:
    job = {"pendulum": {"length": 1.0}, "launch": {"kind": "at_rest", "theta": 2.0}}
    script = """
    const motion = core.motion(given, "real");
    const trace = motion.trace(0.01, 100);
    const followed = trace.follow(5);
    const answer = { followed, ended: motion.ended, state: motion.state(5) };
    trace.free();
    motion.free();
    return answer;
    """
    found = engine(script, job)
    end = kp.RealMotion(kp.Pendulum(1.0), kp.Launch.at_rest(2.0)).span[1]
    assert found["followed"] is False
    assert found["state"] is None
    assert found["ended"]["why"] == "slack"
    assert found["ended"]["time"] == pytest.approx(end, abs=1e-12)


def test_a_long_way_is_gone_by_and_by(engine: Any) -> None:
    script = """
    const motion = core.motion(given, "cubic");
    let calls = 0;
    while (!motion.reach(20000)) calls += 1;
    const place = motion.state(20000).position;
    motion.free();
    return { calls, place };
    """
    found = engine(script, ROSETTE)
    motion = kp.CubicMotion(kp.Pendulum(2.0), kp.Launch.plane(0.9, 0.0, 0.0, 0.7))
    assert found["calls"] > 3
    assert found["place"] == pytest.approx(motion.position(20000.0), abs=1e-7)


def test_memory_does_not_grow_from_frame_to_frame(engine: Any) -> None:
    script = """
    const before = core.memory.buffer.byteLength;
    const motions = ["exact", "linear", "cubic", "real"].map((law) => core.motion(given, law));
    const traces = motions.map((motion) => motion.trace(0.003, 10000));
    for (let frame = 0; frame < 36000; frame++) {
      for (const trace of traces) if (!trace.follow(frame / 60)) throw new Error("lost");
    }
    const after = core.memory.buffer.byteLength;
    const bob = ({ points, head }) => Array.from(points.subarray(3 * head, 3 * head + 3));
    const [exact, , , real] = traces.map(bob);
    traces.forEach((trace) => trace.free());
    motions.forEach((motion) => motion.free());
    // Motions that come and go leave nothing behind.
    for (let launch = 0; launch < 2000; launch++) {
      const motion = core.motion(given, "real");
      motion.state(1);
      motion.free();
    }
    return { before, after, later: core.memory.buffer.byteLength, exact, real };
    """
    found = engine(script, ROSETTE)
    assert found["before"] == found["after"] == found["later"]
    assert found["exact"] == pytest.approx(found["real"], abs=1e-6)


def test_what_is_refused_is_told_by_kind_and_values(engine: Any) -> None:
    script = """
    return given.map((one) => {
      try { core.motion(one, "linear").free(); return null; } catch (error) { return error; }
    }).map((error) => error && { kind: error.kind, seen: error.seen });
    """
    good = {
        "pendulum": {"length": 1.0},
        "launch": {"kind": "plane", "x": 0.1, "y": 0, "vx": 0, "vy": 0},
    }
    wide = good | {"launch": {"kind": "plane", "x": 2.0, "y": 0, "vx": 0, "vy": 0}}
    long = good | {"pendulum": {"length": -1.0}}
    high = good | {"launch": {"kind": "at_rest", "theta": 2.0}}
    found = engine(script, [good, wide, long, high])
    assert found[0] is None
    assert found[1] == {
        "kind": "plane_too_wide",
        "seen": [
            {"name": "radius", "value": 2, "unit": "m"},
            {"name": "length", "value": 1, "unit": "m"},
        ],
    }
    assert found[2]["kind"] == "not_positive"
    assert found[2]["seen"] == [{"name": "pendulum.length", "value": -1, "unit": "m"}]
    assert found[3]["kind"] == "above_support"


def test_a_hand_points_at_the_nearest_place(engine: Any) -> None:
    script = """
    const place = core.nearestPlace(2, [10, 0, 1], [-1, 0, 0]);
    const launch = core.nearestState(2, [place[0], place[1] + 0.2, place[2]], [0, 1, 1]);
    const job = { pendulum: { length: 2 }, launch };
    return { place, launch, sense: core.summary(job).sense };
    """
    found = engine(script)
    assert found["place"] == pytest.approx([3**0.5, 0, 1])
    position, velocity = (np.array(found["launch"][name]) for name in ("position", "velocity"))
    assert np.linalg.norm(position) == pytest.approx(2, rel=1e-15)
    assert position @ velocity == pytest.approx(0, abs=1e-15)
    assert found["sense"] == 1
