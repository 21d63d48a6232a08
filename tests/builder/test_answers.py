"""What a builder asks: every answer against its check, and against figures found elsewhere."""

import math

import pytest

import kugelpendel as kp

SITE = kp.Site(math.radians(50.0))
BOB = kp.Bob(0.12, 7860.0, 0.28)
PENDULUM = kp.Pendulum(20.0, SITE.gravity, BOB.mass)
MUSEUM = kp.design(
    PENDULUM, 1.0, 0.005, azimuth=0.4, site=SITE, drag=kp.Drag(1e-4, 1e-6),
    suspension=kp.Suspension(2e-6, 0.5, 1e-5, -0.3), bob=BOB, drive=kp.Drive(5e-4, radius=0.25),
    wire=kp.Wire(1.5e-3), radius=0.2, time=0.5,
)  # fmt: skip

GOOD: dict[str, float] = {
    # Relative differences, or over the scale of the check; each some times what is seen.
    "Period of the swing": 2e-6,
    "Foucault rate": 1e-7,
    "Intrinsic rate, exact": 1e-8,
    "Largest b for 1 %": 1e-3,
    "Ellipse of a release from rest": 1e-3,
    "Rate after a release from rest": 2e-6,
    "Rate at the start": 2e-3,
    "Amplitude after the time asked": 1e-3,
    "Damping anisotropy that stalls": 2e-3,
    "Slowest turning by the anisotropy": 2e-3,
    "Fastest turning by the anisotropy": 2e-3,
    "Ellipse that the anisotropy opens": 3e-3,
    "Slowest turning by the damping": 1e-3,
    "Fastest turning by the damping": 1e-3,
    "Turning under the best push": 5e-3,
    "Growth under the best push": 2e-3,
    "Turning under the best pull": 5e-3,
    "Growth under the best pull": 2e-2,
    "Turning under a push too early": 5e-2,
    "Growth under a push too early": 5e-3,
    "Turning under a push too late": 2e-2,
    "Growth under a push too late": 5e-3,
    "Turning under a push too weak": 3e-2,
    "Growth under a push too weak": 1e-2,
    "Turning under a push too strong": 0.1,
    "Growth under a push too strong": 3e-2,
    "Turning under the drive given": 2e-2,
    "Growth under the drive given": 1e-2,
    "Time to pass the radius": 1e-12,
    "Radius at the time": 1e-12,
    "Least tension": 1e-3,
    "Largest tension": 1e-3,
}


@pytest.mark.parametrize("name", GOOD)
def test_formula_is_what_the_full_equations_give(name: str) -> None:
    check = MUSEUM[name].check
    assert check is not None
    assert check.relative is not None
    assert abs(check.relative) < GOOD[name]


def test_every_check_is_tested() -> None:
    assert {answer.name for answer in MUSEUM.answers if answer.check is not None} == set(GOOD)


def test_every_answer_says_where_it_comes_from() -> None:
    names = [answer.name for answer in MUSEUM.answers]
    assert len(set(names)) == len(names)
    for answer in MUSEUM.answers:
        assert math.isfinite(answer.value)
        assert answer.formula
        assert any(word in answer.source for word in ("(19", "(18", "docs/design.md", "§", "law",
                                                      "TR8350"))  # fmt: skip


def test_corrections_add_up_to_the_period() -> None:
    names = ("Amplitude, exact", "Width of the ellipse", "Bob's radius", "Thread's mass",
             "Buoyancy", "Air that moves along", "Linear drag", "Turning of the Earth",
             "Suspension")  # fmt: skip
    total = 1 + sum(MUSEUM[name].value for name in names)
    small = MUSEUM["Period of small swings"].value
    assert MUSEUM["Period of the swing"].value / small == pytest.approx(total, abs=1e-6)


def test_pantheon() -> None:
    # 67 m, 28 kg, 3 m: 16.5 s, 11.3°/h, a turn in 31.8 h (J. B. L. Foucault's of 1851).
    site = kp.Site(math.radians(48 + 52 / 60))
    found = kp.design(kp.Pendulum(67.0, site.gravity, 28.0), 3.0, site=site, checked=False)
    assert found["Period of the swing"].value == pytest.approx(16.4, abs=0.1)
    assert math.degrees(found["Foucault rate"].value) * 3600 == pytest.approx(-11.3, abs=0.05)
    assert found["One turn by the Earth"].value / 3600 == pytest.approx(31.8, abs=0.05)


def test_shares_are_the_rate() -> None:
    shares = [a.value for a in MUSEUM.answers if a.name.startswith("Share of the")]
    assert sum(shares) == pytest.approx(MUSEUM["Rate at the start"].value)
    assert sum(MUSEUM.rates.values()) == pytest.approx(MUSEUM["Rate at the start"].value)


