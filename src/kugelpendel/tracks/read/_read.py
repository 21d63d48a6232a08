"""From a file to a track."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import cast

import numpy as np

from kugelpendel.errors import InvalidInput, require_extra
from kugelpendel.parameters import one_number, one_truth
from kugelpendel.tracks._asked import require, require_listener, require_text
from kugelpendel.tracks._ellipse_table import EllipseTable
from kugelpendel.tracks._note import Note
from kugelpendel.tracks._track import Track
from kugelpendel.tracks.read import _clean, _clock, _trk
from kugelpendel.tracks.read._cells import Numbers
from kugelpendel.tracks.read._columns import (
    ACCELERATIONS,
    Roles,
    angle_of,
    length_of,
    measures_gravity,
    roles_of,
)
from kugelpendel.tracks.read._parquet import read_parquet
from kugelpendel.tracks.read._rows import take_apart
from kugelpendel.tracks.read._sheet import Column, Sheet
from kugelpendel.tracks.read._text import decode
from kugelpendel.tracks.reduction._carrier import first_guess, swing_frequency

_LARGEST_IN_METRES = 30.0
"""Without a scale, Tracker's positions are pixels, and a picture has hundreds of them."""


def read(
    path: str | Path,
    *,
    columns: Mapping[str, str | int] | None = None,
    mass: str | None = None,
    rate: float | None = None,
    scale: float | None = None,
    y_down: bool | None = None,
    progress: Callable[[float], None] | None = None,
) -> Track | EllipseTable:
    """Read a recorded track, or a table of ready ellipses.

    Text in columns is read whatever its encoding, separator and decimal mark; so are projects of
    Tracker (.trk), exports of phones' sensors and Parquet. Whatever was changed, dropped or assumed
    is in the track's `notes`.

    Parameters
    ----------
    path
        The file.
    columns
        Which column is what, by its name or by its number from 1 on: of "time", "date", "frame",
        "x", "y", or "a", "b", "azimuth" for ellipses. By their names unless given.
    mass
        Which one to read, where a file has several.
    rate
        Frames a second, for files that number frames, or count none at all.
    scale
        Of one unit of the file in m, such as metres a pixel. Unless given, the unit of the file is
        used, and pixels remain pixels.
    y_down
        Whether y points downward, as in images; that flips the sense. Unless given, it does so for
        positions in pixels by name, and nowhere else; which of the two is in the notes.
    progress
        Called with the share that is read; what it raises ends the reading.

    Returns
    -------
    Track or EllipseTable
        A Track of positions; an EllipseTable where the file has a, b and azimuth in place of x and
        y. Positions out of accelerations have `axes` "phone".

    Raises
    ------
    InvalidInput
        Something is of another type, the file is not there, has no track in it, leaves open which
        of several masses is meant, or has frames and no `rate`. Every case has its own `kind`.
    MissingExtra
        A Tracker project or Parquet is read without the extra [fit].
    """
    is_name = isinstance(path, (str, Path))  # pyright: ignore[reportUnnecessaryIsInstance]
    require(is_name, "The path", path, "file's name", "write it in quotes")
    _require_columns(columns)
    if mass is not None:
        require_text("The mass", mass)
    require_listener(progress)
    rate = None if rate is None else one_number(rate, "rate", "1/s")
    if rate is not None and not 0 < rate < np.inf:
        raise InvalidInput.of("track_rate", rate=rate)
    scale = None if scale is None else one_number(scale, "scale", "m")
    if scale is not None and not 0 < scale < np.inf:
        raise InvalidInput.of("track_scale", scale=scale)
    y_down = None if y_down is None else one_truth(y_down, "The option y_down")
    file = Path(path)
    return told(_sheet(file, progress), file, columns, mass, rate, scale, y_down)


