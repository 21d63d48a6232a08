"""What the page says where the core refuses something: the sentences of Python."""

import re
from itertools import cycle
from typing import Any, get_args

import pytest

from kugelpendel.errors import InvalidInput, Language, Seen, problem_kinds
from kugelpendel.errors._sentences import read

NUMBERS = (
    0.1, -2.5e-7, 2.0, 1234567.891, 3e22, 1e16, 123456.75, -0.00012345678, 6.02e-10, 1e-5, 0.0,
    float("nan"), float("inf"), -float("inf"), 2 / 3,
)  # fmt: skip
SPOKEN = ("drag.linear", "pendulum.length", "length", "site.rotation", "launch.x")


def cases(language: Language) -> list[tuple[str, list[Seen]]]:
    """Every kind, with numbers of all sizes in the holes of its sentence."""
    numbers, names = cycle(NUMBERS), cycle(SPOKEN)
    found = []
    for kind in problem_kinds().values():
        entry = read(language)["kinds"][kind]
        holes = re.findall(r"\{(\w+)", entry.get("file", entry["python"]))
        of_quantity = {"spoken", "shown", "way_out", "value", "unit", "name"}
        own = [Seen(hole, next(numbers), "m") for hole in holes if hole not in of_quantity]
        for _ in range(5):
            first = [Seen(next(names), next(numbers), "m/s²")] if of_quantity & {*holes} else []
            again = [seen._replace(value=next(numbers)) for seen in own]
            found.append((kind, [*first, *again]))
    return found


@pytest.mark.parametrize("language", get_args(Language))
def test_a_refusal_is_the_sentence_of_python(engine: Any, language: Language) -> None:
    script = """
    return given.cases.map(([kind, seen]) => {
      const values = seen.map(([name, value, unit]) => ({ name, value: Number(value), unit }));
      return engine.refusal(new engine.Refused(kind, values), given.language);
    });
    """
    asked = cases(language)
    texts = {float("inf"): "Infinity", -float("inf"): "-Infinity"}
    sent = [
        (kind, [(s.name, texts.get(float(s.value), repr(s.value)), s.unit) for s in seen])
        for kind, seen in asked
    ]
    said = engine(script, {"cases": sent, "language": language})
    for (kind, seen), sentence in zip(asked, said, strict=True):
        wanted = InvalidInput(kind=kind, values=seen).sentence(language, "file")
        # The page writes numbers as people do; all else is the same to the letter.
        assert in_signs_of_python(sentence) == in_signs_of_python(wanted), (kind, seen)


def in_signs_of_python(sentence: str) -> str:
    return sentence.replace(",", ".").replace("−", "-")


def test_numbers_have_the_comma_and_the_minus_that_people_write(engine: Any) -> None:
    script = """
    const seen = [{ name: "pendulum.length", value: -0.5, unit: "m" }];
    const refused = new engine.Refused("not_positive", seen);
    return ["de", "en"].map((language) => engine.refusal(refused, language));
    """
    german, english = engine(script)
    assert "ist aber −0,5 m;" in german
    assert "it is −0.5 m;" in english
