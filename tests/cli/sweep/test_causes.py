"""The sentence on what moves a result is no more certain than its intervals."""

from dataclasses import replace

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.cli.sweep.causes import causes, main_cause
from kugelpendel.errors import Language
from kugelpendel.sweeps import Spaced
from kugelpendel.sweeps._sensitivity import Sensitivity, Share

CLAMP, AXIS, WIDTH = "suspension.anisotropy", "suspension.axis", "launch.b"
NAMES = (CLAMP, AXIS, WIDTH)


def found(
    alone: tuple[float, float, float],
    total: tuple[float, float, float],
    pair: float,
    inner: float,
    error: float = 0.01,
) -> Sensitivity:
    def shares(values):
        return {name: Share(value, error) for name, value in zip(NAMES, values, strict=True)}

    quiet = {(CLAMP, WIDTH): Share(0.02, error), (AXIS, WIDTH): Share(0.02, error)}
    return Sensitivity(
        NAMES, shares(alone), shares(total),
        {(CLAMP, AXIS): Share(pair, error), **quiet},
        {(CLAMP, AXIS): Share(inner, error), **quiet}, 512, 0,
    )  # fmt: skip


PAIR = found((0.1, 0.3, 0.01), (0.7, 0.88, 0.02), 0.98, 0.58)


def test_a_pair_that_moves_nearly_all_of_it() -> None:
    assert main_cause(PAIR, "azimuth after 6.00 h") == (
        "Of what moves the azimuth after 6.00 h, 98 % (± 1 %) is the clamp's unevenness together "
        "with its direction: align the axis."
    )


def test_a_pair_without_an_interaction_is_not_said_to_act_together() -> None:
    said = main_cause(found((0.4, 0.52, 0.0), (0.4, 0.52, 0.0), 0.92, 0.0), "a")
    assert "is the clamp's unevenness and the clamp's direction: align the axis" in said


def test_one_number_alone() -> None:
    said = main_cause(found((0.02, 0.01, 0.95), (0.02, 0.01, 0.95), 0.03, 0.0), "b")
    assert said == (
        "Of what moves the b, 95 % (± 1 %) is the width at the launch: launch it on a narrower "
        "ellipse."
    )


def test_no_advice_for_a_number_that_would_not_help_if_it_were_held() -> None:
    said = main_cause(replace(PAIR, total={name: Share(0.3, 0.01) for name in NAMES}), "azimuth")
    assert said.endswith("together with its direction.")


@pytest.mark.parametrize("error", [0.19, 0.6])
def test_wide_intervals_say_so_and_nothing_else(error: float) -> None:
    said = main_cause(found((0.1, 0.3, 0.01), (0.7, 0.88, 0.02), 0.98, 0.58, error), "azimuth")
    assert said.startswith("What moves the azimuth most cannot be told: the intervals are up to ±")
    assert "align" not in said


def test_where_no_two_move_most_the_largest_are_named() -> None:
    said = main_cause(found((0.3, 0.3, 0.3), (0.4, 0.35, 0.32), 0.6, 0.0), "azimuth")
    assert said == (
        "No two numbers alone move most of the azimuth; the largest shares are those of the "
        "clamp's unevenness (40 % (± 1 %) with all others) and the clamp's direction "
        "(35 % (± 1 %))."
    )


@pytest.mark.parametrize(
    ("language", "values", "said"),
    [
        ("en", np.full(96, 3.0), "What moves the period: Nothing moves this result: it is 3 in "),
        ("de", np.full(96, 3.0), "Was „Periode“ bewegt: Dieses Ergebnis bewegt nichts: Es ist in "),
        ("en", np.full(96, np.nan), "Sobol indices need 16 whole blocks of 6 cases at least, but "),
        ("de", np.full(96, np.nan), "Sobol-Indizes brauchen mindestens 16 ganze Blöcke zu 6 Fä"),
    ],
)
def test_what_cannot_be_told_is_said_in_the_language_of_the_report(
    language: Language, values: np.ndarray, said: str
) -> None:
    launch = {"kind": "ellipse", "a": Spaced(0.1, 0.2), "b": Spaced(0.01, 0.02)}
    given = {"pendulum": {"length": 1.0}, "launch": launch}
    sweep = kp.Sweep(given, "sobol", "exact", ("period",), count=16)
    title = {"en": "period", "de": "Periode"}[language]
    assert said in " ".join(causes(sweep, values, title, language).split())