def told(
    sheet: Sheet,
    file: Path,
    columns: Mapping[str, str | int] | None,
    mass: str | None,
    rate: float | None,
    scale: float | None,
    y_down: bool | None,
) -> Track | EllipseTable:
    """Say what the columns of a sheet are, and make a track of them; for the rest as `read`."""
    roles = roles_of(sheet, file.name, columns, mass, rate is not None)
    found = roles.columns
    count = len(next(iter(found.values())).numbers)
    time, of_time = _clock.seconds(
        found.get("time"), found.get("date"), found.get("frame"), rate, count, file.name
    )
    notes = [*sheet.notes, *roles.notes, *of_time]
    if "x" not in found:
        return _ellipses(found, time, notes, scale, y_down, file.name)
    return _track(roles, time, notes, scale, y_down, file)


def _require_columns(columns: object) -> None:
    """Raise InvalidInput for what does not say which column is what."""
    is_right = columns is None or (
        isinstance(columns, Mapping)
        and all(
            isinstance(role, str) and isinstance(column, (str, int))
            for role, column in cast("Mapping[object, object]", columns).items()
        )
    )
    way_out = 'write columns={"time": 1, "x": "x (m)", "y": 3}'
    require(is_right, "columns", cast("object", columns), "mapping of names to columns", way_out)


def _sheet(file: Path, progress: Callable[[float], None] | None) -> Sheet:
    try:
        content = file.read_bytes()
    except OSError as error:
        raise InvalidInput.of(
            "track_not_read", file=str(file), what=error.strerror or str(error)
        ) from error
    if content.startswith(b"PAR1"):
        return read_parquet(file)
    if file.suffix.lower() == ".trk" or content[:5].lstrip(b"\xef\xbb\xbf").startswith(b"<?xml"):
        return _trk.read_project(content, file.name)
    text, notes = decode(content, file.name)
    del content
    sheet = take_apart(text, file.name, progress)
    sheet.notes[:0] = notes
    return sheet


def _track(
    roles: Roles,
    time: Numbers,
    notes: list[Note],
    scale: float | None,
    y_down: bool | None,
    file: Path,
) -> Track:
    x, y = _numbers(roles.columns, "x", file.name), _numbers(roles.columns, "y", file.name)
    if roles.is_acceleration:
        return _of_accelerations(roles, time, notes, file.name)
    x, y, marked = _clean.without_marks(x, y)
    time, places, dropped = _clean.cleaned(time, np.column_stack((x, y)), file.name)
    time, places, stale = _clean.without_stale(time, places, file.name)
    unit = roles.columns["x"].unit
    size, name = length_of(unit)
    other_size, other = length_of(roles.columns["y"].unit)
    sizes = np.array([size, other_size])
    of_unit: list[Note] = []
    if scale is not None:
        sizes, said, name = np.array([scale, scale]), unit or "unit", "m"
        of_unit.append(Note.of("scale", unit=said, scale=scale))
    elif name != other:
        raise InvalidInput.of(
            "track_units_differ",
            file=file.name,
            x=unit or "none",
            y=roles.columns["y"].unit or "none",
        )
    elif not name:
        is_small = _by_tracker(roles) and float(np.abs(places).max()) < _LARGEST_IN_METRES
        name = "m" if is_small else "unit"
        of_unit.append(Note.of("tracker_metres" if is_small else "no_unit"))
    elif size != 1 or name == "px":
        of_unit.append(
            Note.of("unit_px") if name == "px" else Note.of("unit", unit=unit, size=size)
        )
    places = places * sizes
    is_project = file.suffix.lower() == ".trk"
    flip, of_sense = _sense(y_down, length_of(unit)[1] == "px" and not is_project, is_project)
    if flip:
        places = places * (1, -1)
    listed = (*notes, *marked, *dropped, *stale, *_clean.gaps(time), *of_unit, *of_sense)
    return Track(time, places[:, 0], places[:, 1], name, listed)