def test_largest_b_has_its_share() -> None:
    found = kp.design(PENDULUM, 1.0, site=SITE, share=0.05, checked=False)
    b = found["Largest b for 5 %"].value
    again = kp.design(PENDULUM, 1.0, b, site=SITE, checked=False)
    assert again["Intrinsic over Foucault rate"].value == pytest.approx(0.05, rel=1e-3)
    # Pushed with the one speed or the other, and seen from a frame that does not turn.
    omega, earth = float(PENDULUM.angular_frequency), float(SITE.vertical_rotation)
    for name, sign in (("least", -1), ("most", 1)):
        speed = found[f"Sideways speed for 5 %, {name}"].value
        assert (speed + earth * 1.0) / omega == pytest.approx(sign * b)


@pytest.mark.parametrize("azimuth", [0.0, 0.7, math.pi / 2, math.pi, -math.pi / 2])
def test_release_from_rest_depends_on_the_direction(azimuth: float) -> None:
    # The bob's fall and rise make the Coriolis force push it across a swing that is not east-west.
    found = kp.design(PENDULUM, 2.0, azimuth=azimuth, site=SITE)
    earth, level = float(SITE.vertical_rotation), float(SITE.horizontal_rotation)
    known = -earth * (1 - 3 / 8 * 0.01) - level * 0.1**3 / 4 * math.sin(azimuth)
    rate = found["Rate after a release from rest"]
    assert rate.value == pytest.approx(known, rel=1e-12)
    assert rate.check is not None
    assert rate.check.measured == pytest.approx(known, rel=1e-5)
    straight = found["Foucault rate"].check
    assert straight is not None
    assert straight.measured == pytest.approx(-earth, rel=1e-6)


def test_south_turns_the_other_way() -> None:
    south = kp.design(PENDULUM, 1.0, site=kp.Site(math.radians(-50.0)),
                      suspension=kp.Suspension(2e-6, 0.5, 1e-5, -0.3))  # fmt: skip
    for name in ("Foucault rate", "Slowest turning by the anisotropy",
                 "Fastest turning by the damping"):  # fmt: skip
        assert south[name].value > 0
        check = south[name].check
        assert check is not None
        assert check.measured == pytest.approx(south[name].value, rel=3e-3)
    assert south["Ellipse of a release from rest"].value < 0


def test_equator_never_turns() -> None:
    found = kp.design(PENDULUM, 1.0, site=kp.Site(0.0))
    assert found["One turn by the Earth"].value == math.inf
    assert found["Foucault rate"].value == 0
    with pytest.raises(kp.InvalidInput, match="no answer 'Critical amplitude'; it has Period of"):
        found["Critical amplitude"]


def test_a_swing_turns_back_above_the_critical_amplitude_only() -> None:
    # The closed form with a start where the suspension does its worst.
    # Large enough for b ≪ a.
    stiff = kp.Suspension(1.2e-6, 0.0)
    pendulum = kp.Pendulum(20.0, SITE.gravity)
    wanted = kp.design(pendulum, 0.5, site=SITE, suspension=stiff, checked=False)
    critical = wanted["Critical amplitude"].value
    for share, turns_back in ((0.95, False), (1.05, True)):
        found = kp.design(
            pendulum, share * critical, azimuth=math.pi / 2, site=SITE, suspension=stiff
        )
        slowest = found["Slowest turning by the anisotropy"]
        assert slowest.check is not None
        assert (slowest.value > 0) is turns_back
        scale = abs(found["Fastest turning by the anisotropy"].value)
        assert slowest.check.measured == pytest.approx(slowest.value, abs=0.02 * scale)


def test_damping_stalls_at_twice_the_rotation() -> None:
    critical = MUSEUM["Damping anisotropy that stalls"].value
    for share, stalls in ((0.9, False), (1.1, True)):
        uneven = kp.Suspension(0.0, 0.0, share * critical, 0.0)
        found = kp.design(PENDULUM, 1.0, site=SITE, suspension=uneven)
        slowest = found["Slowest turning by the damping"]
        assert slowest.check is not None
        assert (slowest.value == 0) is stalls
        earth = float(SITE.vertical_rotation)
        assert (abs(slowest.check.measured) < 0.1 * earth) is stalls


