"""What moves a result: the table of its Sobol indices, and the sentence that they allow."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.sweep.phrases import ADVICE, PHRASES
from kugelpendel.cli.terminal.tables import numbers, paragraph
from kugelpendel.errors import InvalidInput
from kugelpendel.spelling import grouped, localised
from kugelpendel.sweeps._sensitivity import sensitivity
from kugelpendel.sweeps._spoken import called, in_a_sentence

if TYPE_CHECKING:
    from kugelpendel.errors import Language
    from kugelpendel.parameters import Numbers
    from kugelpendel.sweeps._sensitivity import Sensitivity, Share
    from kugelpendel.sweeps.cases import Sweep

MOST = 0.8
"""The share from which on it is said what moves a result: that much at the interval's lower end."""

_WIDE = 0.1
"""Half an interval beyond which it is too wide to say anything."""

_NOTED = 0.05
"""Pairs are listed whose interaction is this much, with its whole interval above zero."""

_HALF = 0.5
"""Of the variance that a number takes along, at least, before there is advice on it."""

_DIRECTIONS = {
    "suspension.anisotropy": "suspension.axis",
    "suspension.damping_anisotropy": "suspension.damping_axis",
}


def causes(sweep: Sweep, values: Numbers, title: str, language: Language = "en") -> str:
    """Say what moves a result in a Sobol design: a table, and a sentence where it is certain.

    Parameters
    ----------
    sweep
        Of the design "sobol".
    values
        The result of every case.
    title
        What the result is called.
    language
        Of the text.
    """
    words = PHRASES[language]
    try:
        found = sensitivity(values, sweep.names, second_order=sweep.second_order, seed=sweep.seed)
    except InvalidInput as refused:
        why = refused.sentence(language, "file")
        return paragraph(words["refuses"].format(title=title, why=why))
    parts = [words["moves"].format(title=title), _table(found, language)]
    if found.dropped:
        blocks = grouped(found.dropped + found.blocks)
        said = words["dropped"].format(
            dropped=grouped(found.dropped), blocks=blocks, size=sweep.block
        )
        parts.append(paragraph(said))
    parts.append(paragraph(main_cause(found, title, language)))
    return "\n".join(parts)


def main_cause(found: Sensitivity, title: str, language: Language = "en") -> str:
    """One sentence on what moves a result most, no more certain than the intervals are."""
    words = PHRASES[language]
    single = max(found.names, key=lambda name: found.alone[name].value)
    if found.alone[single].least >= MOST:
        return words["one"].format(
            title=title,
            percent=_percent(found.alone[single]),
            name=in_a_sentence(single, language),
            advice=_advice(found, language, single),
        )
    pair = max(found.together, key=lambda pair: found.together[pair].value, default=None)
    if pair is not None and found.together[pair].least >= MOST:
        first, second = _ordered(pair)
        kind = "directed" if _DIRECTIONS.get(first) == second else "joint"
        return words[kind if found.interaction[pair].least > 0 else "two"].format(
            title=title,
            percent=_percent(found.together[pair]),
            first=in_a_sentence(first, language),
            second=in_a_sentence(second, language),
            advice=_advice(found, language, *pair),
        )
    widest = max(share.error for share in found.total.values())
    if widest > _WIDE or len(found.names) < 2:
        return words["wide"].format(title=title, error=f"{100 * widest:.0f}")
    first, second = sorted(found.names, key=lambda name: -found.total[name].value)[:2]
    return words["many"].format(
        title=title,
        first=in_a_sentence(first, language),
        one=_percent(found.total[first]),
        second=in_a_sentence(second, language),
        two=_percent(found.total[second]),
    )


def _table(found: Sensitivity, language: Language) -> str:
    words = PHRASES[language]
    names = sorted(found.names, key=lambda name: -found.total[name].value)
    rows = [
        (
            called(name, language),
            _cell(found.alone[name], language),
            _cell(found.total[name], language),
            "",
        )
        for name in names
    ]
    for pair in sorted(found.interaction, key=lambda pair: -found.together[pair].value):
        inner = found.interaction[pair]
        if inner.least > 0 and inner.value >= _NOTED:
            label = " × ".join(called(name, language) for name in sorted(pair, key=names.index))
            together = _cell(found.together[pair], language)
            rows.append((label, together, "", _cell(inner, language)))
    headers = (words["variance"], words["alone"], words["total"], words["interaction"])
    return numbers(headers, rows)


def _cell(share: Share, language: Language) -> str:
    return localised(f"{100 * share.value:.1f} ± {100 * share.error:.1f}", language)


def _percent(share: Share) -> str:
    error = max(100 * share.error, 0.5)
    return f"{100 * min(share.value, 1.0):.0f} % (± {error:.0f} %)"


def _ordered(pair: tuple[str, str]) -> tuple[str, str]:
    """Both names, a direction after what it is the direction of."""
    first, second = pair
    return (second, first) if _DIRECTIONS.get(second) == first else pair


def _advice(found: Sensitivity, language: Language, *names: str) -> str:
    """What to do about it: of the first number that would take away half of it if it were held."""
    for name, said in ADVICE.items():
        if name in names and found.total[name].least >= _HALF:
            return f": {said[language]}"
    return ""
