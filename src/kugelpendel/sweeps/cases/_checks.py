"""What makes no sense in a sweep, each with its sentence."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, cast

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Launch
from kugelpendel.sweeps.cases._laws import Normal, Spaced, Uniform

if TYPE_CHECKING:
    from kugelpendel.sweeps.cases._sweep import Sweep

MOST_CASES = 100_000_000_000
"""More are refused: as many full runs would take a thousand cores two years."""

MOST_BASE_POINTS = 2**30
"""Of a Sobol sequence of 30 bits, as SciPy makes it."""

_MAY_LACK = ("azimuth", "phi", "theta_rate", "phi_rate")
"""Numbers of a launch that are 0 unless they are given."""


def where(name: str) -> str:
    """A number as a job file has it: ``[launch] a`` for "launch.a"."""
    section, _, key = name.partition(".")
    return f"[{section}] {key}"


def is_whole(value: object, least: int) -> bool:
    """Whether something is a whole number of at least this size."""
    return isinstance(value, int) and not isinstance(value, bool) and value >= least


def check_words(
    sweep: Sweep, designs: tuple[str, ...], motions: tuple[str, ...], kept: tuple[str, ...]
) -> None:
    """Refuse words of design, motion and what is kept that are not known, and an odd seed."""
    known = {"design": designs, "motion": motions}
    for what, words in known.items():
        seen = getattr(sweep, what)
        if not isinstance(seen, str) or seen not in words:
            raise InvalidInput.of(
                "sweep_word", what=what, seen=f"{seen!r:.60}", known=", ".join(map(repr, words))
            )
    keep = tuple(sweep.keep)
    if not keep or not set(keep) <= set(kept) or ("all" in keep and len(keep) > 1):
        raise InvalidInput.of("sweep_keep", seen=", ".join(keep), known=", ".join(kept[1:]))
    if not is_whole(sweep.seed, 0):
        raise InvalidInput.of("sweep_whole", name="seed", least=0, seen=f"{sweep.seed!r:.60}")


def check_tables(tables: Mapping[str, Mapping[str, object]], motion: str) -> None:
    """Refuse what lacks a number, has one of another launch, or acts on an exact motion."""
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


def check_design(sweep: Sweep) -> None:
    """Refuse laws and counts that do not go with the design."""
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
            raise InvalidInput.of("sweep_count_of_grid", count=f"{sweep.count!r:.60}")
        return
    if not is_whole(sweep.count, 1):
        raise InvalidInput.of("sweep_whole", name="count", least=1, seen=f"{sweep.count!r:.60}")
    points = cast("int", sweep.count)
    if sweep.design == "sobol" and (points & (points - 1) or points > MOST_BASE_POINTS):
        raise InvalidInput.of(
            "sweep_power_of_two",
            count=points,
            below=1 << max(min(points, MOST_BASE_POINTS).bit_length() - 1, 0),
        )


def check_quantities(sweep: Sweep) -> None:
    """Refuse quantities that cannot be read, or not without times."""
    from kugelpendel.sweeps._quantities import QUANTITIES, require_readable

    names = sweep.quantities
    if not names or len(set(names)) < len(names):
        raise InvalidInput.of(
            "sweep_quantities", seen=", ".join(names), known=", ".join(QUANTITIES)
        )
    times = np.asarray(sweep.times, dtype=np.float64)
    require_readable(sweep.motion, names, times, grounded="site" in sweep.given)


def too_many(sweep: Sweep) -> InvalidInput:
    """What to raise for more cases than are done, with the time and bytes that they take."""
    from kugelpendel.sweeps.cases._cost import bytes_kept, core_seconds

    return InvalidInput.of(
        "sweep_too_many",
        count=float(sweep.size),
        most=float(MOST_CASES),
        time=(core_seconds(sweep) * sweep.size / 3600, "h"),
        size=(bytes_kept(sweep) / 1e9, "GB"),
    )