@pytest.mark.parametrize(
    ("linear", "quadratic"), [(1e-4, 0.0), (0.0, 1e-3), (1e-4, 1e-3), (1e-12, 1e-3)]
)
def test_decay_is_its_own_inverse(linear: float, quadratic: float) -> None:
    found = kp.design(PENDULUM, 1.0, drag=kp.Drag(linear, quadratic), checked=False)
    for name, share in (("half the amplitude", 0.5), ("1/e of the amplitude", 1 / math.e)):
        time = found[f"Time to {name}"].value
        assert found.amplitude(time) == pytest.approx(share, rel=1e-12)
    # a' = −γa − ka², by a difference quotient.
    omega = float(PENDULUM.angular_frequency)
    rate = (found.amplitude(1.0) - found.amplitude(-1.0)) / 2
    assert rate == pytest.approx(-linear - 4 / (3 * math.pi) * quadratic * omega, rel=1e-5)


def test_quality_and_half_life_are_the_ones_given() -> None:
    drag = kp.Drag.from_quality(800.0, PENDULUM)
    found = kp.design(PENDULUM, 1.0, drag=drag, checked=False)
    assert found["Quality of the linear drag"].value == pytest.approx(800)
    half = kp.design(PENDULUM, 1.0, drag=kp.Drag.from_half_life(5e3), checked=False)
    assert half["Time to half the amplitude"].value == pytest.approx(5e3)


def test_pushes_that_are_wrong_do_what_one_expects() -> None:
    def measured(name: str) -> float:
        check = MUSEUM[name].check
        assert check is not None
        return check.measured

    # b > 0: the ellipse turns by itself counter-clockwise, and the push turns it back.
    assert (
        measured("Turning under a push too early") < 0 < measured("Turning under a push too late")
    )
    assert measured("Turning under a push too strong") < 0
    assert measured("Turning under a push too weak") > 0
    assert measured("Growth under a push too weak") < 0 < measured("Growth under a push too strong")
    strong = MUSEUM["Amplitude under a push too strong"].value
    assert strong > 1 > MUSEUM["Amplitude under a push too weak"].value


def test_drive_that_takes_energy_away_and_one_that_never_ends() -> None:
    def amplitude(push: float) -> kp.Answer:
        found = kp.design(PENDULUM, 1.0, drag=kp.Drag(1e-4), drive=kp.Drive(push, phase=0.5),
                          checked=False)  # fmt: skip
        return found["Amplitude under the drive given"]

    assert amplitude(-1e-3).note == "the push takes energy away"
    assert amplitude(-1e-3).value == 0
    assert amplitude(1.0).note == "beyond the length: it pumps without end, and is not run"
    pumped = kp.design(PENDULUM, 1.0, drag=kp.Drag(1e-4), drive=kp.Drive(1.0, phase=0.5))
    assert pumped["Growth under the drive given"].check is None
    assert pumped["Growth under the best push"].check is not None


def test_passage_of_a_plane_swing() -> None:
    # For small swings ρ = a sin ωt.
    found = kp.design(kp.Pendulum(20.0), 1e-3, radius=5e-4, time=0.3, checked=False)
    omega = math.sqrt(9.80665 / 20)
    assert found["Time to pass the radius"].value == pytest.approx(math.pi / 6 / omega)
    assert found["Time within the radius"].value == pytest.approx(math.pi / 3 / omega)
    assert found["Radius at the time"].value == pytest.approx(1e-3 * math.sin(0.3 * omega))
    assert found["Speed at the radius"].value == pytest.approx(
        1e-3 * omega * math.sqrt(0.75), rel=1e-6
    )


def test_wire() -> None:
    pendulum = kp.Pendulum(10.0, 9.8, 50.0)
    found = kp.design(pendulum, 2.0, wire=kp.Wire(2e-3, 1.9e11, 1.1e-5), checked=False)
    cosine = math.sqrt(1 - 0.2**2)
    assert found["Least tension"].value == pytest.approx(490 * cosine)
    assert found["Largest tension"].value == pytest.approx(490 * (3 - 2 * cosine))
    area = math.pi * 1e-6
    assert found["Largest stress"].value == pytest.approx(490 * (3 - 2 * cosine) / area)
    assert found["Stretch at rest"].value == pytest.approx(490 * 10 / (1.9e11 * area))
    assert found["Lengthening by a kelvin"].value == pytest.approx(1.1e-4)
    assert found["Period by a kelvin"].value == pytest.approx(5.5e-6)


def test_without_checks_nothing_is_run() -> None:
    found = kp.design(PENDULUM, 1.0, 0.005, site=SITE, drag=kp.Drag(1e-4), checked=False)
    assert all(answer.check is None for answer in found.answers)


def test_progress_counts_to_its_end() -> None:
    seen: list[tuple[int, int]] = []
    uneven = kp.Suspension(1e-6, 0.0, 1e-6, 0.0)
    kp.design(PENDULUM, 1.0, site=SITE, suspension=uneven,
              done=lambda k, n: seen.append((k, n)))  # fmt: skip
    assert [k for k, _ in seen] == list(range(1, len(seen) + 1))
    assert {n for _, n in seen} == {len(seen)}
