"""The jobs in examples/ do what their comments say, within a few seconds."""

import math
import re
import time
from pathlib import Path

import pytest

NAMES = ["cone", "laboratory", "over-the-top", "pantheon"]


def test_every_example_is_tested(repository: Path) -> None:
    assert sorted(path.stem for path in (repository / "examples").glob("*.toml")) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_example(call, repository: Path, name: str) -> None:
    started = time.monotonic()
    outcome = call("run", repository / "examples" / f"{name}.toml")
    assert outcome.code == 0, outcome.err
    # "Within a few seconds": a third of it on a free machine.
    assert time.monotonic() - started < 10
    names = {path.name for path in Path("out", name).iterdir()}
    assert {"figure.png", "results.json"} < names


def test_pantheon_says_how_fast_the_ellipse_turns(call, repository: Path) -> None:
    results = call("run", repository / "examples/pantheon.toml", "--json").results
    assert results["motion"]["regime"] == "ellipse"
    # 3/8·ω0·ab/l² with the small-amplitude correction of physics.md, 7/32·a²/l² of it.
    assert results["formula_25"]["difference_percent"] == pytest.approx(-0.0439, abs=5e-4)
    assert results["motion"]["precession_deg_per_h"] == pytest.approx(0.1978, abs=5e-5)


def test_laboratory_formula_is_off_by_a_percent(call, repository: Path) -> None:
    results = call("run", repository / "examples/laboratory.toml", "--json").results
    assert abs(results["formula_25"]["difference_percent"]) == pytest.approx(1.1, abs=0.05)


def test_cone_keeps_its_height(call, repository: Path) -> None:
    path = repository / "examples/cone.toml"
    results = call("run", path, "--json").results
    assert results["motion"]["regime"] == "cone"
    stated = float(re.findall(r"rad/s = ([\d.]+) °/s", path.read_text(encoding="utf-8"))[0])
    exact = math.degrees(math.sqrt(9.80665 / math.cos(math.radians(40))))
    assert stated == round(exact, 3)
    assert math.degrees(results["launch"]["phi_rate_rad_per_s"]) == pytest.approx(stated, rel=1e-12)


def test_over_the_top_stays_taut_until_slowed_down(call, repository: Path, tmp_path: Path) -> None:
    path = repository / "examples/over-the-top.toml"
    results = call("run", path, "--json").results
    assert results["motion"]["highest_turning_point_m"] > 1.9
    assert not results["tension"]["goes_slack"]
    slower = tmp_path / "slower.toml"
    slower.write_text(path.read_text(encoding="utf-8").replace('"7.2 m/s"', '"6.8 m/s"'), "utf-8")
    assert call("run", slower, "--json").results["tension"]["goes_slack"]
