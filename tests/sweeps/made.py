"""Small sweeps, and what a store of them holds."""

from pathlib import Path
from typing import Any

import numpy as np
import zarr

import kugelpendel as kp
from kugelpendel.sweeps import Spaced


def averaged(**options: Any) -> kp.Sweep:
    """A grid of clamps, some milliseconds a chunk."""
    given: dict[str, Any] = {
        "pendulum": {"length": 2.0},
        "launch": {"kind": "ellipse", "a": Spaced(0.05, 0.2, 10), "b": 0.0},
        "site": {"latitude": 0.8},
        "suspension": {"anisotropy": Spaced(1e-7, 1e-4, 24, log=True), "axis": 0.3},
    }
    usual: dict[str, Any] = {
        "design": "grid",
        "motion": "averaged",
        "quantities": ("azimuth", "b"),
        "times": (600.0, 3600.0),
        "chunk": 8,
    }
    return kp.Sweep(given, **{**usual, **options})


def exact(count: int = 1000, **options: Any) -> kp.Sweep:
    """Random ellipses."""
    given: dict[str, Any] = {
        "pendulum": {"length": 1.0},
        "launch": {
            "kind": "ellipse",
            "a": kp.sweeps.Uniform(0.01, 0.5),
            "b": kp.sweeps.Normal(0.0, 0.02),
        },
    }
    usual: dict[str, Any] = {
        "design": "sample",
        "motion": "exact",
        "quantities": ("precession",),
        "count": count,
        "seed": 3,
    }
    return kp.Sweep(given, **{**usual, **options})


def contents(folder: Path) -> dict[str, np.ndarray[Any, Any]]:
    """All arrays of a store, as they are."""
    group: Any = zarr.open_group(store=str(folder / "sweep.zarr"), mode="r")
    return {name: np.asarray(group[name][...]) for name in sorted(group.array_keys())}
