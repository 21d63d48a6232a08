"""A picture of what rests on what: layers of equations, drawn as SVG.

Layered drawing after K. Sugiyama, S. Tagawa and M. Toda, IEEE Trans. Syst. Man Cybern. 11, 109
(1981): layers by longest path, long lines cut at each layer, order by barycentres. A small own
version, since no other part of the document needs a program for graphs.
"""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

_WIDTH, _HEIGHT = 58, 28  # px, of a box, as the page's style has them
_ACROSS, _DOWN = 74, 56  # px, from box to box
_BEND = 26  # px, that a line takes where it passes a layer
_SWEEPS = 12


@dataclass(frozen=True)
class Box:
    """One equation of the picture.

    Attributes
    ----------
    label
        The equation's label, which stands in the box.
    style
        CSS classes, such as "numbered" or "misprint".
    hint
        A sentence that is shown where the pointer rests; "" shows none.
    """

    label: str
    style: str
    hint: str


def draw(boxes: Sequence[Box], premises: Mapping[str, Sequence[str]], title: str) -> str:
    """Draw equations below those that they rest on.

    Parameters
    ----------
    boxes
        The equations, in an order where premises come first.
    premises
        The labels that each label rests on; those without a box are left out.
    title
        What the picture shows, for those who do not see it.

    Returns
    -------
    An ``svg`` element; each box links to ``#eq-LABEL``.
    """
    known = {box.label for box in boxes}
    edges = [
        (before, box.label)
        for box in boxes
        for before in dict.fromkeys(premises.get(box.label, ()))
        if before in known and before != box.label
    ]
    layers, chains = _layers([box.label for box in boxes], edges)
    _order(layers, chains)
    place = _places(layers)
    width = max((x for x, _ in place.values()), default=0) + _ACROSS
    height = len(layers) * _DOWN + 8
    lines = "".join(_line([place[stop] for stop in chain]) for chain in chains)
    drawn = "".join(_box(box, *place[box.label]) for box in boxes)
    return (
        f'<svg class="graph" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}"'
        f' height="{height:.0f}" role="group" aria-label="{escape(title)}">'
        f"{lines}{drawn}</svg>"
    )


def contracted(
    kept: Sequence[str], premises: Mapping[str, Sequence[str]]
) -> dict[str, tuple[str, ...]]:
    """What each of some labels rests on among them, directly or through labels not kept."""
    among = set(kept)
    found: dict[str, tuple[str, ...]] = {}
    for label in kept:
        reached: dict[str, None] = {}
        seen = {label}
        waiting = list(premises.get(label, ()))
        while waiting:
            before = waiting.pop(0)
            if before in seen:
                continue
            seen.add(before)
            if before in among:
                reached[before] = None
            else:
                waiting.extend(premises.get(before, ()))
        found[label] = tuple(reached)
    return found


def _layers(
    labels: Sequence[str], edges: Sequence[tuple[str, str]]
) -> tuple[list[list[str]], list[list[str]]]:
    """Layers of stops, and for each edge the stops that it goes through."""
    depth = dict.fromkeys(labels, 0)
    for label in labels:
        above = [depth[before] + 1 for before, after in edges if after == label]
        depth[label] = max(above, default=0)
    layers: list[list[str]] = [[] for _ in range(max(depth.values(), default=-1) + 1)]
    for label in labels:
        layers[depth[label]].append(label)
    # A source stands just above the first that needs it, not in the top layer by default.
    for label in labels:
        below = [depth[after] for before, after in edges if before == label]
        if depth[label] == 0 and below and min(below) > 1:
            layers[0].remove(label)
            depth[label] = min(below) - 1
            layers[depth[label]].append(label)
    chains: list[list[str]] = []
    for before, after in edges:
        chain = [before]
        for level in range(depth[before] + 1, depth[after]):
            stop = f"{before}>{after}>{level}"
            layers[level].append(stop)
            chain.append(stop)
        chains.append([*chain, after])
    return layers, chains


def _order(layers: list[list[str]], chains: Sequence[Sequence[str]]) -> None:
    """Sort each layer by where its neighbours lie, down and up in turn."""
    above: dict[str, list[str]] = {}
    below: dict[str, list[str]] = {}
    for chain in chains:
        for upper, lower in pairwise(chain):
            above.setdefault(lower, []).append(upper)
            below.setdefault(upper, []).append(lower)
    for sweep in range(_SWEEPS):
        down = sweep % 2 == 0
        neighbours = above if down else below
        rank = {stop: at / max(len(layer), 1) for layer in layers for at, stop in enumerate(layer)}
        for layer in layers if down else reversed(layers):
            where = dict(rank)

            def middle(
                stop: str,
                near: dict[str, list[str]] = neighbours,
                where: dict[str, float] = where,
            ) -> float:
                beside = near.get(stop, [])
                return (
                    sum(where[other] for other in beside) / len(beside) if beside else where[stop]
                )

            layer.sort(key=middle)
            rank.update({stop: at / len(layer) for at, stop in enumerate(layer)})


def _places(layers: Sequence[Sequence[str]]) -> dict[str, tuple[float, float]]:
    """The middle of each stop, px, each layer centred."""
    widths = [sum(_room(stop) for stop in layer) for layer in layers]
    widest = max(widths, default=0)
    place: dict[str, tuple[float, float]] = {}
    for level, (layer, width) in enumerate(zip(layers, widths, strict=True)):
        x = (widest - width) / 2 + 8
        for stop in layer:
            place[stop] = (x + _room(stop) / 2, level * _DOWN + _DOWN / 2)
            x += _room(stop)
    return place


def _room(stop: str) -> int:
    return _BEND if ">" in stop else _ACROSS


def _line(stops: Sequence[tuple[float, float]]) -> str:
    """A line that leaves and enters each stop upright; relative, as there are hundreds of them."""
    last = len(stops) - 1
    ends = [round(y - _HEIGHT / 2 if number == last else y) for number, (_, y) in enumerate(stops)]
    at, height = round(stops[0][0]), round(stops[0][1] + _HEIGHT / 2)
    path = f"M{at} {height}"
    for number, (x, _) in enumerate(stops[1:], start=1):
        aside, down = round(x) - at, ends[number] - height
        bend = f"{aside} {down // 2} {aside} {down}"
        path += f"c0 {down // 2} {bend}" if number == 1 else f"s{bend}"
        at, height = round(x), ends[number]
    return f'<path d="{path}"/>'


def _box(box: Box, x: float, y: float) -> str:
    label, style = escape(box.label), escape(box.style)
    hint = f"<title>{escape(box.hint)}</title>" if box.hint else ""
    return (
        f'<a href="#eq-{label}" class="{style}">{hint}'
        f'<rect x="{x - _WIDTH / 2:.0f}" y="{y - _HEIGHT / 2:.0f}"/>'
        f'<text x="{x:.0f}" y="{y + 4:.0f}">{label}</text></a>'
    )
