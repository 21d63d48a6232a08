"""What a sweep is: what varies and how, which motion, what is read and what is kept."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import isfinite, prod
from typing import Any, Literal, TypeAlias, cast, get_args

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Launch, Numbers, Scalars, one_number
from kugelpendel.sweeps.cases._cost import LEAF
from kugelpendel.sweeps.cases._indexed import grid_cases, grid_stretch, sample_cases, sobol_cases
from kugelpendel.sweeps.cases._laws import LAWS, Law, Normal, Spaced, Uniform, stored_law
from kugelpendel.sweeps.cases._pendulums import UNITS, WORDS, Table, assembled

DesignWord: TypeAlias = Literal["grid", "sample", "sobol"]
MotionWord: TypeAlias = Literal["exact", "averaged", "real"]
Kept: TypeAlias = Literal["all", "moments", "quantiles", "histograms"]
Entry: TypeAlias = float | str | bool | Law

MOST_CASES = 100_000_000_000
"""More are refused: as many full runs would take a thousand cores two years."""

_MAY_LACK = ("azimuth", "phi", "theta_rate", "phi_rate")
"""Numbers of a launch that are 0 unless they are given."""

MOST_BASE_POINTS = 2**30
"""Of a Sobol sequence of 30 bits, as SciPy makes it."""


@dataclass(frozen=True, eq=False)
class Sweep:
    """Many pendulums from one description, each of which can be made from its index alone.

    Parameters
    ----------
    given
        The tables of a job file but for ``[output]``, in SI: numbers, words, and a law for what
        varies: `Listed`, `Spaced`, `Normal` or `Uniform`. Position and velocity of a launch of kind
        "state" are given as x, y, z, vx, vy, vz.
    design
        "grid": all combinations of lists and ranges, the last of them changing fastest; "sample":
        independent draws; "sobol": Saltelli's design for Sobol indices, in the order that
        ``SALib.analyze.sobol`` takes.
    motion
        "exact" (`ExactMotion`; of the forces only a bob), "averaged" (`EnvelopeMotion`) or "real"
        (`RealMotion`).
    quantities
        What is read of each case, by the names of `QUANTITIES`.
    times
        s, when what changes is read; ascending.
    count
        Cases of a sample; base points of a Sobol design, a power of two. A grid counts itself.
    seed
        Of draws and of the scrambling of Sobol's sequence.
    second_order
        Whether a Sobol design tells pairs too: 2d + 2 cases for a base point and d numbers that
        vary, and d + 2 without.
    keep
        "all", or any of "moments", "quantiles" and "histograms" of all good cases, which need no
        more than some kilobytes for each chunk.
    chunk
        Cases that are done and stored together, a power of two, where a new store is made; by
        default about a second of work for one core, from a trial. It changes no result and is no
        part of what is described: a store keeps its own.

    Raises
    ------
    InvalidInput
        For what makes no sense, each with its sentence: an unknown key, an empty range, a
        distribution on a grid, nothing that varies, too many cases.

    Notes
    -----
    A single case is made again by `case`, the same to the last bit as among all others. Draws are
    those of Philox 4×64 (Salmon et al., SC11, 2011) with the index as its counter; the design for
    Sobol indices is that of Saltelli, Comput. Phys. Commun. 145, 280 (2002), on a scrambled Sobol
    sequence that is entered at the index.
    """

    given: Mapping[str, Mapping[str, Any]]
    design: DesignWord
    motion: MotionWord
    quantities: Sequence[str]
    times: Sequence[float] = ()
    count: int | None = None
    seed: int = 0
    second_order: bool = True
    keep: Sequence[Kept] = ("all",)
    chunk: int | None = None
    _tables: dict[str, dict[str, Entry]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        tables = {
            section: {key: _entry(section, key, value) for key, value in table.items()}
            for section, table in self.given.items()
        }
        settled = {
            "_tables": tables,
            "quantities": _words(self.quantities),
            "times": tuple(one_number(t, "A time", "s") for t in self.times),
            "keep": _words(self.keep),
        }
        for name, value in settled.items():
            object.__setattr__(self, name, value)
        _check_words(self)
        _check_tables(tables, self.motion)
        _check_design(self)
        _check_quantities(self)
        if self.size > MOST_CASES:
            raise _too_many(self)
        # What does not vary has to make sense; what varies is judged case by case.
        assembled(self.tables(0, 1))
        chunk, least = self.chunk, 1 if self.keeps_all else LEAF
        if chunk is not None and not (_is_whole(chunk, least) and chunk & (chunk - 1) == 0):
            raise InvalidInput.of("sweep_chunk", seen=repr(chunk), least=least)

    @cached_property
    def varied(self) -> dict[str, Law]:
        """What varies, by its dotted name such as "suspension.anisotropy", in the order given."""
        return {
            f"{section}.{key}": value
            for section, table in self._tables.items()
            for key, value in table.items()
            if isinstance(value, LAWS)
        }

    @property
    def names(self) -> tuple[str, ...]:
        """The dotted names of what varies."""
        return tuple(self.varied)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the cases: the levels of a grid, or one axis."""
        if self.design == "grid":
            return tuple(cast("int", law.levels) for law in self.varied.values())
        return (self.size,)

    @cached_property
    def size(self) -> int:
        """How many cases there are."""
        if self.design == "grid":
            return prod(cast("int", law.levels) for law in self.varied.values())
        return cast("int", self.count) * (self.block if self.design == "sobol" else 1)

    @property
    def block(self) -> int:
        """Cases for each base point of a Sobol design."""
        return (2 if self.second_order else 1) * len(self.varied) + 2

    @property
    def keeps_all(self) -> bool:
        """Whether the values of every case are kept."""
        return "all" in self.keep

    @staticmethod
    def unit(name: str) -> str:
        """The SI unit of a number by its dotted name."""
        section, _, key = name.partition(".")
        return UNITS[section][key]

    def values(self, start: int, stop: int) -> dict[str, Numbers]:
        """What varies, for the cases from start to stop − 1: SI, shape (stop − start,) each."""
        if self.design == "grid" and stop > start:
            stretch = grid_stretch(list(self.varied.values()), start, stop)
            return dict(zip(self.names, stretch, strict=True))
        return self.values_at(np.arange(start, stop, dtype=np.int64))

    def values_at(self, index: Any) -> dict[str, Numbers]:
        """What varies, for the cases of these indices, in any order: SI, shape of the indices."""
        laws = list(self.varied.values())
        flat = np.asarray(index, dtype=np.int64)
        make = {"grid": grid_cases, "sample": sample_cases, "sobol": sobol_cases}[self.design]
        return dict(zip(self.names, make(self, laws, flat), strict=True))

    def case(self, index: int) -> dict[str, dict[str, float | str | bool]]:
        """All that one case is given: the tables of a job file, in SI."""
        if not 0 <= index < self.size:
            raise InvalidInput.of("sweep_index", index=index, size=self.size)
        found = self.values(index, index + 1)
        return {
            section: {
                key: float(found[f"{section}.{key}"][0])
                if f"{section}.{key}" in found
                else cast("float | str | bool", value)
                for key, value in table.items()
            }
            for section, table in self._tables.items()
        }

    def tables(self, start: int, stop: int) -> dict[str, Table]:
        """The tables of a job file for the cases from start to stop − 1: numbers, or arrays."""
        found = self.values(start, stop)
        return {
            section: {
                key: cast("Scalars | str | bool", found.get(f"{section}.{key}", value))
                for key, value in table.items()
            }
            for section, table in self._tables.items()
        }

    def as_json(self) -> str:
        """All of it as JSON, the same for sweeps that are equal."""
        return json.dumps(self._plain(), ensure_ascii=False, allow_nan=False)

    @classmethod
    def from_json(cls, text: str) -> Sweep:
        """The sweep that `as_json` has written."""
        stored = json.loads(text)
        given: dict[str, dict[str, Any]] = {}
        for name, value in (*stored["varied"], *stored["fixed"]):
            section, _, key = name.partition(".")
            given.setdefault(section, {})[key] = (
                stored_law(*cast("list[Any]", value)) if isinstance(value, list) else value
            )
        rest = ("design", "motion", "quantities", "times", "count", "seed", "second_order")
        return cls(given, **{key: stored[key] for key in (*rest, "keep")})

    @cached_property
    def digest(self) -> str:
        """A fingerprint of all of it, 32 hexadecimal digits."""
        return hashlib.blake2b(self.as_json().encode(), digest_size=16).hexdigest()

    def _plain(self) -> dict[str, Any]:
        fixed = [
            (f"{section}.{key}", value)
            for section, table in self._tables.items()
            for key, value in table.items()
            if not isinstance(value, LAWS)
        ]
        return {
            "varied": [[name, [law.word, law.plain()]] for name, law in self.varied.items()],
            "fixed": [list(entry) for entry in sorted(fixed)],
            "design": self.design,
            "motion": self.motion,
            "quantities": list(self.quantities),
            "times": list(self.times),
            "count": self.count,
            "seed": self.seed,
            "second_order": self.second_order,
            "keep": list(self.keep),
        }

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sweep) and self.as_json() == other.as_json()

    def __hash__(self) -> int:
        return hash(self.digest)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (self.as_json(), self.chunk))


