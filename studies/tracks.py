"""How often the intervals of a fitted track hold, and how near they are to the bound.

python -m studies.tracks [--count N] [--write FILE]: writes its tables between two marks of FILE.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "RAYON_NUM_THREADS"):
    os.environ.setdefault(_name, "1")  # small solves: threads cost up to ten times as much

import numpy as np  # noqa: E402

import kugelpendel as kp  # noqa: E402
from studies.pendulums import DURATION, JITTER, NAMES, RATE, bounds, level, pendulum, shape  # noqa: E402

BEGIN, END = "<!-- study: begin -->", "<!-- study: end -->"
FIRST_SEED = 1000
KINDS: dict[str, dict[str, Any]] = {
    "white": {},
    "AR(0.8)": {"colour": 0.8},
    "slow drift": {"colour": "slow"},
    "2 % outliers": {"outliers": 0.02},
}
LABELS = {
    "a": "a", "b": "b", "azimuth": "ψ", "rotation": "Ω_z", "linear": "γ", "quadratic": "c",
    "anisotropy_cos": "δ cos 2χ", "anisotropy_sin": "δ sin 2χ",
}  # fmt: skip


@dataclass
class Tally:
    """What came of many tracks, one row each; columns as `NAMES`."""

    held: list[list[bool]] = field(default_factory=list)
    pulls: list[list[float]] = field(default_factory=list)
    of_bound: list[list[float]] = field(default_factory=list)
    spectrum: list[float] = field(default_factory=list)
    ratio: list[float] = field(default_factory=list)
    widths: list[float] = field(default_factory=list)
    failed: int = 0

    @property
    def coverage(self) -> np.ndarray:
        """Share of the 95 % intervals that hold the truth."""
        return np.mean(self.held, axis=0)

    @property
    def efficiency(self) -> np.ndarray:
        """Root mean square error over the Cramér–Rao bound."""
        return np.sqrt(np.nanmean(np.square(self.of_bound), axis=0))


def one(
    tally: Tally,
    seed: int,
    spoilt: dict[str, Any],
    *,
    model: str = "narrow",
    uneven: float = 0.0,
    swings: float = 8.0,
    rate: float = RATE,
    tolerance: float = 1e-17,
    along: float | None = None,
    white_errors: bool = False,
) -> None:
    """Add one track to a tally."""
    case = pendulum(seed, damping_anisotropy=uneven, tolerance=tolerance)
    motion = case.motion
    if along is not None:
        launch = kp.Launch.ellipse(*np.asarray(motion.launch.values[:2], float), along)
        motion = kp.RealMotion(motion.pendulum, launch, motion.forces)
        case = type(case)(motion, case.truth, case.noise, case.gravity)
    noise = spoilt.get("noise", case.noise)
    given = {"noise": noise, "jitter": JITTER, "seed": seed} | spoilt
    track = kp.tracks.synthesise(motion, DURATION, rate, **given)
    ellipses = kp.tracks.ellipses(track, swings=swings)
    if white_errors:
        ellipses = _as_if_white(ellipses)
    fit = kp.tracks.fit(ellipses, gravity=case.gravity, models=(model,))
    truth = shape(case, fit.time) | case.truth
    fitted = fit.models[model]
    # A fit widens where there is a misfit; what white errors alone would say is narrower.
    narrower = np.sqrt(fit.misfit.ratio) if white_errors and fit.misfit.is_misfit else 1.0
    tally.failed += fitted.failed
    errors, stderrs, held = [], [], []
    for name in NAMES:
        estimate = fitted.parameters[name]
        apart = estimate.value - truth[name]
        if name == "azimuth":
            apart = (apart + np.pi / 2) % np.pi - np.pi / 2
        t = (estimate.high - estimate.low) / (2 * estimate.stderr)
        # What does not close has no number, and its interval is everything.
        held.append(not abs(apart) > t * estimate.stderr / narrower)
        errors.append(apart)
        stderrs.append(estimate.stderr)
    tally.held.append(held)
    tally.pulls.append(list(np.divide(errors, stderrs)))
    tally.ratio.append(fit.misfit.ratio)
    rotation = fitted.parameters["rotation"]
    tally.widths.append((rotation.high - rotation.low) / 2)
    if noise and model == "narrow":
        spectrum = level(given.get("colour", "white"), noise, fit.frequency, rate)
        bound = bounds(ellipses, truth, spectrum)
        tally.of_bound.append([e / bound[name] for e, name in zip(errors, NAMES, strict=True)])
        seen = np.sqrt(ellipses.attrs["noise_ahead"] * ellipses.attrs["noise_behind"])
        tally.spectrum.append(float(seen / spectrum))


def _as_if_white(ellipses: Any) -> Any:
    """Errors from the scatter of the points, as if their noise were white."""
    changed = ellipses.copy(deep=True)
    seen = 2 * ellipses.attrs["noise"] ** 2
    mean = 0.5 * (ellipses.attrs["noise_ahead"] + ellipses.attrs["noise_behind"])
    changed["covariance"].values[:] *= seen / mean
    return changed


def many(
    count: int,
    spoilt: dict[str, Any] | Callable[[int], dict[str, Any]],
    *,
    first: int = FIRST_SEED,
    **options: Any,
) -> Tally:
    """A tally of so many fixed seeds from the first on; what spoils may depend on the seed."""
    tally = Tally()
    start = time.perf_counter()
    for index in range(count):
        seed = first + index
        one(tally, seed, spoilt(seed) if callable(spoilt) else spoilt, **options)
        if sys.stderr.isatty() and index % 10 == 9:
            left = (time.perf_counter() - start) / (index + 1) * (count - index - 1)
            print(f"\r{index + 1} of {count}, {left:.0f} s left ", end="", file=sys.stderr)
    return tally


def gaps(seed: int) -> dict[str, Any]:
    """Three gaps of 5 to 90 s."""
    random = np.random.default_rng([7, seed])
    begins, lengths = random.uniform(50, DURATION - 150, 3), random.uniform(5, 90, 3)
    return {"gaps": list(zip(begins.tolist(), lengths.tolist(), strict=True))}


def tilted(seed: int) -> dict[str, Any]:
    """2 % of tilt along a random axis."""
    return {"tilt": 0.02, "tilt_axis": float(np.random.default_rng([8, seed]).uniform(0, np.pi))}


def table(head: list[str], rows: list[list[str]]) -> str:
    """A table in Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def percent(tally: Tally) -> list[str]:
    return [f"{100 * share:.1f}" for share in tally.coverage]


