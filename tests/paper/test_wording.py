"""The wording says something about everything, in both languages."""

import re

import pytest

from kugelpendel import paper
from kugelpendel.paper.checks.wording.sentences import faults
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
    for kind in paper.StepKind:
        assert kind == paper.StepKind.STATE or words.kind(kind)
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


NEVER = {
    # the bob is "Pendelkörper", its weight "Gewichtskraft"; a pendulum has no life and no urge
    "de": r"\bGewicht\b|Leben|Drang|Ziffern|stellt.* frei|zurückgesetzt|hineingeraten|Bleibt, wo",
    "en": r"\bplace\b|its life|Stays where|slipped in|outward drive",
}


def test_words_that_do_not_fit_stay_away(words: paper.Words) -> None:
    texts_said = texts({key: value for key, value in words.tables.items() if key != "ui"})
    wrong = [text for text in texts_said if re.search(NEVER[words.language], text)]
    assert wrong == []
    assert words.ui("stays") in ("Not carried on.", "Folgefehler: keine.")


def test_orders_of_the_errors_of_25_and_26(words: paper.Words) -> None:
    """The share of (25) grows with the second power of the amplitude, that of (26) with the 4th."""
    assert (paper.figure("error-25"), paper.figure("error-26")) == (2, 4)
    second, fourth = {"de": ("Quadrat", "vierten"), "en": ("square", "fourth")}[words.language]
    for text in (words.consequence("large"), " ".join(words.paragraphs("closing"))):
        about = text[text.index("{25}" if "{25}" in text else "(25)") :]
        assert re.search(rf"{second}.*{fourth}", about), text


def test_olssons_numbers_jacksons_angles_and_the_curly_r_are_named(words: paper.Words) -> None:
    assert "Jackson" in " ".join(words.paragraphs("conventions"))
    assert "Olsson" in words.formula("6")
    assert "z \\approx l" in words.section(2)[1]
    missing = " ".join(words.paragraphs("introduction"))
    assert "(7)" in missing
    assert "(11)" in missing


def test_10_is_not_said_to_hold_wherever_5b_does(words: paper.Words) -> None:
    """On the axis (10) is empty, on the equator it means nothing; (5b) holds in both places."""
    assert not re.search("exactly where|genau dort, wo", words.formula("10.5"))
    assert paper.CONSEQUENCES["axis"]()
    assert paper.CONSEQUENCES["equator"]()


@pytest.mark.parametrize("name", paper.STATEMENTS)
def test_formula_of_the_wording_is_proved_and_its_mutants_are_not(name: str) -> None:
    row = paper.examined(name)
    assert row.symbolic
    assert row.survivors == ()
    assert row.killed >= 2


@pytest.mark.parametrize("language", LANGUAGES)
def test_sentences_claim_nothing_that_is_not_proved(language: str) -> None:
    """Figures, formulas and quantities; each of them spoilt in every sentence that has it."""
    row = paper.examined(language)
    assert row.faults == ()
    assert row.unnoticed == ()
    made = {kind: count for kind, count, _ in row.sabotages}
    assert made.keys() == {"figure", "statement", "quantity"}
    assert min(made.values()) > 80


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("of $@nonsense$", "no statement is named nonsense"),
        ("of [third](nonsense) order", "no figure is named nonsense"),
        ("of [third](error-26) order", "third should say 4"),
        ("of third order", "is no figure"),
        ("it is $x = 2y$", "claims something"),
        ("a factor $3a$", "claims something"),
        ("divided by $\\ddot{z}$", "does not stand in the formulas"),
    ],
)
def test_a_claim_without_a_proof_is_found(text: str, fault: str) -> None:
    (found,) = faults("formula.25", text)
    assert fault in found
    assert faults("formula.25", "of [fourth](error-26) order, with $ab$") == ()
