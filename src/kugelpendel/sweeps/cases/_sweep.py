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
from kugelpendel.parameters import (
    Numbers,
    Scalars,
    as_array,
    one_number,
    one_truth,
    wrong_type,
)
from kugelpendel.sweeps.cases._checks import (
    MOST_CASES,
    check_design,
    check_quantities,
    check_tables,
    check_words,
    is_whole,
    too_many,
    where,
)
from kugelpendel.sweeps.cases._cost import LEAF
from kugelpendel.sweeps.cases._indexed import (
    grid_cases,
    grid_stretch,
    sample_cases,
    sample_stretch,
    sobol_cases,
)
from kugelpendel.sweeps.cases._laws import LAWS, Law, stored_law
from kugelpendel.sweeps.cases._pendulums import UNITS, WORDS, Table, assembled

DesignWord: TypeAlias = Literal["grid", "sample", "sobol"]
MotionWord: TypeAlias = Literal["exact", "averaged", "real"]
Kept: TypeAlias = Literal["all", "moments", "quantiles", "histograms"]
Entry: TypeAlias = float | str | bool | Law


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
        tables = _tables(self.given)
        settled = {
            "_tables": tables,
            "quantities": _words(self.quantities, "quantities"),
            "times": tuple(as_array(cast("Any", self.times), "times", "s").ravel().tolist()),
            "second_order": one_truth(self.second_order, "second_order"),
            "keep": _words(self.keep, "keep"),
        }
        for name, value in settled.items():
            object.__setattr__(self, name, value)
        check_words(self, get_args(DesignWord), get_args(MotionWord), get_args(Kept))
        check_tables(tables, self.motion)
        check_design(self)
        check_quantities(self)
        if self.size > MOST_CASES:
            raise too_many(self)
        # What does not vary has to make sense; what varies is judged case by case.
        assembled(self.tables(0, 1))
        chunk, least = self.chunk, 1 if self.keeps_all else LEAF
        if chunk is not None and not (is_whole(chunk, least) and chunk & (chunk - 1) == 0):
            raise InvalidInput.of("sweep_chunk", seen=f"{chunk!r:.60}", least=least)

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
        laws = list(self.varied.values())
        if self.design == "grid" and stop > start:
            return dict(zip(self.names, grid_stretch(laws, start, stop), strict=True))
        if self.design == "sample":
            return dict(zip(self.names, sample_stretch(self, laws, start, stop), strict=True))
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


def _tables(given: object) -> dict[str, dict[str, Entry]]:
    """The tables of a job file, each entry checked."""
    way_out = 'write {"pendulum": {"length": 1.0}, "launch": {"kind": "ellipse", …}}'
    if not isinstance(given, Mapping):
        raise wrong_type("given", given, "dict of the tables of a job file", way_out)
    found: dict[str, dict[str, Entry]] = {}
    for section, table in cast("Mapping[Any, Any]", given).items():
        if not isinstance(table, Mapping):
            raise wrong_type(f"[{section}]", table, "dict of the keys of that table", way_out)
        entries = cast("Mapping[Any, Any]", table).items()
        found[str(section)] = {str(key): _entry(str(section), str(key), v) for key, v in entries}
    return found


def _words(words: object, what: str) -> tuple[str, ...]:
    """One word, or several."""
    if isinstance(words, str):
        return (words,)
    several = cast("Sequence[Any]", words) if isinstance(words, (list, tuple)) else (None,)
    if all(isinstance(word, str) for word in several):
        return tuple(several)
    raise wrong_type(
        what, cast("object", words), "word or a list of words", f"leave {what} out, or write ['…']"
    )


def _entry(section: str, key: str, value: object) -> Entry:
    """A number in SI, a word or a law, under a key that there is."""
    name = f"{section}.{key}"
    if name in WORDS:
        if not isinstance(value, (str, bool)) or value not in WORDS[name]:
            known = ", ".join(map(repr, WORDS[name]))
            raise InvalidInput.of(
                "sweep_word", what=where(name), seen=f"{value!r:.60}", known=known
            )
        return value
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
