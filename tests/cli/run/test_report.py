"""What the terminal says, in every regime."""

import math
from typing import Any

ANGLES = {"kind": "angles"}


def lines(call, write, **changes: dict[str, Any]) -> dict[str, str]:
    """The report by the names of its rows, blanks squeezed; a repeated name keeps the first."""
    outcome = call("run", write(**changes))
    assert outcome.code == 0, outcome.err
    assert outcome.err == ""
    rows: dict[str, str] = {}
    for line in outcome.out.splitlines():
        rows.setdefault(line[:19].strip(), " ".join(line[19:].split()))
    assert all(len(line) <= 100 for line in outcome.out.splitlines())
    assert "nan" not in outcome.out
    return rows


def test_open_ellipse(call, write) -> None:
    rows = lines(call, write)
    assert rows["Pendulum"] == "1 m, 2 kg, g = 9.80665 m/s²"
    assert rows["Launch"] == "20 cm out, turning radii 20 cm and 10 cm"
    assert rows["Motion"] == "an ellipse between 20.00 cm and 10.00 cm from the vertical"
    assert rows["Small swings"] == "2.006409 s period 2π√(l/g)"
    assert rows["Swing period"] == "2.012743 s 2π/ω, there and back"
    assert rows["by formula (26)"] == "2.012709 s −0.0017 % against the exact one"
    assert rows["Radial period"] == "1.006372 s from one highest point to the next"
    assert rows["Sense"] == "counter-clockwise of the bob, seen from above"
    assert rows["Precession Ω"] == "+1.360693 °/s exact, counter-clockwise"
    assert rows["by formula (25)"] == "+1.345688 °/s −1.1 % against the exact one"
    assert rows["One full turn"] == "4.40952 min of the ellipse"
    assert rows["Largest angle"] == "11.537° from the vertical, at height 2.020 cm"
    assert rows["Tension"] == "19.4157 to 20.3095 N a thread never goes slack"


def test_clockwise(call, write) -> None:
    rows = lines(call, write, launch={"b": "-10 cm"})
    assert rows["Launch"].endswith("clockwise")
    assert rows["Sense"] == "clockwise of the bob, seen from above"
    assert rows["Precession Ω"] == "−1.360693 °/s exact, clockwise"
    assert rows["by formula (25)"] == "−1.345688 °/s −1.1 % against the exact one"


def test_slow_precession_is_in_degrees_an_hour(call, write) -> None:
    launch = {"kind": "ellipse", "a": "3 m", "b": "1 cm", "azimuth": "30 deg"}
    pendulum = {"length": "67 m", "gravity": 9.8094, "mass": "28 kg"}
    rows = lines(call, write, pendulum=pendulum, launch=launch)
    assert rows["Launch"] == "3 m out at azimuth 30°, pushed sideways with 3.826 mm/s (b = 1 cm)"
    assert rows["Precession Ω"] == "+0.1978306 °/h exact, counter-clockwise"
    assert rows["One full turn"] == "75.8224 d of the ellipse"


def test_plane_swing(call, write) -> None:
    launch = {"kind": "at_rest", "theta": "90 deg"}
    rows = lines(call, write, launch=launch, pendulum={"mass": None, "gravity": 9.8})
    assert rows["Launch"] == "let go 90° from straight down"
    assert rows["Motion"].startswith("swings to and fro in a vertical plane")
    # Complete elliptic integral K(1/2) = 1.854074677, times 4.
    period = 4 * 1.8540746773013719 / math.sqrt(9.8)
    assert rows["Swing period"] == f"{period:.6f} s 2π/ω, there and back"
    assert rows["Precession Ω"] == "0 exactly: the plane of the swing does not turn"
    assert "by formula (25)" not in rows
    assert "One full turn" not in rows
    assert rows["Tension"] == "0 to 29.4000 N for 1 kg; a thread never goes slack"


def test_slack(call, write) -> None:
    rows = lines(call, write, launch={"kind": "at_rest", "theta": "120 deg", "phi": "0.5 turn"})
    assert rows["Launch"] == "let go 120° from straight down at azimuth 180°"
    assert rows["Tension"].endswith("a thread goes slack at once, a rod goes on")
    launch = {"kind": "plane", "x": 0, "y": 0, "vx": "6 m/s", "vy": 0}
    rows = lines(call, write, launch=launch)
    assert rows["Tension"].endswith(" ms, a rod goes on")
    assert " a thread goes slack after " in rows["Tension"]


