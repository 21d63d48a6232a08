"""The explorer's page in the browser: what the physics of a frame takes."""

from __future__ import annotations

import sys
from pathlib import Path

from report import Ratio, Section

sys.path.insert(0, str(Path(__file__).parents[2]))  # for the engine that the tests open

from tests.cli.explore.browsing import Engine, running

BUDGET = 1e-3  # s, of the 16.7 ms between two frames
TIMES = {"at the launch": 0.0, "at 10 min": 600.0, "at 24 h": 86_400.0}
LAUNCH = {
    "pendulum": {"length": 1.0},
    "launch": {"kind": "plane", "x": 0.45, "y": 0.0, "vx": 0.0, "vy": 0.5},
}

FRAMES = """
const laws = ["exact", "ellipse", "linear", "cubic"];
const motions = laws.map((law) => core.motion(given.launch, law));
const traces = motions.map((motion) => motion.trace(0.003, 10000));
for (const trace of traces) while (!trace.follow(given.start));
let frame = 0;
const perFrame = [];
for (let interval = 0; interval < 25; interval++) {
  const before = performance.now();
  for (let count = 0; count < 240; count++) {
    frame += 1;
    for (const trace of traces) trace.follow(given.start + frame / 60);
  }
  perFrame.push((performance.now() - before) / 240);
}
traces.forEach((trace) => trace.free());
motions.forEach((motion) => motion.free());
return perFrame.sort((one, other) => one - other)[12] / 1000;
"""

WHOLE = """
const motion = core.motion(given.launch, "exact");
const took = [];
for (let round = 0; round < 25; round++) {
  const before = performance.now();
  for (let count = 0; count < 20; count++) motion.drawn(given.start + count, 0.003, 10000);
  took.push((performance.now() - before) / 20);
}
motion.free();
return took.sort((one, other) => one - other)[12] / 1000;
"""


def measure() -> Section:
    with running() as engine:
        ratios = [frame(engine, when, start) for when, start in TIMES.items()]
        whole = engine(WHOLE, {"launch": LAUNCH, "start": 86_400.0})
    ratios.append(
        Ratio("10 000 points of the exact motion drawn anew", "1 ms", whole, BUDGET, whole / BUDGET)
    )
    notes = [
        "A frame: the bob and the trace of the exact motion, (20), (16) and (13), each trace of "
        "10 000 points, go on by 1/60 s. Medians of 25 intervals of 240 frames, since the clock of "
        "a browser ticks every 0.1 ms.",
    ]
    return Section("The explorer's page", ratios, (), notes)


def frame(engine: Engine, when: str, start: float) -> Ratio:
    """The physics of one frame, beside what it may take."""
    seconds = engine(FRAMES, {"launch": LAUNCH, "start": start})
    work = f"a frame with 4 motions, {when}"
    return Ratio(work, "1 ms", seconds, BUDGET, seconds / BUDGET, 1.0)