def _by_tracker(roles: Roles) -> bool:
    """Say whether the file is a text out of Tracker, which names the mass above t, x and y."""
    return roles.below_mass and [c.name for c in roles.columns.values()] == ["t", "x", "y"]


def _sense(y_down: bool | None, is_image: bool, is_known: bool) -> tuple[bool, list[Note]]:
    """Whether y is to be turned round, and what was assumed about it."""
    if y_down is not None:
        return y_down, [Note.of("y_down")] if y_down else []
    if is_known:
        return False, []
    return is_image, [Note.of("y_down_assumed" if is_image else "y_up_assumed")]


def _numbers(columns: Mapping[str, Column], role: str, file: str) -> Numbers:
    column = columns[role]
    if column.texts is not None:
        raise InvalidInput.of(
            "track_column_of_words",
            file=file,
            role=role,
            seen=column.name or role,
            example=column.texts[0],
        )
    return column.numbers


def _of_accelerations(roles: Roles, time: Numbers, notes: list[Note], file: str) -> Track:
    """Position = −acceleration/ω², in the axes of the phone."""
    x, y = _numbers(roles.columns, "x", file), _numbers(roles.columns, "y", file)
    time, values, dropped = _clean.cleaned(time, np.column_stack((x, y)), file)
    time, values, stale = _clean.without_stale(time, values, file)
    values = values * ACCELERATIONS.get(roles.columns["x"].unit.lower(), 1.0)
    require_extra("fit", "an export of accelerations", "scipy")
    z = values[:, 0] + 1j * values[:, 1]
    omega = swing_frequency(time, z, first_guess(z))
    centred = values - values.mean(axis=0)
    places = -centred / omega**2
    told = [Note.of("phone", period=2 * np.pi / omega)]
    if measures_gravity(roles.columns["x"]):
        told.append(Note.of("phone_gravity", name=roles.columns["x"].name))
    listed = (*notes, *dropped, *stale, *_clean.gaps(time), *told)
    return Track(time, places[:, 0], places[:, 1], "m", listed, "phone")


def _ellipses(
    found: Mapping[str, Column],
    time: Numbers,
    notes: list[Note],
    scale: float | None,
    y_down: bool | None,
    file: str,
) -> EllipseTable:
    """Ready ellipses, with the axial angle on one branch."""
    a, b, angle = (_numbers(found, role, file) for role in ("a", "b", "azimuth"))
    time, values, dropped = _clean.cleaned(time, np.column_stack((a, b, angle)), file)
    a, b, angle = values.T
    unit = angle_of(found["azimuth"].unit)
    if unit is None:
        in_degrees = bool(np.abs(angle).max() > 2 * np.pi)
        unit = np.pi / 180 if in_degrees else 1.0
        notes = [*notes, Note.of("angle_unit_assumed", unit="deg" if in_degrees else "rad")]
    size, name = length_of(found["a"].unit)
    if scale is not None:
        size, name = scale, "m"
        notes = [*notes, Note.of("scale", unit=found["a"].unit or "unit", scale=scale)]
    elif not name:
        notes = [*notes, Note.of("no_unit")]
    psi = np.unwrap(angle * unit, period=np.pi)
    wraps = int((np.abs(np.diff(angle * unit)) > np.pi / 2).sum())
    if wraps:
        notes = [*notes, Note.of("angle_unwrapped", count=wraps)]
    flip, of_sense = _sense(y_down, name == "px", False)
    if flip:
        b, psi = -b, -psi
    if (a < np.abs(b)).any():
        notes = [*notes, Note.of("axes_exchanged", count=int((a < np.abs(b)).sum()))]
        swap = a < np.abs(b)
        psi = np.unwrap(psi + np.pi / 2 * swap, period=np.pi)
        a, b = np.maximum(a, np.abs(b)), np.copysign(np.minimum(a, np.abs(b)), b)
    listed = (*notes, *dropped, *_clean.gaps(time), *of_sense)
    return EllipseTable(time, a * size, b * size, psi, name or "unit", listed)
