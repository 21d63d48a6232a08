"""The example jobs, opened in the page by their links: the same numbers as in Python."""

import math
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.cli.explore.fragment import fragment_of
from kugelpendel.cli.job_file import schema
from kugelpendel.cli.job_file.job import Job, read_job

EXAMPLES = sorted((Path(__file__).parents[3] / "examples").glob("*.toml"))
REAL = ("guelph", "museum", "pantheon-day", "short", "short-remedy")

READ = "const one = engine.readLink(given.link).given;"


def same(one: object, other: object, digits: float = 1e-12) -> bool:
    """Whether two numbers agree, where JSON has null for what is not finite."""
    number = float("nan") if other is None else float(other)  # pyright: ignore[reportArgumentType]
    if one is None or not math.isfinite(number):
        return one is None and not math.isfinite(number)
    return math.isclose(float(one), number, rel_tol=digits, abs_tol=1e-15)  # pyright: ignore[reportArgumentType]


def compared(found: dict[str, Any], wanted: dict[str, object], digits: float = 1e-12) -> None:
    odd = {k: (found[k], v) for k, v in wanted.items() if not same(found[k], v, digits)}
    assert odd == {}


@pytest.fixture(params=EXAMPLES, ids=lambda path: path.stem)
def job(request: pytest.FixtureRequest) -> Job:
    return read_job(request.param)


def test_a_link_says_all_that_the_file_says(engine: Any, job: Job) -> None:
    found = engine("return engine.readLink(given.link);", {"link": fragment_of(job.file)})
    assert found["garbled"] is False
    assert found["duration"] == job.grid.duration
    settled = engine(f"{READ} return core.settled(one);", {"link": fragment_of(job.file)})
    effective = job.forces.effective_pendulum(job.pendulum)
    site, drag, clamp = job.forces.site, job.forces.drag, job.forces.suspension
    earth = 0.0 if site is None else -float(site.vertical_rotation)
    compared(
        settled | settled["drag"],
        {
            "length": job.pendulum.length,
            "gravity": job.pendulum.gravity,
            "effectiveGravity": effective.gravity,
            "mass": job.pendulum.mass,
            "angularFrequency": effective.angular_frequency,
            "earth": earth,
            "earthTurn": 2 * math.pi / abs(earth) if earth else math.inf,
            "linear": 0.0 if drag is None else drag.linear,
            "quadratic": 0.0 if drag is None else drag.quadratic,
            "anisotropy": 0.0 if clamp is None else clamp.anisotropy,
            "dampingAnisotropy": 0.0 if clamp is None else clamp.damping_anisotropy,
        },
        4e-16,
    )


def test_the_summary_is_that_of_python(engine: Any, job: Job) -> None:
    found = engine(f"{READ} return core.summary(one);", {"link": fragment_of(job.file)})
    motion = kp.ExactMotion(job.forces.effective_pendulum(job.pendulum), job.launch)
    summary = kp.IdealSummary.of(motion)
    assert found["regime"] == summary.regime
    assert found["wholeTurns"] is summary.whole_turns
    compared(
        found,
        {
            "sense": summary.sense,
            "swingPeriod": summary.swing_period,
            "radialPeriod": motion.radial_period,
            "apsidalAngle": motion.apsidal_angle,
            "turning": summary.turning,
            "fullTurn": summary.full_turn,
            "onceRound": summary.once_round,
            "largestAngle": summary.largest_angle,
            "formula25": summary.formula_25,
            "frequency26": summary.frequency_26,
            "periodError26": summary.period_error_26,
            "outer": summary.outer,
            "high": summary.high,
            "slackTime": summary.slack_time,
        },
        1e-9,
    )
    if summary.error_25 is not None:
        assert same(found["error25"], summary.error_25, 1e-9)
    least, most = summary.tension
    assert same(found["tension"][0], least)
    assert same(found["tension"][1], most)


@pytest.fixture(params=REAL)
def real(request: pytest.FixtureRequest) -> Iterator[Job]:
    (path,) = (path for path in EXAMPLES if path.stem == request.param)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        yield read_job(path)


