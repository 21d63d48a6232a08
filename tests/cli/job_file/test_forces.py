"""What swings and what acts on it, as a file says it."""

import math
from typing import Any

import pytest

import kugelpendel as kp
from kugelpendel.cli.job_file.entries import take_apart
from kugelpendel.cli.job_file.forces import read_forces
from kugelpendel.cli.job_file.schema import JOB

OTHERS = {"launch": {"kind": "at_rest", "theta": 0.1}, "output": {"duration": 1, "step": 1}}


def read(**tables: dict[str, Any]) -> tuple[kp.Pendulum, bool, kp.Forces]:
    given = {"pendulum": {"length": "20 m"}, **OTHERS, **tables}
    return read_forces(take_apart(given, JOB), given)


def test_nothing_but_a_pendulum() -> None:
    assert read() == (kp.Pendulum(20.0), False, kp.Forces())


def test_everything() -> None:
    pendulum, has_mass, found = read(
        site={"latitude": "48.846 deg", "height": "35 m"},
        drag={"linear": "1e-5 1/s", "quadratic": "1e-3 1/m"},
        suspension={"anisotropy": "1e-6 rad/s", "axis": "30 deg", "damping_anisotropy": "2e-6 1/s"},
        bob={"diameter": "20 cm", "density": "7.86 g/cm^3", "thread_mass": "100 g"},
        drive={"push": "1 mm/s", "radius": "20 cm"},
    )
    assert found.site == kp.Site(math.radians(48.846), height=35.0)
    assert pendulum.gravity == kp.Site(math.radians(48.846), height=35.0).gravity
    assert found.drag == kp.Drag(1e-5, 1e-3)
    assert found.suspension is not None
    assert found.suspension.values == pytest.approx((1e-6, math.pi / 6, 2e-6, 0.0))
    assert found.bob == kp.Bob(0.1, 7860.0, 0.1)
    assert has_mass
    assert pendulum.mass == kp.Bob(0.1, 7860.0).mass
    assert found.drive == kp.Drive(1e-3, radius=0.2)


def test_what_is_given_wins() -> None:
    pendulum, *_ = read(
        pendulum={"length": "20 m", "gravity": 9.81, "mass": "30 kg"},
        site={"latitude": "48 deg"},
        bob={"radius": "10 cm", "density": 7860},
    )
    assert pendulum == kp.Pendulum(20.0, 9.81, 30.0)


def test_gravity_of_the_site_moves_the_bob() -> None:
    pendulum, *_ = read(site={"latitude": "48 deg", "gravity": "9.8094 m/s^2"})
    assert pendulum.gravity == 9.8094


def test_ways_to_give_drag() -> None:
    pendulum = kp.Pendulum(20.0)
    quality = read(drag={"quality": 800, "quadratic": "1e-3 1/m"})[2].drag
    assert quality == kp.Drag(kp.Drag.from_quality(800, pendulum).linear, 1e-3)
    assert read(drag={"half_life": "2 h"})[2].drag == kp.Drag.from_half_life(7200.0)
    assert read(drag={"quadratic": 1e-3})[2].drag == kp.Drag(0.0, 1e-3)
    ball = {"radius": "10 cm", "density": 7860}
    tables = {"drag": {"from_bob": True, "thread_diameter": "1 mm"}, "bob": ball}
    heavy, _, estimate = read(**tables)
    assert estimate.drag == kp.Drag.from_bob(kp.Bob(0.1, 7860.0), heavy, thread_diameter=1e-3)


def test_two_periods() -> None:
    *_, found = read(suspension={"period_along": "8.97 s", "period_across": "8.98 s", "axis": 0.1})
    assert found.suspension == kp.Suspension.from_periods(8.97, 8.98, 0.1)


