"""Every kind of problem has its sentences, can be provoked, and says what was seen."""

import math
import re
import string
from typing import Any, get_args

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.errors import Door, KugelpendelError, Language, problem_kinds
from kugelpendel.errors._sentences import read

P = kp.Pendulum(2.0, 9.8)
SWING = kp.Launch.ellipse(0.3, 0.0)
LOOP = kp.Launch.plane(0.3, 0.0, 8.0, 0.1)
"""Over the support's level, but not round."""
LANGUAGES: tuple[Language, ...] = get_args(Language)
DOORS: tuple[Door, ...] = get_args(Door)


def real(launch: kp.Launch = SWING, **parts: Any) -> Any:
    return kp.RealMotion(P, launch, **parts)


CORE: dict[str, Any] = {
    "not_finite": lambda: kp.Suspension(math.nan),
    "not_positive": lambda: kp.Pendulum(-1.0),
    "negative": lambda: kp.Drag(-1.0),
    "beyond_numbers": lambda: kp.Pendulum(1e51),
    "launch_not_finite": lambda: kp.Launch.ellipse(math.nan, 0.0),
    "launch_angle": lambda: kp.Launch.at_rest(45.0),
    "ellipse_negative": lambda: kp.ExactMotion(P, kp.Launch.ellipse(-0.1, 0.0)),
    "ellipse_too_wide": lambda: kp.ExactMotion(P, kp.Launch.ellipse(2.0, 0.0)),
    "apsides_too_wide": lambda: kp.ExactMotion(P, kp.Launch.apsides(2.0, 0.0)),
    "apsides_exchanged": lambda: kp.ExactMotion(P, kp.Launch.apsides(0.1, 0.2)),
    "plane_too_wide": lambda: kp.ExactMotion(P, kp.Launch.plane(2.0, 0.0, 0.0, 0.0)),
    "off_the_sphere": lambda: kp.ExactMotion(P, kp.Launch.state([0, 0, 1.0], [0, 0, 0])),
    "stretching": lambda: kp.ExactMotion(P, kp.Launch.state([0, 0, 2.0], [0, 0, 1.0])),
    "too_fast": lambda: kp.ExactMotion(P, kp.Launch.ellipse(0.1, 1e100)),
    "too_small": lambda: kp.ExactMotion(P, kp.Launch.apsides(1e-100, 0.0)),
    "separatrix": lambda: kp.ExactMotion(
        kp.Pendulum(1.0, 1.0), kp.Launch.plane(0, 0, 2, 0)
    ).spectrum(1),
    "latitude": lambda: kp.Site(48.0),
    "beyond_pole": lambda: kp.Site(91.0),
    "height": lambda: kp.Site(0.5, height=1e6),
    "two_gravities": lambda: real(site=kp.Site(0.5, 9.7)),
    "lighter_than_air": lambda: kp.Bob(0.1, 1.0),
    "bob_too_large": lambda: real(bob=kp.Bob(3.0, 8e3)),
    "drive_phase": lambda: kp.Drive(0.1, phase=4.0),
    "pumping": lambda: real(drive=kp.Drive(0.1, phase=0.0)),
    "pumping_too_hard": lambda: real(drive=kp.Drive(0.1, phase=0.0), drag=kp.Drag(1e-6)),
    "too_strong": lambda: kp.EnvelopeMotion(P, SWING, suspension=kp.Suspension(1.0)),
    "rises_to_support": lambda: kp.EnvelopeMotion(P, kp.Launch.at_rest(2.0)),
    "above_support": lambda: kp.OlssonMotion(P, kp.Launch.at_rest(2.0)),
    "starts_above": lambda: kp.PlaneMotion(P, kp.Launch.at_rest(2.0)),
}

