"""The wording says something about everything, in both languages."""

import re

import pytest

from kugelpendel import paper
from kugelpendel.paper.document.prose import spans
from kugelpendel.paper.typeset.tex import read

LANGUAGES = ("de", "en")


@pytest.fixture(scope="module", params=LANGUAGES)
def words(request: pytest.FixtureRequest) -> paper.Words:
    return paper.words(request.param)


def texts(table: object) -> list[str]:
    if isinstance(table, dict):
        return [text for value in table.values() for text in texts(value)]
    return (
        [text for value in table for text in texts(value)]
        if isinstance(table, list)
        else [str(table)]
    )


def test_every_display_and_every_line_of_a_chain(words: paper.Words) -> None:
    for formula in paper.FORMULAS:
        assert words.formula(formula.display), formula.display
        if formula.head:
            assert words.formula(formula.label), formula.label


def test_every_step_condition_and_misprint(words: paper.Words) -> None:
    for formula in paper.FORMULAS:
        assert words.kind(formula.step.kind)
        for condition in formula.step.conditions:
            assert words.condition(condition.key)
            assert not condition.consequence or words.consequence(condition.consequence)
    for kind in paper.Kind:
        assert kind == paper.Kind.STATE or words.kind(kind)
    for misprint in paper.MISPRINTS:
        assert words.misprint(misprint.key)


def test_nothing_is_said_about_what_is_not_there(words: paper.Words) -> None:
    labels = {formula.label for formula in paper.FORMULAS}
    labels |= {formula.display for formula in paper.FORMULAS}
    conditions = {one.key: one for formula in paper.FORMULAS for one in formula.step.conditions}
    assert set(words.tables["formula"]) <= labels
    assert set(words.tables["condition"]) == set(conditions)
    consequences = {one.consequence for one in conditions.values() if one.consequence}
    said = [*words.tables["consequence"], *words.tables["holds"]]
    assert sorted(said) == sorted(consequences)
    assert consequences <= set(paper.CONSEQUENCES)  # each statement is checked
    assert set(words.tables["misprint"]) == {one.key for one in paper.MISPRINTS}
    assert set(words.tables["right"]) <= {one.key for one in paper.MISPRINTS}


def test_formulas_and_links_in_sentences(words: paper.Words) -> None:
    labels = {formula.label for formula in paper.FORMULAS}
    labels |= {formula.display for formula in paper.FORMULAS}
    tables = {key: value for key, value in words.tables.items() if key != "ui"}
    for text in texts(tables):
        assert text.count("$") % 2 == 0, text
        for span in spans(text):
            if span.kind == "math":
                read(span.text)
            if span.kind == "link":
                assert span.text in labels, text
            if span.kind == "text":
                assert "\\" not in span.text, text


def test_both_languages_say_the_same_things() -> None:
    german, english = (paper.words(language).tables for language in LANGUAGES)
    assert german.keys() == english.keys()
    for table in german:
        if isinstance(german[table], dict) and table != "right":
            assert german[table].keys() == english[table].keys(), table
        if isinstance(german[table], list):
            assert len(german[table]) == len(english[table])
    for label, text in german["formula"].items():
        other = english["formula"][label]
        links = [sorted(re.findall(r"\{([^{}\\ ]+)\}", _words_only(one))) for one in (text, other)]
        assert links[0] == links[1], label


def _words_only(text: str) -> str:
    return re.sub(r"\$[^$]*\$", "", text)


def test_gaps_are_the_same_in_both_languages() -> None:
    german, english = (paper.words(language).tables["ui"] for language in LANGUAGES)
    for key, text in german.items():
        assert text.count("{}") == english[key].count("{}"), key