def coverage(count: int) -> str:
    rows = []
    for name, spoilt in KINDS.items():
        tally = many(count, spoilt)
        seen = f"{np.mean(tally.spectrum):.2f} ± {np.std(tally.spectrum):.2f}"
        rows.append([f"{name}, %", *percent(tally), seen, str(tally.failed)])
        rows.append(["RMS/bound", *(f"{x:.2f}" for x in tally.efficiency), "", ""])
    white = many(max(count // 4, 20), KINDS["AR(0.8)"], white_errors=True)
    rows.append(["AR(0.8), errors as if white, %", *percent(white), "", str(white.failed)])
    head = ["noise", *LABELS.values(), "S/S true", "failed"]
    return f"{count} pendulums each (a quarter in the last row):\n\n{table(head, rows)}"


def harder(count: int) -> str:
    rows = []
    kinds: dict[str, tuple[Any, dict[str, Any]]] = {
        "three gaps of 5 to 90 s": (gaps, {}),
        "three gaps, slow drift": (lambda seed: {**gaps(seed), "colour": "slow"}, {}),
        "noise of t₃": ({"colour": "t3"}, {}),
        "x : y noise 3 : 1, swing along x": ({"noise_ratio": 3.0}, {"along": 0.0}),
        "x : y noise 3 : 1, swing along y": ({"noise_ratio": 3.0}, {"along": np.pi / 2}),
    }
    for size in (4.0, 8.0, 16.0):
        kinds[f"windows of {size:.0f} swings"] = ({}, {"swings": size})
    for name, (spoilt, options) in kinds.items():
        tally = many(count, spoilt, **options)
        rms = np.sqrt(np.nanmean(np.square(tally.pulls), axis=0))
        spread = f"{rms.min():.2f} … {rms.max():.2f}"
        rows.append([name, *percent(tally), spread, str(tally.failed)])
    head = ["track", *LABELS.values(), "rms pulls", "failed"]
    return f"{count} pendulums each, coverage in %:\n\n{table(head, rows)}"


def bias(count: int) -> str:
    found = biases(count)
    rows = [
        ["rms", *(f"{x:.3f}" for x in np.sqrt(np.mean(found**2, axis=0)))],
        ["largest", *(f"{x:.3f}" for x in np.abs(found).max(axis=0))],
    ]
    text = f"Errors without noise, as shares of the bound with noise of 0.5 % ({count} pendulums):"
    return f"{text}\n\n{table(['', *LABELS.values()], rows)}"


def biases(count: int) -> np.ndarray:
    """Errors of tracks without noise over the bounds that noise of 0.5 % sets."""
    out = []
    for index in range(count):
        seed = FIRST_SEED + index
        case = pendulum(seed)
        track = kp.tracks.synthesise(case.motion, DURATION, RATE, jitter=JITTER, seed=seed)
        ellipses = kp.tracks.ellipses(track)
        fit = kp.tracks.fit(ellipses, gravity=case.gravity, models=("narrow",))
        truth = shape(case, fit.time) | case.truth
        bound = bounds(ellipses, truth, level("white", case.noise, fit.frequency))
        errors = {name: fit.narrow.parameters[name].value - truth[name] for name in NAMES}
        errors["azimuth"] = (errors["azimuth"] + np.pi / 2) % np.pi - np.pi / 2
        out.append([errors[name] / bound[name] for name in NAMES])
    return np.array(out)


def misspecified(count: int) -> str:
    rows = []
    wrong: dict[str, tuple[Any, dict[str, Any]]] = {
        "Δγ up to 0.1 γ": ({}, {"uneven": 0.1}),
        "2 % of tilt": (tilted, {}),
    }
    for name, (spoilt, options) in wrong.items():
        for model in ("narrow", "uneven", "headline"):
            tally = many(count, spoilt, model=model, **options)
            width = np.degrees(np.nanmedian(tally.widths)) * 3600
            lost = f"{100 * np.mean(~np.isfinite(tally.widths)):.0f}"
            ratio = f"{np.median(tally.ratio):.2f}"
            wide = f"{width:.2f}" if np.isfinite(width) else "–"
            rows.append([name, model, *percent(tally), wide, lost, ratio])
    head = [
        "present",
        "model",
        *LABELS.values(),
        "half width of Ω_z, °/h",
        "not determined, %",
        "χ²/ndof",
    ]
    return f"{count} pendulums each, coverage in %, medians:\n\n{table(head, rows)}"


def main() -> int:
    parser = argparse.ArgumentParser(description="How often the intervals of a track hold.")
    parser.add_argument("--count", type=int, default=1000, help="pendulums for each kind of noise")
    parser.add_argument("--write", type=Path, help="a file with the marks to write between")
    options = parser.parse_args()
    some = max(options.count // 6, 10)
    parts = {
        "Coverage": lambda: coverage(options.count),
        "Harder tracks": lambda: harder(some),
        "Bias": lambda: bias(max(options.count // 16, 10)),
        "Models that are wrong": lambda: misspecified(some),
    }
    texts = []
    for name, part in parts.items():
        texts.append(f"### {name}\n\n{part()}")
        print(f"\n{texts[-1]}", flush=True)
    if options.write:
        before, rest = options.write.read_text(encoding="utf-8").split(BEGIN)
        after = rest.split(END)[1]
        body = "\n\n".join(texts)
        options.write.write_text(f"{before}{BEGIN}\n\n{body}\n\n{END}{after}", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