MASSES = kp.Drag(1e-4), kp.Forces(drag=kp.Drag(1e-4))
PYTHON: dict[str, Any] = {
    "not_a_number": lambda: kp.Pendulum("67 m"),  # pyright: ignore[reportArgumentType]
    "shapes": lambda: kp.Pendulum([1.0, 2.0], [1.0, 2.0, 3.0]),
    "drive_when": lambda: kp.Drive(0.1),
    "launch_kind": lambda: kp.Launch("circle", (0.1,)),
    "launch_values": lambda: kp.Launch("ellipse", (0.1,)),
    "state_components": lambda: kp.Launch.state([0, 0], [0, 0, 0]),
    "wrong_type": lambda: kp.ExactMotion(SWING, P),  # pyright: ignore[reportArgumentType, reportCallIssue]
    "unknown_part": lambda: kp.RealMotion(P, SWING, wind=kp.Drag(1.0)),  # pyright: ignore[reportArgumentType, reportCallIssue]
    "parts_twice": lambda: kp.RealMotion(P, SWING, MASSES[1], drag=MASSES[0]),
    "slack": lambda: kp.RealMotion(P, LOOP).position(60.0),
    "averaged_to_support": lambda: kp.EnvelopeMotion(P, SWING, drag=kp.Drag(1e-3)).position(-1e5),
    "level_with_support": lambda: kp.PlaneMotion(P, LOOP).position(60.0),
    "runaway": lambda: kp.RealMotion(
        P, kp.Launch.plane(0, 0, 3, 1), drag=kp.Drag(quadratic=0.5), thread="rod"
    ).position(-1e3),
    "no_event": lambda: kp.RealMotion(P, SWING).next_event("slack", within=10.0),
}


def provoked(call: Any) -> KugelpendelError:
    with pytest.raises(KugelpendelError) as raised:
        call()
    return raised.value


def test_every_kind_of_the_core_is_provoked() -> None:
    assert set(CORE) == set(problem_kinds().values())


@pytest.mark.parametrize("kind", [*CORE, *PYTHON])
def test_four_sentences(kind: str) -> None:
    error = provoked((CORE | PYTHON)[kind])
    assert error.kind == kind
    assert str(error) == error.sentence() == error.sentence("en", "python")
    said = [error.sentence(language, door) for language in LANGUAGES for door in DOORS]
    assert len(set(said)) >= 2
    for sentence in said:
        assert sentence.endswith((".", ".'", ". "))
        assert not re.search(r"[{}]", sentence.replace("{'", ""))
    for language in LANGUAGES:
        assert not re.search(r"kp\.|Launch\.|\(|RealMotion", error.sentence(language, "file"))
    # What was seen is there to be read by a program.
    assert error.values
    for seen in error.values:
        assert seen.name
        assert isinstance(seen.value, (float, str))


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_sentence_uses_values_that_there_are(language: Language) -> None:
    # A kind that is not provoked above would be one that nobody has seen.
    tables = read(language)
    others = {"other_unit", "missing_extra", "missing_extras"}  # tests/parameters, test_extras
    # Those of recordings are provoked in tests/tracks, those of sweeps in tests/sweeps.
    rooms = ("track_", "columns_", "table_", "fit_", "synth_", "plan_", "sweep_")
    # Those of the command line in tests/cli/test_german.py.
    rooms += ("file_", "quantity_", "out_", "derive_", "option_", "follow_")
    others |= {kind for kind in tables["kinds"] if kind.startswith(rooms)}
    assert set(tables["kinds"]) == set(CORE) | set(PYTHON) | others
    assert set(tables["quantities"]) == set(read("en")["quantities"])
    fields = {
        kind: {name for text in entry.values() for _, name, _, _ in string.Formatter().parse(text)}
        for kind, entry in tables["kinds"].items()
    }
    english = read("en")["kinds"]
    for kind, names in fields.items():
        known = {
            name
            for text in english[kind].values()
            for _, name, _, _ in string.Formatter().parse(text)
        }
        assert names <= known, kind


def test_no_sentence_for_a_file_speaks_python() -> None:
    for language in LANGUAGES:
        tables = read(language)
        for entry in [*tables["kinds"].values(), *tables["quantities"].values()]:
            said = entry.get("file", entry["python"])
            if "kugelpendel[" not in said:
                assert not re.search(r"kp\.|Launch\.|\(|RealMotion|ExactMotion", said), said


