"""What a sweep has found, in tables and sentences."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kugelpendel.cli.sweep.causes import causes
from kugelpendel.cli.sweep.phrases import PHRASES
from kugelpendel.cli.terminal.tables import facts, listing, numbers, paragraph
from kugelpendel.spelling import as_given, degrees, general, grouped, significant
from kugelpendel.sweeps._quantities import QUANTITIES
from kugelpendel.sweeps._reductions import MOST_SORTED, evenly
from kugelpendel.sweeps._spoken import called, called_after, unit_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from xarray import Dataset

    from kugelpendel.errors import Language
    from kugelpendel.parameters import Numbers
    from kugelpendel.sweeps.cases import Sweep

_QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)


@dataclass(frozen=True)
class Answer:
    """What was read of all cases under one name, at one time."""

    name: str
    time: float | None
    values: Numbers


def report(sweep: Sweep, dataset: Dataset, language: Language = "en") -> str:
    """Say what came out: counts of cases, distributions, and what moves each result.

    Parameters
    ----------
    sweep
        What was asked for.
    dataset
        What it came to, with every quantity that was kept, and `status`.
    language
        Of the text.
    """
    parts = [_counts(sweep, dataset, language)]
    if not sweep.keeps_all:
        return "\n\n".join([*parts, reduced(sweep, dataset, language)])
    found = list(answers(sweep, dataset))
    parts += [_distributions(found, language), _truths(found, language)]
    parts += [_thinning(sweep, language), _agreement(found, language)]
    if sweep.design == "sobol":
        for answer in found:
            title = called_after(answer.name, answer.time, language)
            parts.append(causes(sweep, answer.values, title, language))
    return "\n\n".join(part for part in parts if part)


def answers(sweep: Sweep, dataset: Dataset) -> Iterator[Answer]:
    """Each quantity whose values were kept, at each of its times: in the order of the file."""
    for name in sweep.quantities:
        data = _thinned(dataset[name], sweep)
        if "time" in data.dims:
            for k, time in enumerate(sweep.times):
                yield Answer(name, float(time), _flat(data.isel(time=k)))
        else:
            yield Answer(name, None, _flat(data))


def _thinned(data: Any, sweep: Sweep) -> Any:
    """The whole of it, or evenly spread cases along the first axis of very many."""
    every = _every(sweep)
    if every == 1:
        return data
    return data.isel({data.dims[0]: slice(None, None, every)})


def _every(sweep: Sweep) -> int:
    """How many levels along the first axis there are to each that is read.

    The blocks of a Sobol design stay whole: it needs all of its cases.
    """
    return 1 if sweep.design == "sobol" else -(-sweep.size // MOST_SORTED)


def _thinning(sweep: Sweep, language: Language) -> str:
    every = -(-sweep.size // MOST_SORTED)
    kind = "thinned_levels" if sweep.design == "grid" else "thinned"
    return PHRASES[language][kind].format(every=every) if every > 1 else ""


def _flat(data: Any) -> Numbers:
    return np.asarray(data.values, np.float64).ravel()


def _counts(sweep: Sweep, dataset: Dataset, language: Language) -> str:
    words = PHRASES[language]
    status = dataset["status"].attrs
    late, good, refused, ended = status["counts"]
    rows: list[tuple[str, ...]] = [
        (words["cases"], grouped(sweep.size), _layout(sweep, language)),
        (words["good"], grouped(good), ""),
    ]
    for name, count in (("refused", refused), ("ended", ended)):
        if count:
            rows.append((words[name], grouped(count), ""))
    if late:
        rows.append((words["late"], grouped(late), ""))
    bad = [("", said) for said in _bad(sweep, status["first_bad"], language)]
    return "\n".join(part for part in (facts(rows), listing(bad)) if part)


def _layout(sweep: Sweep, language: Language) -> str:
    words = PHRASES[language]
    design = words[sweep.design].format(
        shape=" × ".join(str(size) for size in sweep.shape), count=grouped(int(sweep.count or 0))
    )
    varied = ", ".join(called(name, language) for name in sweep.names)
    return words["layout"].format(motion=words[sweep.motion], design=design, varied=varied)


def _bad(sweep: Sweep, indices: list[int], language: Language) -> Iterator[str]:
    from kugelpendel.sweeps import why

    for index in indices:
        varied = sweep.values(index, index + 1)
        given = ", ".join(
            f"{called(name, language)} = {_said(float(value[0]), sweep.unit(name), language)}"
            for name, value in varied.items()
        )
        said = why(sweep, index, language, "file")
        yield PHRASES[language]["case"].format(index=grouped(index), given=given, why=said)


def _said(value: float, si: str, language: Language) -> str:
    if si == "rad":
        return degrees(value, language=language)
    try:
        return as_given(value, si, language=language)
    except KeyError:
        unit = "" if si == "1" else f" {si}"
        return f"{general(value, language=language)}{unit}"


def _distributions(found: list[Answer], language: Language) -> str:
    words = PHRASES[language]
    rows: list[tuple[str, ...]] = []
    for answer in found:
        quantity = QUANTITIES[answer.name]
        if quantity.holds == "truth":
            continue
        values = answer.values[np.isfinite(answer.values)]
        title = called_after(answer.name, answer.time, language)
        if not values.size:
            rows.append((title, *("–" for _ in range(8)), grouped(0)))
            continue
        if quantity.holds == "axis":
            rows.append((title, *_of_an_axis(values, language), grouped(values.size)))
            continue
        unit = unit_of(answer.name, float(np.abs(values).max()), quantity.unit)
        ends = (values.min(), *np.quantile(evenly(values), _QUANTILES), values.max())
        cells = (significant(float(end) / unit.size, language=language) for end in ends)
        rows.append((title, unit.symbol, *cells, grouped(values.size)))
    if not rows:
        return ""
    shares = (f"{100 * share:g} %" for share in _QUANTILES)
    headers = (words["result"], words["unit"], words["least"], *shares)
    headers = (*headers, words["largest"], words["answers"])
    return numbers(headers, rows, text=2)


def _of_an_axis(values: Numbers, language: Language) -> tuple[str, ...]:
    """Directions have no least and no largest one: their middle alone."""
    mean = np.exp(2j * values).mean()
    middle = float(np.mod(0.5 * np.angle(mean), np.pi))
    return (
        "°",
        "–",
        "–",
        "–",
        significant(float(np.degrees(middle)), language=language),
        "–",
        "–",
        "–",
    )


def reduced(sweep: Sweep, dataset: Dataset, language: Language = "en") -> str:
    """The same where no values were kept, of what they were reduced to."""
    words = PHRASES[language]
    rows: list[tuple[str, ...]] = []
    for name in sweep.quantities:
        quantity = QUANTITIES[name]
        for k, time in enumerate(sweep.times if quantity.per_time else (None,)):
            told = np.array(_reductions(dataset, name, k if quantity.per_time else None))
            size = float(np.abs(told[np.isfinite(told)]).max(initial=0.0))
            unit = unit_of(name, size, quantity.unit)
            cells = (
                "–" if math.isnan(n) else significant(n / unit.size, language=language)
                for n in told.tolist()
            )
            rows.append((called_after(name, time, language), unit.symbol, *cells))
    shares = (f"{100 * share:g} %" for share in _QUANTILES)
    headers = (words["result"], words["unit"], words["least"], *shares)
    headers = (*headers, words["largest"], words["mean"], words["deviation"])
    return numbers(headers, rows, text=2)


def _reductions(dataset: Dataset, name: str, time: int | None) -> list[float]:
    """Least, quantiles, largest, mean and deviation; NaN for what was not kept."""

    def kept(kind: str) -> Numbers:
        """One number, or the quantiles."""
        if f"{name}_{kind}" not in dataset:
            return np.full(len(_QUANTILES), math.nan)
        values = np.asarray(dataset[f"{name}_{kind}"].values, np.float64)
        return np.atleast_1d(values if time is None else values[..., time])

    shares = [round(float(share), 6) for share in dataset.get("quantile", ())]
    quantiles = kept("quantile")
    middle = [quantiles[shares.index(share)] if shares else math.nan for share in _QUANTILES]
    ends = [kept(kind)[0] for kind in ("least", "most", "mean", "std")]
    return [float(number) for number in (ends[0], *middle, *ends[1:])]


def _truths(found: list[Answer], language: Language) -> str:
    words = PHRASES[language]
    rows: list[tuple[str, str]] = []
    for answer in found:
        quantity = QUANTITIES[answer.name]
        values = answer.values[np.isfinite(answer.values)]
        if quantity.holds == "truth" and values.size:
            share = general(100 * float(values.mean()), 3, language=language)
            told = words["share"].format(
                share=share, count=grouped(values.size), text=words[answer.name]
            )
            rows.append((called(answer.name, language), told))
    return listing(rows) if rows else ""


def _agreement(found: list[Answer], language: Language) -> str:
    """Where the motion and the criterion of the portrait have both been asked."""
    both = {answer.name: answer.values for answer in found}
    if not {"stalls", "clamp_stalls"} <= set(both):
        return ""
    seen, told = both["stalls"], both["clamp_stalls"]
    known = np.isfinite(seen) & np.isfinite(told)
    alike = int((seen[known] == told[known]).sum())
    return paragraph(
        PHRASES[language]["agree"].format(alike=grouped(alike), count=grouped(int(known.sum())))
    )
