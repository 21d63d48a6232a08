"""Projects of Tracker (.trk): XML with pixels, an origin, an angle, a scale and frames."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element, ParseError

import numpy as np

from kugelpendel.errors import InvalidInput, require_extra
from kugelpendel.tracks._note import Note
from kugelpendel.tracks.read._sheet import Column, Sheet

_MASS = "PointMass"


def read_project(content: bytes, file: str) -> Sheet:
    """The masses of a project in its own axes: x and y in m, y upward, and the time in s.

    Raises
    ------
    InvalidInput
        It is no such project, has no mass, or has entities, which a project never needs.
    """
    require_extra("fit", file, "defusedxml")
    from defusedxml.common import DefusedXmlException
    from defusedxml.ElementTree import fromstring

    try:
        root = fromstring(content, forbid_dtd=True)
    except DefusedXmlException as error:
        raise InvalidInput.of("track_trk_entities", file=file) from error
    except (ParseError, ValueError, LookupError) as error:
        raise InvalidInput.of("track_trk", file=file, what=str(error)) from error
    masses = [found for found in root.iter("object") if found.get("class", "").endswith(_MASS)]
    bodies = [
        (_text(mass, "name") or f"mass {i + 1}", _steps(mass)) for i, mass in enumerate(masses)
    ]
    bodies = [(name, steps) for name, steps in bodies if len(steps)]
    if not bodies:
        raise InvalidInput.of("track_trk_no_mass", file=file)
    clip, control = _one(root, "VideoClip"), _one(root, "StepperClipControl")
    step = max(1, int(_number(clip, "stepsize", 1.0)))
    start = _number(clip, "startframe", 0.0)
    delta = _number(control, "delta_t", 0.0) / 1000
    coords = _one(root, "ImageCoordSystem")
    axes = _Axes(coords)
    columns: list[Column] = []
    for name, steps in bodies:
        frames, pixels = steps[:, 0], steps[:, 1:]
        x, y = axes.place(frames, pixels)
        unit = "m" if axes.has_scale else "px"
        if delta > 0:
            columns.append(Column("t", "s", name, (frames - start) * delta))
        columns.append(Column("frame", "", name, frames - start))
        columns += [Column("x", unit, name, x), Column("y", unit, name, y)]
    notes = [Note.of("trk_axes", x=axes.origin[0], y=axes.origin[1], angle=axes.angle)]
    notes.append(
        Note.of("trk_scale", scale=axes.scale) if axes.has_scale else Note.of("trk_no_scale")
    )
    first = bodies[0][1][:, 0]
    expected = int((first[-1] - first[0]) / step) + 1
    if expected > len(first):
        notes.append(Note.of("frames_missing", count=expected - len(first)))
    return _padded(columns, notes)


def _padded(columns: list[Column], notes: list[Note]) -> Sheet:
    """Give all columns the length of the longest, as a sheet has them."""
    most = max(len(column.numbers) for column in columns)
    for column in columns:
        rest = np.full(most - len(column.numbers), np.nan)
        column.numbers = np.concatenate((column.numbers, rest))
    if len({column.body for column in columns}) == 1:
        for column in columns:
            column.body = ""
    return Sheet(columns, [], True, notes)


class _Axes:
    """The coordinate system of a project, which may change from frame to frame."""

    def __init__(self, coords: Element | None) -> None:
        entries: list[tuple[int, Element]] = []
        data = None if coords is None else _property(coords, "framedata")
        for entry in () if data is None else data.findall("property"):
            inner = entry.find("object")
            if inner is not None and (index := re.fullmatch(r"\[(\d+)\]", entry.get("name", ""))):
                entries.append((int(index[1]), inner))
        self._starts = np.array([frame for frame, _ in entries] or [0])
        rows = [
            (
                _number(one, "xorigin", 0.0),
                _number(one, "yorigin", 0.0),
                math.radians(_number(one, "angle", 0.0)),
                _number(one, "xscale", 1.0),
                _number(one, "yscale", 1.0),
            )
            for _, one in entries
        ]
        self._rows = np.array(rows or [(0.0, 0.0, 0.0, 1.0, 1.0)])
        self.origin = (float(self._rows[0, 0]), float(self._rows[0, 1]))
        self.angle = math.degrees(float(self._rows[0, 2]))
        self.scale = float(self._rows[0, 3])
        self.has_scale = bool(rows) and bool((self._rows[:, 3:] != 1.0).any())

    def place(self, frames: np.ndarray, pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Positions in the axes of the project, y upward, which the image counts downward."""
        at = np.clip(np.searchsorted(self._starts, frames, side="right") - 1, 0, None)
        x0, y0, angle, scale_x, scale_y = self._rows[at].T
        right, up = pixels[:, 0] - x0, y0 - pixels[:, 1]
        cos, sin = np.cos(angle), np.sin(angle)
        return (right * cos + up * sin) / scale_x, (up * cos - right * sin) / scale_y


def _steps(mass: Element) -> np.ndarray:
    """Frame, x and y in pixels of each position; shape (n, 3)."""
    data = _property(mass, "framedata")
    rows: list[tuple[float, float, float]] = []
    for entry in () if data is None else data.findall("property"):
        inner = entry.find("object")
        index = re.fullmatch(r"\[(\d+)\]", entry.get("name", ""))
        if inner is None:
            continue
        frame = _number(inner, "n", float(index[1]) if index else math.nan)
        row = (frame, _number(inner, "x", math.nan), _number(inner, "y", math.nan))
        if all(map(math.isfinite, row)):
            rows.append(row)
    return np.array(rows, dtype=float).reshape(-1, 3)


def _one(root: Element, ending: str) -> Element | None:
    return next((o for o in root.iter("object") if o.get("class", "").endswith(ending)), None)


def _children(element: Element) -> Iterator[Element]:
    yield from element.findall("property")


def _property(element: Element, name: str) -> Element | None:
    return next((child for child in _children(element) if child.get("name") == name), None)


def _text(element: Element, name: str) -> str:
    found = _property(element, name)
    return (found.text or "").strip() if found is not None else ""


def _number(element: Element | None, name: str, otherwise: float) -> float:
    try:
        return float(_text(element, name)) if element is not None else otherwise
    except ValueError:
        return otherwise