BALL = {"radius": "10 cm", "density": 7860}
REFUSED: list[tuple[dict[str, dict[str, Any]], str]] = [
    ({"sight": {}}, r"^\[sight\] is not known \(did you mean site\?\); a job has the tables"),
    ({"site": {}}, r'^\[site\] latitude is missing; write latitude = "48.85 deg"'),
    ({"site": {"latitude": "95 deg"}}, r'^\[site\] latitude = "95 deg" lies beyond a pole; write'),
    ({"site": {"latitude": 48.8}}, r"^\[site\] latitude = 48.8 lies beyond a pole"),
    ({"site": {"latitude": "48 m"}}, r"^\[site\] latitude .* is not an angle"),
    ({"site": {"latitude": 0.8, "longitude": 0.1}}, r"^\[site\] longitude is not known"),
    ({"site": {"latitude": 0.8, "gravity": -9.8}}, r"^\[site\] The site's gravity must be posi"),
    ({"site": {"latitude": 0.8, "height": "400 km"}}, r"^\[site\] The site's height must lie"),
    ({"drag": {"linear": "-1e-5 1/s"}}, r"^\[drag\] The linear drag must be finite and not neg"),
    ({"drag": {"quadratic": -1}}, r"^\[drag\] The quadratic drag must be finite and not negat"),
    ({"drag": {"linear": 1e-5, "quality": 800}}, r"^\[drag\] says one .*: linear, quality; give"),
    ({"drag": {"quality": "800"}}, r'^\[drag\] quality = "800" is not a plain number; write qu'),
    ({"drag": {"quality": True}}, r"^\[drag\] quality = true is not a plain number"),
    ({"drag": {"quality": 0}}, r"^\[drag\] The quality factor must be positive"),
    ({"drag": {"half_life": "0 h"}}, r"^\[drag\] The half life must be positive"),
    ({"drag": {"half_life": "2 m"}}, r'^\[drag\] half_life = "2 m" is not a time'),
    ({"drag": {"from_bob": True}}, r"^\[drag\] from_bob = true needs a table \[bob\]"),
    ({"drag": {"from_bob": "yes"}}, r"^\[drag\] from_bob = .* write true or false"),
    (
        {"drag": {"from_bob": True, "quadratic": 1e-3}, "bob": BALL},
        r"^\[drag\] quadratic does not go with from_bob = true",
    ),
    ({"drag": {"thread_diameter": "1 mm"}}, r"^\[drag\] thread_diameter goes with from_bob"),
    (
        {"suspension": {"anisotropy": 1e-6, "period_along": 8}},
        r"^\[suspension\] says one .*: anisotropy, period_along; .*, period_along \+ period_across",
    ),
    ({"suspension": {"period_along": "8 s"}}, r"^\[suspension\] period_across is missing"),
    (
        {"suspension": {"period_along": "8 s", "period_across": "-8 s"}},
        r"^\[suspension\] The period across the axis must be positive",
    ),
    ({"suspension": {"anisotropy": "1 Hz"}}, "does not say whether turns or radians"),
    ({"bob": {"density": 7860}}, r"^\[bob\] radius is missing"),
    ({"bob": {"radius": 0.1, "diameter": 0.2}}, r"^\[bob\] says one thing .*: radius, diameter"),
    ({"bob": {"radius": 0.1, "density": 1.0}}, r"^\[bob\] The bob's density must exceed"),
    ({"bob": {"radius": "21 m", "density": 7860}}, r"^\[bob\] The bob's radius must be less th"),
    ({"drive": {"push": 0.01}}, r"^\[drive\] A drive needs exactly one of phase and radius"),
    ({"drive": {"push": 0.01, "phase": "-5 deg"}}, r"^\[drive\] The drive's phase must lie"),
    ({"drive": {"radius": 0.1}}, r"^\[drive\] push is missing"),
    ({"drive": {"push": 0.01, "radius": "0 m"}}, r"^\[drive\] The drive's radius must be posi"),
]


@pytest.mark.parametrize(("tables", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_refused(tables: dict[str, dict[str, Any]], said: str) -> None:
    with pytest.raises(kp.InvalidInput, match=said):
        read(**tables)