def _again(text: str, chunk: int | None) -> Sweep:
    """A sweep out of a pickle."""
    return replace(Sweep.from_json(text), chunk=chunk)


def where(name: str) -> str:
    """A number as a job file has it: ``[launch] a`` for "launch.a"."""
    section, _, key = name.partition(".")
    return f"[{section}] {key}"


def _words(words: Any) -> tuple[str, ...]:
    return (words,) if isinstance(words, str) else tuple(str(word) for word in words)


def _is_whole(value: object, least: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= least


def _entry(section: str, key: str, value: object) -> Entry:
    """A number in SI, a word or a law, under a key that there is."""
    name = f"{section}.{key}"
    if name in WORDS:
        if value not in WORDS[name]:
            known = ", ".join(map(repr, WORDS[name]))
            raise InvalidInput.of("sweep_word", what=where(name), seen=repr(value), known=known)
        return cast("str | bool", value)
    if section not in UNITS or key not in UNITS[section]:
        known = ", ".join(UNITS) if section not in UNITS else ", ".join(UNITS[section])
        raise InvalidInput.of("sweep_key", name=where(name), known=known)
    if isinstance(value, LAWS):
        value.check(where(name))
        return value
    number = one_number(cast("float", value), name, UNITS[section][key])
    if not isfinite(number):
        raise InvalidInput.of("sweep_not_finite", name=where(name), number=number)
    return number


def _check_words(sweep: Sweep) -> None:
    known = {"design": get_args(DesignWord), "motion": get_args(MotionWord)}
    for what, words in known.items():
        if (seen := getattr(sweep, what)) not in words:
            raise InvalidInput.of(
                "sweep_word", what=what, seen=repr(seen), known=", ".join(map(repr, words))
            )
    kept = get_args(Kept)
    keep = tuple(sweep.keep)
    if not keep or not set(keep) <= set(kept) or ("all" in keep and len(keep) > 1):
        raise InvalidInput.of("sweep_keep", seen=", ".join(keep), known=", ".join(kept[1:]))
    if not _is_whole(sweep.seed, 0):
        raise InvalidInput.of("sweep_whole", name="seed", least=0, seen=repr(sweep.seed))


def _check_tables(tables: Mapping[str, Mapping[str, Entry]], motion: str) -> None:
    needed = {"pendulum": ("length",), "launch": ("kind",)}
    for section, keys in needed.items():
        for key in keys:
            if key not in tables.get(section, {}):
                raise InvalidInput.of("sweep_missing", name=where(f"{section}.{key}"))
    kind = str(tables["launch"]["kind"])
    for key in Launch.kinds[kind]:
        if key not in tables["launch"] and key not in _MAY_LACK:
            raise InvalidInput.of("sweep_missing", name=where(f"launch.{key}"))
    for key in tables["launch"]:
        if key != "kind" and key not in Launch.kinds[kind]:
            raise InvalidInput.of(
                "sweep_key", name=where(f"launch.{key}"), known=", ".join(Launch.kinds[kind])
            )
    acting = [section for section in tables if section not in ("pendulum", "launch", "bob")]
    if motion == "exact" and acting:
        raise InvalidInput.of("sweep_forces", seen=", ".join(acting))


def _check_design(sweep: Sweep) -> None:
    if not sweep.varied:
        raise InvalidInput.of("sweep_nothing_varies", design=sweep.design)
    for name, law in sweep.varied.items():
        if sweep.design == "grid" and isinstance(law, (Normal, Uniform)):
            raise InvalidInput.of("sweep_no_levels", name=where(name), law=law.word)
        if isinstance(law, Spaced) and (law.count is None) == (sweep.design == "grid"):
            kind = "sweep_range_count" if sweep.design == "grid" else "sweep_range_counts"
            raise InvalidInput.of(kind, name=where(name))
    if sweep.design == "grid":
        if sweep.count is not None:
            raise InvalidInput.of("sweep_count_of_grid", count=sweep.count)
        return
    if not _is_whole(sweep.count, 1):
        raise InvalidInput.of("sweep_whole", name="count", least=1, seen=repr(sweep.count))
    points = cast("int", sweep.count)
    if sweep.design == "sobol" and (points & (points - 1) or points > MOST_BASE_POINTS):
        raise InvalidInput.of(
            "sweep_power_of_two",
            count=points,
            below=1 << max(min(points, MOST_BASE_POINTS).bit_length() - 1, 0),
        )


def _check_quantities(sweep: Sweep) -> None:
    from kugelpendel.sweeps._quantities import QUANTITIES, require_readable

    names = sweep.quantities
    if not names or len(set(names)) < len(names):
        raise InvalidInput.of(
            "sweep_quantities", seen=", ".join(names), known=", ".join(QUANTITIES)
        )
    times = np.asarray(sweep.times, dtype=np.float64)
    require_readable(sweep.motion, names, times, grounded="site" in sweep.given)


def _too_many(sweep: Sweep) -> InvalidInput:
    from kugelpendel.sweeps.cases._cost import bytes_kept, core_seconds

    return InvalidInput.of(
        "sweep_too_many",
        count=float(sweep.size),
        most=float(MOST_CASES),
        time=(core_seconds(sweep) * sweep.size / 3600, "h"),
        size=(bytes_kept(sweep) / 1e9, "GB"),
    )
