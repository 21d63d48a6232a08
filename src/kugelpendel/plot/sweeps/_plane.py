"""The panels of a map over two of the numbers that vary, and over a third from panel to panel."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from matplotlib.patches import Patch

from kugelpendel.parameters import InvalidInput
from kugelpendel.plot import _ink
from kugelpendel.plot.sweeps._labels import label, with_unit
from kugelpendel.plot.tracks._page import localise
from kugelpendel.spelling import Unit, general
from kugelpendel.sweeps._spoken import called, unit_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray
    from xarray import DataArray, Dataset

    from kugelpendel.errors import Language

_PANELS = 6
"""Levels of a third number that are drawn at most."""

_CELLS = 1000
"""Levels of each of the two numbers that are drawn at most, evenly spread: more are closer than
pixels, and are drawn at once, for which Ctrl-C has to wait."""


@dataclass(frozen=True)
class Side:
    """One of the two numbers of a map, with its label and unit."""

    label: str
    values: NDArray[np.float64]
    log: bool

    @property
    def edges(self) -> NDArray[np.float64]:
        """Between the values, and as far beyond the outer ones."""
        places = np.log(self.values) if self.log else self.values
        middle = 0.5 * (places[1:] + places[:-1])
        ends = (2 * places[0] - middle[0], 2 * places[-1] - middle[-1])
        edges = np.concatenate(([ends[0]], middle, [ends[1]]))
        return np.exp(edges) if self.log else edges


@dataclass(frozen=True)
class Panel:
    """A map at one level of a third number: values by row (up) and column (across)."""

    axes: Axes
    place: dict[str, int]
    values: NDArray[np.float64]

    @property
    def is_whole(self) -> bool:
        """Whether every case has an answer."""
        return bool(np.isfinite(self.values).all())


@dataclass(frozen=True)
class Plane:
    """A figure with one panel or several."""

    figure: Figure
    across: Side
    up: Side
    panels: list[Panel]
    order: tuple[str, str]
    dataset: Dataset
    language: Language

    def other(self, name: str, panel: Panel) -> NDArray[np.float64]:
        """Another quantity in the same panel."""
        return _rows(self.dataset[name], self.order, panel.place)

    def note_missing(self, key: str = "missing") -> list[Patch]:
        """What the legend says of cells without an answer; nothing where there are none."""
        if all(panel.is_whole for panel in self.panels):
            return []
        said = label(key, self.language)
        return [Patch(facecolor="white", edgecolor="#b5b9c0", hatch="xxx", label=said)]


def plane(dataset: Dataset, name: str, time: float | None, title: str, language: Language) -> Plane:
    """Lay out the panels of a quantity of a grid, with the label of everything but its values.

    The two numbers with the most levels are across and up, in the order of the file, a thousand of
    their levels at most; a third one goes from panel to panel, six of its levels at most; the rest
    stay in their middle, which the title says. Raises InvalidInput for what is no grid of two
    numbers.
    """
    data = at_time(dataset, name, time)
    sizes = {str(dim): int(size) for dim, size in data.sizes.items()}
    wide = [dim for dim in sizes if sizes[dim] > 1]
    if len(wide) < 2 or "case" in sizes:
        raise InvalidInput(
            f'A map needs a grid over two numbers at least, but "{name}" varies over '
            f"{', '.join(wide) or 'none'}."
        )
    largest = sorted(wide, key=lambda dim: -sizes[dim])[:2]
    across, up = (dim for dim in wide if dim in largest)
    rest = [dim for dim in wide if dim not in largest]
    dataset = dataset.isel(
        {dim: slice(None, None, -(-sizes[dim] // _CELLS)) for dim in (across, up)}
    )
    data = at_time(dataset, name, time)
    fixed = {dim: sizes[dim] // 2 for dim in sizes if dim not in (across, up)}
    count = min(sizes[rest[0]], _PANELS) if rest else 1
    columns = min(count, 3)
    rows = math.ceil(count / columns)
    figure = _ink.blank(*((8.2, 6.2) if count == 1 else (3.6 * columns + 1.8, 3.2 * rows + 1.4)))
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    sides = (side_of(dataset, across, language), side_of(dataset, up, language))
    panels: list[Panel] = []
    for k, axes in enumerate(cast("list[Axes]", list(grid.flat))):
        if k >= count:
            axes.set_visible(False)
            continue
        place = dict(fixed)
        if rest:
            place[rest[0]] = round(k * (sizes[rest[0]] - 1) / max(count - 1, 1))
            said = _said(dataset, rest[0], place[rest[0]], language)
            axes.set_title(said, fontsize=9.5, fontweight="normal")
        localise(axes, language)
        _prepare(axes, sides, last=k + columns >= count, first=k % columns == 0)
        panels.append(Panel(axes, place, _rows(data, (across, up), place)))
    held = "; ".join(_said(dataset, dim, fixed[dim], language) for dim in rest[1:])
    _ink.entitle(figure, f"{title} ({held})" if held else title, 80 if count > 1 else 64)
    return Plane(figure, *sides, panels, (across, up), dataset, language)


def at_time(dataset: Dataset, name: str, time: float | None) -> DataArray:
    """A quantity at one of its times, the last unless one is given."""
    moment = time_of(dataset, name, time)
    return dataset[name] if moment is None else dataset[name].sel(time=moment)


def time_of(dataset: Dataset, name: str, time: float | None) -> float | None:
    """The time in s at which a quantity is drawn, the last unless one is given; None for none."""
    if "time" not in dataset[name].dims:
        return None
    return float(dataset["time"].values[-1]) if time is None else time


def unit_in(dataset: Dataset, name: str, values: NDArray[np.float64]) -> Unit:
    """The unit in which values of a quantity or of what varies are said; they are finite."""
    si = str(dataset[name].attrs.get("units", "1"))
    return unit_of(name, float(np.abs(values).max(initial=0.0)), si)


def hatched(axes: Axes) -> None:
    """Make the ground of a panel that of cells without an answer."""
    axes.patch.set(facecolor="white", edgecolor="#b5b9c0", hatch="xxx", linewidth=0)


def _rows(data: Any, order: tuple[str, str], place: dict[str, int]) -> NDArray[np.float64]:
    if "time" in data.dims:
        data = data.isel(time=-1)
    chosen = data.isel({dim: k for dim, k in place.items() if dim in data.dims})
    across, up = order
    return np.asarray(chosen.transpose(up, across).values, np.float64)


def side_of(dataset: Dataset, dim: str, language: Language) -> Side:
    """What varies along a dimension, in the unit in which it is said."""
    values = np.asarray(dataset[dim].values, np.float64)
    unit = unit_in(dataset, dim, values)
    return Side(with_unit(called(dim, language), unit.symbol), values / unit.size, _is_log(values))


def _is_log(values: NDArray[np.float64]) -> bool:
    if len(values) < 3 or not (values > 0).all():
        return False
    steps, ratios = np.diff(values), np.diff(np.log(values))
    return bool(np.ptp(ratios) < 1e-6 * abs(ratios.mean()) and np.ptp(steps) > 1e-6 * abs(steps[0]))


def _said(dataset: Dataset, dim: str, level: int, language: Language) -> str:
    values = np.asarray(dataset[dim].values, np.float64)
    value = float(values[level])
    # Zero is said in the unit of the others.
    unit = unit_in(dataset, dim, values if value == 0 else values[[level]])
    gap = "" if unit.symbol in ("", "°") else " "
    number = general(value / unit.size, 4, language=language)
    return f"{called(dim, language)} = {number}{gap}{unit.symbol}"


def _prepare(axes: Axes, sides: tuple[Side, Side], *, last: bool, first: bool) -> None:
    across, up = sides
    if across.log:
        axes.set_xscale("log")
    if up.log:
        axes.set_yscale("log")
    axes.set_xlim(float(across.edges[0]), float(across.edges[-1]))
    axes.set_ylim(float(up.edges[0]), float(up.edges[-1]))
    if last:
        axes.set_xlabel(across.label)
        axes.tick_params(labelbottom=True)
    if first:
        axes.set_ylabel(up.label)


def meshed(panel: Panel, drawn: Plane) -> Iterator[NDArray[np.float64]]:
    """The edges of the cells across and up, and the values without what is not finite."""
    yield drawn.across.edges
    yield drawn.up.edges
    yield np.ma.masked_invalid(panel.values)
