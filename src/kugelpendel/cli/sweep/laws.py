"""How a number of a file varies: a list, a range, or a distribution, each with its units."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn, cast

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.entries import closest
from kugelpendel.cli.job_file.kinds import Kind
from kugelpendel.cli.job_file.quantity import read_quantity, show
from kugelpendel.sweeps import Listed, Normal, Spaced, Uniform

if TYPE_CHECKING:
    from kugelpendel.sweeps import Law

_RANGE = ("from", "to", "count", "scale")
_SCALES = ("linear", "log")


def read_law(value: list[Any] | dict[str, Any], kind: Kind | None, where: str) -> Law:
    """Read how a number varies, in the SI unit of its kind.

    Parameters
    ----------
    value
        A list, or a table of one of the forms that there are.
    kind
        What it measures; None for a number without a unit.
    where
        Its place in the file, for sentences.

    Raises
    ------
    InvalidInput
        No such form, a number in it that cannot be read, or a law that makes no sense.
    """
    law = _law(value, kind, where)
    law.check(where)
    return law


def _law(value: list[Any] | dict[str, Any], kind: Kind | None, where: str) -> Law:
    """The law of a form, whatever its numbers are."""
    if isinstance(value, list):
        return Listed(tuple(_numbers(value, kind, where)))
    if set(value) == {"normal"}:
        return Normal(*_pair(value["normal"], kind, where, "normal"))
    if set(value) == {"uniform"}:
        return Uniform(*_pair(value["uniform"], kind, where, "uniform"))
    if "from" not in value or "to" not in value:
        _refuse(value, kind, where)
    for key in value:
        if key not in _RANGE:
            meant, allowed = closest(key, _RANGE), ", ".join(_RANGE)
            raise InvalidInput.of(
                "sweep_range_key", where=where, seen=key, meant=meant, allowed=allowed
            )
    start, stop = _numbers([value["from"], value["to"]], kind, where)
    scale = value.get("scale", "linear")
    if scale not in _SCALES:
        raise InvalidInput.of("sweep_scale", where=where, seen=show(scale))
    return Spaced(start, stop, _count(value, where), scale == "log")


def example_of(kind: Kind | None) -> str:
    """A range to paste."""
    ends = ("1", "2") if kind is None else (f'"{kind.example}"',) * 2
    return f"{{ from = {ends[0]}, to = {ends[1]}, count = 20 }}"


def _numbers(values: list[Any], kind: Kind | None, where: str) -> list[float]:
    """Numbers of one kind, all of them with a unit or none."""
    if kind is None:
        for value in values:
            if not isinstance(value, (int, float)) or isinstance(value, bool):
                raise InvalidInput.of("sweep_plain", where=where, seen=show(value))
        return [float(value) for value in values]
    read = [read_quantity(value, kind, where) for value in values]
    with_unit = [value for value in values if isinstance(value, str)]
    bare = [value for value in values if not isinstance(value, str) and value != 0]
    if with_unit and bare:
        seen, other = show(with_unit[0]), show(bare[0])
        raise InvalidInput.of("sweep_mixed_units", where=where, seen=seen, other=other)
    return read


def _pair(value: object, kind: Kind | None, where: str, word: str) -> tuple[float, float]:
    numbers = cast("list[Any]", value) if isinstance(value, list) else []
    if len(numbers) != 2:
        example = "1" if kind is None else f'"{kind.example}"'
        seen = show(cast("Any", value))
        raise InvalidInput.of(f"sweep_{word}", where=where, seen=seen, example=example)
    first, second = _numbers(numbers, kind, where)
    return first, second


def _count(value: dict[str, Any], where: str) -> int | None:
    count = value.get("count")
    if count is None:
        return None
    if isinstance(count, float) and count.is_integer():
        count = int(count)
    if not isinstance(count, int) or isinstance(count, bool) or count < 1:
        raise InvalidInput.of("sweep_range_whole", where=where, seen=show(count))
    return count


def _refuse(value: dict[str, Any], kind: Kind | None, where: str) -> NoReturn:
    seen = ", ".join(value) or "{ }"
    raise InvalidInput.of("sweep_no_law", where=where, seen=seen, example=example_of(kind))
