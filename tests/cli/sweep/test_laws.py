"""How numbers of a file vary, and a sentence for what does not say it."""

import tomllib

import pytest

import kugelpendel as kp
from kugelpendel.cli.job_file.kinds import ANGLE, LENGTH
from kugelpendel.cli.sweep.laws import read_law
from kugelpendel.sweeps import Listed, Normal, Spaced, Uniform


@pytest.mark.parametrize(
    ("text", "law"),
    [
        ('["1 cm", "2 cm", 0]', Listed((0.01, 0.02, 0.0))),
        ('{ from = "1 cm", to = "1 m", count = 5 }', Spaced(0.01, 1.0, 5)),
        ('{ from = "1 cm", to = "1 m", count = 5, scale = "log" }', Spaced(0.01, 1.0, 5, log=True)),
        ('{ from = "0 cm", to = "1 m" }', Spaced(0.0, 1.0)),
        ('{ normal = ["1 m", "2 mm"] }', Normal(1.0, 0.002)),
        ("{ uniform = [0, 0.5] }", Uniform(0.0, 0.5)),
    ],
)
def test_read(text: str, law: object) -> None:
    assert read_law(tomllib.loads(f"x = {text}")["x"], LENGTH, "[launch] a") == law


def test_numbers_without_a_unit() -> None:
    assert read_law([100, 200.0], None, "[drag] quality") == Listed((100.0, 200.0))


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ('{ from = "1 cm", to = "1", count = 5 }', '[launch] a = "1" has no unit; write a length'),
        ('{ from = "1 cm", to = 1, count = 5 }', '[launch] a has "1 cm" with a unit and 1 without'),
        ('["1 cm", 2]', '[launch] a has "1 cm" with a unit and 2 without one; write the unit of'),
        ('{ from = "1 cm", to = "1 s" }', '[launch] a = "1 s" is not a length; write a length'),
        ('{ from = "1 cm" }', "[launch] a has from, which does not say how it varies; write a li"),
        ("[]", "The list of [launch] a is empty; give it a value or more."),
        ("{ }", "[launch] a has { }, which does not say how it varies; write a list"),
        ('{ gauss = ["1 cm", "1 mm"] }', "[launch] a has gauss, which does not say how it vari"),
        ('{ from = "1 cm", to = "2 cm", steps = 5 }', "[launch] a has an unknown key steps; a r"),
        ('{ from = "1 cm", to = "2 cm", cuont = 5 }', "[launch] a has an unknown key cuont (did"),
        ('{ from = "1 cm", to = "2 cm", scale = "ln" }', '[launch] a has scale = "ln"; write "li'),
        ('{ from = "1 cm", to = "2 cm", count = 2.5 }', "[launch] a has count = 2.5; write a who"),
        ('{ normal = "1 cm" }', '[launch] a has normal = "1 cm"; write its mean and standard dev'),
        ('{ uniform = ["1 cm"] }', "[launch] a has uniform = ['1 cm']; write its least and larges"),
    ],
)
def test_refused(text: str, sentence: str) -> None:
    with pytest.raises(kp.InvalidInput) as raised:
        read_law(tomllib.loads(f"x = {text}")["x"], LENGTH, "[launch] a")
    assert str(raised.value).startswith(sentence)


def test_degrees_without_a_unit_are_refused() -> None:
    with pytest.raises(kp.InvalidInput, match="is in rad, which is more than a full turn"):
        read_law([0, 45], ANGLE, "[launch] azimuth")
    with pytest.raises(
        kp.InvalidInput, match=r"\[drag\] quality has \"1 m\", which is not a plain"
    ):
        read_law(["1 m"], None, "[drag] quality")
