"""``kugelpendel fit --plan``: how long to record, as the library says it."""

import pytest

import kugelpendel as kp
from kugelpendel.cli.fit.words import words

SWING = ("--length", "3 m", "--a", "15 cm", "--b", "1 cm", "--noise", "0.5 mm", "--rate", "30")


@pytest.mark.parametrize("language", ["en", "de"])
def test_in_words(call, language: str) -> None:
    outcome = call("fit", "--plan", *SWING, "--latitude", "50 N", "--lang", language)
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith(words(language)["plan_title"])
    assert ("," if language == "de" else ".") in outcome.out


def test_as_the_library(call) -> None:
    found = call("fit", "--plan", *SWING, "--json").results
    plan = kp.tracks.plan(3.0, a=0.15, b=0.01, noise=5e-4, rate=30.0)
    assert found["intrinsic_time_s"] == plan.intrinsic_time
    assert len(found["table"]) == len(plan.rows)


@pytest.mark.parametrize("missing", ["--length", "--a", "--b", "--noise", "--rate"])
def test_what_it_needs(call, missing: str) -> None:
    at = SWING.index(missing)
    outcome = call("fit", "--plan", *SWING[:at], *SWING[at + 2 :])
    assert outcome.code == 2
    assert missing in outcome.err
