"""The stored reference motions are sound, and are what their generator computes."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import mpmath
import pytest

mp: Any = mpmath.mp.clone()
mp.dps = 50
# The stored numbers have 25 digits, and a height is a difference of two of them.
ROUNDING = mp.mpf("4e-24")


@pytest.fixture(scope="module")
def stored(repository: Path) -> list[dict[str, Any]]:
    text = (repository / "tests" / "reference" / "ideal.json").read_text()
    return json.loads(text)["cases"]


def generator(repository: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = (sys.executable, "-m", "references.generate", *arguments)
    return subprocess.run(command, cwd=repository, capture_output=True, text=True, check=False)


def test_generator_computes_what_is_stored(repository: Path) -> None:
    names = ("tiny-1e-8-1", "conical-5", "above-equator-12", "near-separatrix-1", "separatrix-0")
    done = generator(repository, "--check", *names)
    assert done.returncode == 0, done.stdout + done.stderr


def test_generator_agrees_with_the_shared_references(repository: Path, shared: Path) -> None:
    # Every fourth of the 52 cases: one of each of their 13 regimes.
    golden = shared / "golden" / "ideal.json"
    done = generator(repository, "--against", str(golden), "--step", "4")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "13 cases" in done.stdout


def test_generator_reports_a_difference(
    repository: Path, tmp_path: Path, stored: list[dict[str, Any]]
) -> None:
    case = next(dict(case) for case in stored if case["id"] == "separatrix-0")
    case["position"] = [["0.001", "0", "1"], *case["position"][1:]]
    (tmp_path / "wrong.json").write_text(json.dumps({"cases": [case]}))
    done = generator(repository, "--against", str(tmp_path / "wrong.json"))
    assert done.returncode == 1
    assert "largest difference 1.0e-03" in done.stdout


def test_there_are_enough_cases_with_names_of_their_own(stored: list[dict[str, Any]]) -> None:
    assert len(stored) >= 200
    assert len({case["id"] for case in stored}) == len(stored)


def test_states_lie_on_the_sphere_with_the_stored_invariants(stored: list[dict[str, Any]]) -> None:
    for case in stored:
        length, gravity = mp.mpf(case["length"]), mp.mpf(case["gravity"])
        energy, momentum = mp.mpf(case["energy_above_bottom"]), mp.mpf(case["angular_momentum"])
        for position, velocity in zip(case["position"], case["velocity"], strict=True):
            x, y, z = (mp.mpf(text) for text in position)
            u, v, w = (mp.mpf(text) for text in velocity)
            speed = mp.sqrt(gravity * length + u * u + v * v + w * w)
            where = f"{case['id']}: {position}"
            assert abs(mp.sqrt(x * x + y * y + z * z) - length) < ROUNDING * length, where
            assert abs(x * u + y * v + z * w) < ROUNDING * length * speed, where
            kinetic = (u * u + v * v + w * w) / 2
            assert abs(kinetic + gravity * (length - z) - energy) < ROUNDING * speed**2, where
            assert abs(x * v - y * u - momentum) < ROUNDING * length * speed, where


def test_frequency_of_plane_motions(stored: list[dict[str, Any]]) -> None:
    # Gauss: half a libration takes pi / (ω0 agm(1, cos(θ0/2))), one revolution over the top
    # 2 pi / (ω0 sqrt(2ε) agm(1, sqrt(1 − 2/ε))), ε the energy / (gravity length).
    seen = 0
    for case in stored:
        if case["motion"] != "plane":
            continue
        length, gravity = mp.mpf(case["length"]), mp.mpf(case["gravity"])
        reduced = mp.mpf(case["energy_above_bottom"]) / gravity / length
        if abs(reduced - 2) < 1e-6:
            continue
        rate = mp.sqrt(gravity / length)
        if reduced < 2:
            expected = rate * mp.agm(1, mp.sqrt(1 - reduced / 2))
        else:
            expected = rate * mp.sqrt(2 * reduced) * mp.agm(1, mp.sqrt(1 - 2 / reduced))
        assert abs(mp.mpf(case["frequency"]) / expected - 1) < 1e-18, case["id"]
        assert case["precession"] == "0"
        seen += 1
    assert seen > 30


def test_precession_of_cones(stored: list[dict[str, Any]]) -> None:
    seen = 0
    for case in stored:
        if case["motion"] != "cone":
            continue
        length, gravity = mp.mpf(case["length"]), mp.mpf(case["gravity"])
        cosine = mp.mpf(case["position"][0][2]) / length
        turn = mp.sqrt(gravity / length / cosine)
        expected = turn - mp.sqrt(gravity / length * (1 + 3 * cosine**2) / cosine) / 2
        sense = mp.sign(mp.mpf(case["angular_momentum"]))
        gap = abs(sense * mp.mpf(case["precession"]) - expected)
        assert gap < 1e-24 * turn, case["id"]
        seen += 1
    assert seen >= 12


@pytest.mark.parametrize("equation", ["cubic", "drag"])
def test_the_motions_of_other_equations_are_those_of_their_generator(
    repository: Path, equation: str
) -> None:
    command = (sys.executable, "-m", f"references.equations.{equation}", "1")
    made = subprocess.run(
        command, cwd=repository, capture_output=True, text=True, check=True
    ).stdout
    stored = json.loads((repository / "tests" / "reference" / f"{equation}.json").read_text())
    assert json.loads(made)["times"] == stored["times"]
    assert json.loads(made)["cases"] == stored["cases"][:1]