def test_shares_and_portrait_are_those_of_python(engine: Any, real: Job) -> None:
    script = f"""{READ}
    const motion = core.motion(one, "averaged");
    const shares = given.times.map((time) => motion.shares(time));
    const ellipses = Array.from(motion.ellipses(Float64Array.from(given.times)));
    const portrait = core.portrait(one, motion.ellipse(0));
    const path = Array.from(portrait.path(portrait.form, 9));
    const verdicts = portrait.verdicts(Float64Array.from(path));
    motion.free();
    return {{ shares, ellipses, portrait, path, verdicts }};"""
    times = [0.0, 60.0, 3600.0]
    found = engine(script, {"link": fragment_of(real.file), "times": times})
    motion = kp.EnvelopeMotion(real.pendulum, real.launch, real.forces)
    budget = motion.rates(times)
    for index, shares in enumerate(found["shares"]):
        wanted = {name: getattr(budget, name)[index] for name in kp.motion.CAUSES}
        wanted |= {"total": budget.total[index], "outer": budget.outer[index]}
        compared(shares, wanted, 1e-7)
        assert shares["pace"] == budget.pace[index]
    ellipses = np.column_stack([motion.semi_axes(times), motion.azimuth(times)])
    assert np.array(found["ellipses"]).reshape(3, 3) == pytest.approx(ellipses, rel=1e-9, abs=1e-12)

    portrait = kp.Portrait.of(motion)
    orbit = found["portrait"]["orbit"]
    assert orbit["verdict"] == portrait.orbit.verdict
    assert set(found["verdicts"]) <= {portrait.orbit.verdict, "stands"}
    compared(
        orbit | found["portrait"]["form"],
        {
            "circularity": portrait.orbit.circularity,
            "longitude": portrait.orbit.longitude,
            "period": portrait.orbit.period,
            "rate": portrait.orbit.rate,
            "slowest": portrait.orbit.slowest,
            "fastest": portrait.orbit.fastest,
        },
        1e-6,
    )
    assert len(found["portrait"]["equilibria"]) == len(portrait.equilibria)
    circularity, longitude = portrait.path(9)
    path = np.array(found["path"]).reshape(9, 2)
    assert path[:, 0] == pytest.approx(circularity, abs=1e-9)
    assert np.cos(path[:, 1]) == pytest.approx(np.cos(longitude), abs=1e-6)


def test_what_the_plane_comes_to_is_that_of_the_builder(engine: Any, real: Job) -> None:
    found = engine(f"{READ} return core.settles(one);", {"link": fragment_of(real.file)})
    motion = kp.EnvelopeMotion(real.pendulum, real.launch, real.forces)
    a, b = motion.semi_axes(0.0)
    answers = kp.design(
        real.pendulum, a, b, azimuth=float(motion.azimuth(0.0)), forces=real.forces, checked=False
    )
    if found is None:
        assert "settled_rate" not in answers
        return
    rate = found["turned"] / (found["until"] - found["from"])
    assert rate == pytest.approx(answers["settled_rate"].value, rel=1e-3)


def test_the_keys_of_links_are_those_of_job_files(engine: Any) -> None:
    found = engine("return { tables: engine.TABLES, launches: engine.LAUNCHES };")
    for section in schema.JOB.sections:
        keys = {key.name for key in section.keys}
        if section.name == "launch":
            ways = {way.word: set(way.keys) for way in section.ways}
            assert {kind: set(names) for kind, names in found["launches"].items()} == ways
        elif section.name == "output":
            assert set(found["tables"]["output"]) == {"duration"}
        else:
            assert set(found["tables"][section.name]) == keys
    assert set(found["tables"]) == {section.name for section in schema.JOB.sections} - {"launch"}


def test_a_saved_job_runs(engine: Any, job: Job, tmp_path: Path) -> None:
    link = fragment_of(job.file)
    saved = tmp_path / "saved.toml"
    script = f"{READ} return engine.writeJobFile(one, given.duration);"
    saved.write_text(engine(script, {"link": link, "duration": job.grid.duration}))
    again = read_job(saved)
    assert again.grid.duration == pytest.approx(job.grid.duration, rel=1e-15)
    for kept, part in ((again.pendulum, job.pendulum), (again.launch, job.launch)):
        assert kept.values == pytest.approx(part.values, rel=1e-15)
    assert set(again.forces.parts) == set(job.forces.parts)
    for name, part in job.forces.parts.items():
        assert again.forces.parts[name].values == pytest.approx(part.values, rel=1e-15, nan_ok=True)
