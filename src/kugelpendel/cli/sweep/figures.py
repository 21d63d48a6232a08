"""The figures that answer what a sweep was asked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kugelpendel.cli.sweep.phrases import PHRASES
from kugelpendel.cli.sweep.report import Answer, answers
from kugelpendel.errors import InvalidInput
from kugelpendel.sweeps._quantities import QUANTITIES
from kugelpendel.sweeps._sensitivity import sensitivity
from kugelpendel.sweeps._spoken import called_after

if TYPE_CHECKING:
    from xarray import Dataset

    from kugelpendel.errors import Language
    from kugelpendel.sweeps.cases import Sweep


def figures(sweep: Sweep, dataset: Dataset, language: Language = "en") -> dict[str, Any]:
    """Draw what was asked for: figures of matplotlib by the names of their files.

    Parameters
    ----------
    sweep
        What was asked for.
    dataset
        What it came to.
    language
        Of the labels.

    Returns
    -------
    Of a grid over two numbers or more a map of each result, with contours; regions for what is true
    or not, basins for directions; of a grid over one number a curve; of samples the distribution of
    each result; of a Sobol design also what moves it. What has no answer in any case, and what does
    not move, has no figure.
    """
    if not sweep.keeps_all:
        return dict(_of_reductions(sweep, dataset, language))
    wide = sum(size > 1 for size in sweep.shape)
    if sweep.design == "grid" and wide:
        return dict(_of_a_grid(sweep, dataset, wide, language))
    drawn: dict[str, Any] = {}
    for answer in answers(sweep, dataset):
        drawn.update(_of_a_sample(sweep, answer, language))
    return drawn


def _of_a_grid(
    sweep: Sweep, dataset: Dataset, wide: int, language: Language
) -> list[tuple[str, Any]]:
    from kugelpendel import plot

    drawn: list[tuple[str, Any]] = []
    for name in sweep.quantities:
        holds = QUANTITIES[name].holds
        times = sweep.times if QUANTITIES[name].per_time else (None,)
        for time in times:
            file = f"{name}{_suffix(sweep, time)}"
            if wide == 1:
                drawn.append((file, plot.sweeps.curve(dataset, name, time, language=language)))
            elif holds == "axis":
                drawn.append((file, plot.sweeps.basins(dataset, name, language=language)))
            elif holds == "truth":
                asked = name == "stalls" and "clamp_stalls" in dataset
                beside = "clamp_stalls" if asked else None
                drawn.append((file, plot.sweeps.regions(dataset, name, beside, language=language)))
            else:
                drawn.append((file, plot.sweeps.values_map(dataset, name, time, language=language)))
    return drawn


def _of_reductions(sweep: Sweep, dataset: Dataset, language: Language) -> list[tuple[str, Any]]:
    """Distributions, where histograms were kept."""
    from kugelpendel import plot

    drawn: list[tuple[str, Any]] = []
    for name in sweep.quantities:
        quantity = QUANTITIES[name]
        if f"{name}_histogram" not in dataset or quantity.holds == "truth":
            continue
        middle = 0.5 * (dataset[f"{name}_lower"].values + dataset[f"{name}_upper"].values)
        for k, time in enumerate(sweep.times if quantity.per_time else (None,)):
            counts = dataset[f"{name}_histogram"]
            counts = counts.isel(time=k) if quantity.per_time else counts
            title = called_after(name, time, language)
            weights = np.asarray(counts.values, np.float64)
            if not weights[np.isfinite(middle)].sum():
                continue
            found = plot.sweeps.distribution(middle, name, quantity.unit, title, weights, language)
            drawn.append((f"{name}{_suffix(sweep, time)}", found))
    return drawn


def _of_a_sample(sweep: Sweep, answer: Answer, language: Language) -> list[tuple[str, Any]]:
    from kugelpendel import plot

    drawn: list[tuple[str, Any]] = []
    quantity = QUANTITIES[answer.name]
    file = f"{answer.name}{_suffix(sweep, answer.time)}"
    title = called_after(answer.name, answer.time, language)
    if quantity.holds != "truth":
        try:
            found = plot.sweeps.distribution(
                answer.values, answer.name, quantity.unit, title, language=language
            )
            drawn.append((file, found))
        except InvalidInput:  # the report has said so
            return drawn
    if sweep.design == "sobol":
        try:
            indices = sensitivity(
                answer.values, sweep.names, second_order=sweep.second_order, seed=sweep.seed
            )
        except InvalidInput:  # the report has said so
            return drawn
        shares = plot.sweeps.shares(
            indices, PHRASES[language]["moves"].format(title=title).rstrip(":"), language
        )
        drawn.append((f"{file}-causes", shares))
    return drawn


def _suffix(sweep: Sweep, time: float | None) -> str:
    """Tells the times of one quantity apart in the names of files."""
    if time is None or len(sweep.times) < 2:
        return ""
    return f"-{list(sweep.times).index(time) + 1}"