def test_numbers_and_words_of_the_kinds_do_not_change() -> None:
    # A status that somebody has kept means the same in every later version.
    assert problem_kinds() == {
        1: "not_finite", 2: "not_positive", 3: "negative", 4: "beyond_numbers",
        10: "launch_not_finite", 11: "launch_angle", 12: "ellipse_negative",
        13: "ellipse_too_wide", 14: "apsides_too_wide", 15: "apsides_exchanged",
        16: "plane_too_wide", 17: "off_the_sphere", 18: "stretching", 19: "too_fast",
        20: "too_small", 25: "separatrix", 30: "latitude", 31: "height", 32: "two_gravities",
        33: "beyond_pole", 40: "lighter_than_air", 41: "bob_too_large", 50: "drive_phase",
        51: "pumping", 52: "pumping_too_hard", 60: "too_strong", 61: "rises_to_support",
        70: "above_support", 71: "starts_above",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("make", "english", "german"),
    [
        (
            lambda: kp.Launch.at_rest(45.0),
            "The launch's theta must lie between −2π and 2π rad, but it is 45 rad; write theta = "
            '"45 deg" if these are degrees.',
            'theta des Starts muss zwischen −2π und 2π rad liegen, ist aber 45 rad; sind es Grad: '
            'theta = "45 deg".',
        ),
        (
            lambda: kp.Drag(-1e-5),
            "The linear drag must be finite and not negative, but it is -1e-05 1/s; drag takes "
            "energy away: use 0 for none, and the table [drive] to bring some in.",
            "Der lineare Luftwiderstand muss endlich und darf nicht negativ sein, ist aber -1e-05 "
            "1/s; Widerstand nimmt Energie weg: 0 heißt keiner, die Tabelle [drive] führt welche "
            "zu.",
        ),
    ],
)  # fmt: skip
def test_sentences_for_a_file(make: Any, english: str, german: str) -> None:
    error = provoked(make)
    assert error.sentence(door="file") == english
    assert error.sentence("de", "file") == german


def test_numbers_are_written_in_full_where_the_exact_motion_takes_them_so() -> None:
    seen = {
        2 + 1e-8: "2.00000001", 1e-8: "0.00000001", 0.0: "0", -1.5: "-1.5", 1e300: "1e+300",
        1e-12: "1e-12", math.nan: "NaN", math.inf: "inf", 123456789012.0: "123456789012",
        1.5e-7: "0.00000015",
    }  # fmt: skip
    for value, text in seen.items():
        error = kp.InvalidInput.of("ellipse_negative", a=(value, "m"))
        assert f"but it is {text} m;" in str(error)


def test_only_what_is_wrong_is_said_by_its_spoken_name() -> None:
    with pytest.raises(kp.InvalidInput, match=r"^The launch's a must be a number"):
        kp.Launch.ellipse("1 m", 0.0)  # pyright: ignore[reportArgumentType]
    with pytest.raises(kp.InvalidInput, match=r"^launch\.csv cannot be read: "):
        kp.tracks.read("launch.csv")


def test_a_sentence_is_one_line_and_names_stay_as_they_are() -> None:
    with pytest.raises(kp.InvalidInput, match=r"^two  blanks\.csv cannot be read: "):
        kp.tracks.read("two  blanks.csv")
    with pytest.raises(kp.InvalidInput, match=r"but it is array\(\[\['a'\], \['b'\]\]"):
        kp.Pendulum(np.array([["a"], ["b"]]))  # pyright: ignore[reportArgumentType, reportCallIssue]


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "wind.speed must be finite, but it is nan m/s; give a number."),
        ("de", "wind.speed muss endlich sein, ist aber nan m/s; eine Zahl angeben."),
    ],
)
def test_a_quantity_without_a_spoken_name_keeps_that_of_the_core(
    language: Language, said: str
) -> None:
    error = kp.InvalidInput.told(("not_finite", [("wind.speed", math.nan, "m/s")]))
    assert error.sentence(language, "python") == said