def test_over_the_top_in_a_plane(call, write) -> None:
    launch = {"kind": "plane", "x": 0, "y": 0, "vx": "8 m/s", "vy": 0}
    rows = lines(call, write, launch=launch)
    assert rows["Launch"] == "from x = 0 m, y = 0 m with vx = 8 m/s, vy = 0 m/s"
    assert rows["Motion"] == "turns over the top in a vertical plane"
    assert rows["Swing period"].endswith("2π/ω, once round")
    assert rows["Largest angle"].startswith("180°")
    assert "by formula (26)" not in rows


def test_over_the_top(call, write) -> None:
    launch = {"kind": "plane", "x": "10 cm", "y": 0, "vx": 0, "vy": "7.2 m/s"}
    rows = lines(call, write, launch=launch)
    assert rows["Motion"] == "rises above the support, between heights 5.013 mm and 1.980 m"
    assert rows["by formula (25)"].startswith("does not apply:")
    assert rows["Highest point"] == "−8.345324 °/s less whole turns"
    assert rows["One full turn"] == "43.1379 s of the highest point"


def test_above_the_support(call, write) -> None:
    launch = {**ANGLES, "theta": "80 deg", "phi_rate": "-300 deg/s", "theta_rate": "2 rad/s"}
    rows = lines(call, write, launch=launch)
    assert "+114.592 °/s outwards, −300 °/s about the vertical" in rows["Launch"]
    assert rows["Motion"].startswith("rises above the support")
    assert rows["Sense"].startswith("clockwise")


def test_cone(call, write) -> None:
    rows = lines(call, write, launch={"a": "10 cm", "b": "10 cm"})
    assert rows["Motion"].startswith("circles on a cone, 10.00 cm from the vertical")
    revolution = 2 * math.pi * math.sqrt(math.sqrt(0.99) / 9.80665)
    assert rows["One full turn"] == f"{revolution:.6f} s of the bob about the vertical"


def test_rest(call, write) -> None:
    rows = lines(call, write, launch={"kind": "at_rest", "theta": 0})
    assert rows["Motion"] == "hangs at rest"
    assert rows["Tension"] == "19.6133 N a thread never goes slack"
    assert "Swing period" not in rows
    assert "Precession Ω" not in rows


def test_balance(call, write) -> None:
    launch = {"kind": "state", "position": [0, 0, "-1 m"], "velocity": [0, 0, 0]}
    rows = lines(call, write, launch=launch)
    assert rows["Launch"] == "position (0 m, 0 m, −1 m), velocity (0 m/s, 0 m/s, 0 m/s)"
    assert rows["Motion"].startswith("stands at rest above the support")
    assert rows["Tension"] == "−19.6133 N a thread goes slack at once, a rod goes on"


def test_separatrix(call, write) -> None:
    launch = {"kind": "plane", "x": 0, "y": 0, "vx": "6 m/s", "vy": 0}
    rows = lines(call, write, launch=launch, pendulum={"gravity": 9})
    assert rows["Motion"] == "creeps up to the top and never comes back"
    assert rows["Swing period"] == "infinite ω = 0"
    assert "Precession Ω" not in rows


def test_results_of_what_never_comes_back_are_null(call, write) -> None:
    launch = {"kind": "plane", "x": 0, "y": 0, "vx": "6 m/s", "vy": 0}
    results = call("run", write(launch=launch, pendulum={"gravity": 9}), "--json").results
    assert results["motion"]["regime"] == "separatrix"
    assert results["motion"]["radial_period_s"] is None
    assert results["motion"]["swing_period_s"] is None
    assert results["formula_25"]["precession_rad_per_s"] is None
    assert results["formula_25"]["why_it_does_not_apply"] == "the motion never comes back"


def test_tiny_ellipse(call, write) -> None:
    rows = lines(call, write, launch={"a": "100 nm", "b": "30 nm"})
    assert rows["Motion"] == "an ellipse between 100.0 nm and 30.00 nm from the vertical"
    assert rows["by formula (25)"].endswith("% against the exact one") or rows[
        "by formula (25)"
    ].endswith("the same against the exact one")


def test_last_line_says_where_the_files_are(call, write) -> None:
    outcome = call("run", write(output={"figure": True, "duration": "1000 s"}))
    assert outcome.out.splitlines()[-1] == (
        "In out/job: track.csv (10 001 samples), figure.png, results.json"
    )
