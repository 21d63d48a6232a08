"""Which column is what: by its name, by what the user says, or by its place."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._note import Note
from kugelpendel.tracks.read._sheet import Column, Sheet
from kugelpendel.tracks.read._units import (
    ACCELERATIONS,
    ANGLES,
    FRAMES,
    LENGTHS,
    PIXELS,
    TIMES,
    is_unit,
)

ROLES = ("time", "date", "frame", "x", "y", "a", "b", "azimuth")
"""What a column may be."""

_WORDS = {
    "time": "t time times zeit timestamp uhrzeit elapsed datetime clock epoch unix seconds "
    "sekunden millis sec zeitpunkt zeitstempel temps tiempo",
    "date": "date datum day tag",
    "frame": "frame frames framenumber frameno bild bildnummer image index idx sample row",
    "x": "x cx posx xpos px xc laengs rechts",
    "y": "y cy posy ypos py yc quer hoch",
    "a": "a semimajor majoraxis halfmajor major grosse",
    "b": "b semiminor minoraxis halfminor minor kleine",
    "azimuth": "azimuth azimut angle psi winkel rotation orientation theta",
}
_ROLE_OF = {word: role for role, words in _WORDS.items() for word in words.split()}

_DECORATION = frozenset(
    [
        "position",
        "pos",
        "coordinate",
        "coord",
        "centroid",
        "center",
        "centre",
        "linear",
        "acceleration",
        "beschleunigung",
        "lineare",
        "lin",
        "acc",
        "accel",
        "semi",
        "axis",
        "half",
        "recorded",
        "abs",
        "absolute",
        "filtered",
        "raw",
        "pixel",
        "value",
        "smoothed",
        "number",
        "nr",
        "no",
        "achse",
        "halbachse",
        "mitte",
        "point",
        "location",
        "the",
        "of",
        "local",
        "utc",
        "stamp",
        "num",
        "displacement",
        "auslenkung",
    ]
)
_BODY_COLUMNS = frozenset(
    [
        "mass",
        "body",
        "bob",
        "object",
        "track",
        "particle",
        "id",
        "label",
        "pendulum",
        "masse",
        "pendel",
        "name",
    ]
)
_SENSOR = re.compile(r"(?i)acc|beschl")
_WITHOUT_GRAVITY = re.compile(r"(?i)lin|without g|ohne g|user")


@dataclass
class Roles:
    """Columns by what they are.

    Attributes
    ----------
    columns
        Of one mass, by role.
    is_acceleration
        Whether x and y are those of a sensor that measures acceleration.
    below_mass
        Whether the name of a mass stands above the columns.
    """

    columns: dict[str, Column]
    is_acceleration: bool = False
    below_mass: bool = False
    notes: list[Note] = field(default_factory=list[Note])


@dataclass
class _Name:
    role: str
    unit: str
    body: str


def unit_in(name: str) -> str:
    """The unit that the name of a column tells; "" for none."""
    return _parsed(name, "").unit


def _parsed(name: str, unit: str) -> _Name:
    plain = name.strip().strip('"').strip()
    inside = re.search(r"[\[(]([^\])]*)[\])]\s*$", plain)
    rest = plain
    if inside and (is_unit(inside[1]) or not inside[1].strip()):
        unit, rest = unit or inside[1].strip(), plain[: inside.start()]
    elif (parts := re.fullmatch(r"(.+?)\s*(?:/|,| in )\s*(\S+)", plain)) and is_unit(parts[2]):
        rest, unit = parts[1], unit or parts[2]
    rest = re.sub(r"[\[(].*?[\])]", lambda match: f" {match[0][1:-1]} ", rest)
    rest = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", rest)
    words = [word for word in re.split(r"[^\w²°µ]+|_", rest) if word]
    if (
        len(words) > 1
        and is_unit(words[-1])
        and words[-1].lower() not in ("d", "h", "in", "g", "s", "m")
    ) or (
        len(words) > 1
        and words[-1].lower() in ("s", "m")
        and words[0].lower() in (*"txyab", "time", "zeit")
    ):
        unit = unit or words.pop()
    role, spare = _role(words)
    return _Name(role, unit, " ".join(spare))


def _role(words: Sequence[str]) -> tuple[str, list[str]]:
    lower = [word.lower() for word in words]
    joined = "".join(word for word in lower if word not in ("axis", "achse", "recorded"))
    for whole in (joined, "".join(lower)):
        if whole in _ROLE_OF:
            return _ROLE_OF[whole], []
    for wanted in (("x", "y"), ("time", "date", "azimuth", "a", "b", "frame")):
        for index, word in enumerate(lower):
            role = _ROLE_OF.get(word, "")
            if role in wanted and (len(word) > 1 or role in ("x", "y") or len(words) <= 2):
                spare = [*words[:index], *words[index + 1 :]]
                return role, [one for one in spare if one.lower() not in _DECORATION]
    if len(words) == 1 and (parts := re.fullmatch(r"([xy])(\d+|[A-Z])", words[0])):
        return parts[1], [parts[2]]
    if len(words) == 1 and (parts := re.fullmatch(r"([xy])([a-z])", lower[0])):
        return parts[1], [words[0][1:]]
    return "", list(words)


def roles_of(
    sheet: Sheet, file: str, given: Mapping[str, str | int] | None, mass: str | None, has_rate: bool
) -> Roles:
    """Say which column is what.

    Raises
    ------
    InvalidInput
        A column that was asked for is not there, none can be told to be x and y, or there are
        several masses and none was chosen.
    """
    notes: list[Note] = []
    below_mass = any(re.match(r"(?i)mass", name) for _, name in sheet.bodies)
    for column in sheet.columns:
        found = _parsed(column.name, column.unit)
        column.unit = column.unit or found.unit
    if given:
        chosen = _given(sheet, file, given)
        return Roles(chosen, _are_accelerations(_positions(chosen)), below_mass, notes)
    _keep_body(sheet, file, mass, notes)
    columns = _by_name(sheet, file, mass, notes)
    if not _is_whole(columns):
        columns = _by_place(sheet, file, has_rate, columns, notes)
    used = {id(column) for column in columns.values()}
    spare = [c.name for c in sheet.columns if id(c) not in used and c.name]
    if spare:
        notes.append(Note.of("columns_ignored", names=", ".join(spare)))
    return Roles(columns, _are_accelerations(_positions(columns)), below_mass, notes)


def _positions(columns: Mapping[str, Column]) -> list[Column]:
    return [columns[role] for role in ("x", "y") if role in columns]


def _are_accelerations(columns: Sequence[Column]) -> bool:
    return any(
        bool(_SENSOR.search(column.name)) or column.unit.lower() in ACCELERATIONS
        for column in columns
    )


def measures_gravity(column: Column) -> bool:
    """Say whether the name of an acceleration leaves open that gravity is in it."""
    return not _WITHOUT_GRAVITY.search(column.name)


def _given(sheet: Sheet, file: str, given: Mapping[str, str | int]) -> dict[str, Column]:
    columns: dict[str, Column] = {}
    for role, said in given.items():
        role = {"t": "time", "angle": "azimuth", "psi": "azimuth"}.get(role, role)
        if role not in ROLES:
            raise InvalidInput.of("track_role", role=role, roles=", ".join(ROLES))
        columns[role] = _found(sheet, file, said)
    if not _is_whole(columns) and not {"x", "y"} <= columns.keys():
        raise InvalidInput.of("track_columns_incomplete", given=", ".join(given))
    return columns


def _found(sheet: Sheet, file: str, said: str | int) -> Column:
    plain = str(said).strip()
    if plain.isdigit() and 1 <= int(plain) <= len(sheet.columns):
        return sheet.columns[int(plain) - 1]
    alike = [c for c in sheet.columns if c.name and c.name.lower() == plain.lower()]
    alike += [
        c
        for c in sheet.columns
        if c.name and re.sub(r"\s*[\[(].*", "", c.name).strip(' "').lower() == plain.lower()
    ]
    if not alike:
        raise InvalidInput.of("track_column_unknown", file=file, seen=plain, names=_listed(sheet))
    return alike[0]


def _listed(sheet: Sheet) -> str:
    return ", ".join(
        f"{number} {column.name}".strip() for number, column in enumerate(sheet.columns, start=1)
    )


def _keep_body(sheet: Sheet, file: str, mass: str | None, notes: list[Note]) -> None:
    """Keep the rows of one mass, where rows belong to several."""
    count = len(sheet.columns[0].numbers)
    labels: list[str] = []
    blocks = [(at, name) for at, name in sheet.bodies if at < count]
    for column in sheet.columns:
        words = re.split(r"[\W_]+", column.name.lower())
        if column.name and set(words) & _BODY_COLUMNS and not _parsed(column.name, "").role:
            labels = column.texts or [f"{v:g}" for v in column.numbers]
    names = [name for _, name in blocks if name]
    if not labels and len(set(names)) > 1:
        name, starts = "", [at for at, _ in blocks] + [count]
        for (_, said), at, after in zip(blocks, starts, starts[1:], strict=False):
            name = said or name
            labels += [name] * (after - at)
    bodies = list(dict.fromkeys(labels))
    if len(bodies) < 2 or len(bodies) > 50:
        return
    chosen = _chosen(bodies, mass, file)
    keep = np.array([label == chosen for label in labels])
    for column in sheet.columns:
        column.numbers = column.numbers[keep]
        if column.texts is not None:
            column.texts = [text for text, one in zip(column.texts, keep, strict=True) if one]
    notes.append(
        Note.of("mass_chosen", name=chosen, others=", ".join(b for b in bodies if b != chosen))
    )


def _chosen(bodies: Sequence[str], mass: str | None, file: str) -> str:
    if mass is None:
        raise InvalidInput.of("track_masses", file=file, names=", ".join(bodies), first=bodies[0])
    for body in bodies:
        if mass.strip().lower() in (body.lower(), re.sub(r"(?i)^mass\s+", "", body).lower()):
            return body
    raise InvalidInput.of("track_mass_unknown", file=file, seen=mass, names=", ".join(bodies))


def _by_name(sheet: Sheet, file: str, mass: str | None, notes: list[Note]) -> dict[str, Column]:
    """The columns whose names tell what they are, those of one mass."""
    named: dict[str, dict[str, Column]] = {}
    for column in sheet.columns:
        if not column.name:
            continue
        found = _parsed(column.name, "")
        if found.role:
            body = column.body or found.body
            named.setdefault(found.role, {}).setdefault(body, column)
    both = [body for body in named.get("x", {}) if body in named.get("y", {})]
    if len(both) > 1:
        body = _chosen(both, mass, file)
        notes.append(
            Note.of("mass_chosen", name=body, others=", ".join(b for b in both if b != body))
        )
    else:
        body = both[0] if both else ""
    if all(role in named for role in ("a", "b", "azimuth")):  # their centres are no track
        named = {role: columns for role, columns in named.items() if role not in ("x", "y")}
    return {
        role: columns[body] if body in columns else next(iter(columns.values()))
        for role, columns in named.items()
        if role not in ("x", "y") or body in columns
    }


def _is_whole(columns: Mapping[str, Column]) -> bool:
    return {"x", "y"} <= columns.keys() or {"a", "b", "azimuth"} <= columns.keys()


def _by_place(
    sheet: Sheet, file: str, has_rate: bool, named: Mapping[str, Column], notes: list[Note]
) -> dict[str, Column]:
    """Times and positions by their places, where there are no names."""
    columns = sheet.columns
    if sheet.named and not (len(columns) == 3 and not named):
        raise InvalidInput.of("track_no_columns", file=file, names=_listed(sheet))
    numbers = [c for c in columns if c.texts is None and np.isfinite(c.numbers).any()]
    times = [c for c in columns if c.texts is not None]
    found: dict[str, Column] = {}
    if len(times) == 1 and len(numbers) >= 2:
        numbers = _without_index(numbers, 2)
        found = {"time": times[0], "x": numbers[0], "y": numbers[1]}
    elif len(times) == 2 and len(numbers) >= 2:
        numbers = _without_index(numbers, 2)
        found = {"date": times[0], "time": times[1], "x": numbers[0], "y": numbers[1]}
    elif len(numbers) >= 3 and not times:
        numbers = _without_index(numbers, 3)
        role = "frame" if has_rate and _counts(numbers[0]) else "time"
        found = {role: numbers[0], "x": numbers[1], "y": numbers[2]}
    elif len(numbers) == 2 and not times:
        found = {"x": numbers[0], "y": numbers[1]}
    if not _is_whole(found):
        raise InvalidInput.of("track_no_columns", file=file, names=_listed(sheet))
    places = ", ".join(f"{role} = {columns.index(c) + 1}" for role, c in found.items())
    notes.append(Note.of("columns_by_place", places=places))
    return found


def _without_index(columns: list[Column], need: int) -> list[Column]:
    """The columns but a first one that only counts the rows, where enough remain."""
    return columns[1:] if len(columns) > need and _counts(columns[0]) else columns


def _counts(column: Column) -> bool:
    values = column.numbers[np.isfinite(column.numbers)]
    return len(values) > 1 and bool((np.diff(values) == 1).mean() > 0.9)


def length_of(unit: str) -> tuple[float, str]:
    """Of one such unit in m, or of one pixel in px; (1, "") where the unit is none of a length."""
    plain = unit.strip().lower()
    if plain in PIXELS:
        return 1.0, "px"
    return (LENGTHS[plain], "m") if plain in LENGTHS else (1.0, "")


def time_of(unit: str) -> float | None:
    """Of one such unit in s; None where it is none of a time, 0 for frames."""
    plain = unit.strip().lower()
    return 0.0 if plain in FRAMES else TIMES.get(plain)


def angle_of(unit: str) -> float | None:
    """Of one such unit in rad; None where it is none of an angle."""
    return ANGLES.get(unit.strip().lower())
