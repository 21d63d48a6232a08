"""``kugelpendel fit``: from a recorded track to ellipses, a model and a report."""

from __future__ import annotations

import math
from contextlib import contextmanager
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli.fit import as_json
from kugelpendel.cli.fit.asked import Asked, quantity, read_options
from kugelpendel.cli.fit.page import page
from kugelpendel.cli.fit.report import Findings, FitReport, make_report
from kugelpendel.cli.fit.terminal import report_text
from kugelpendel.cli.fit.words import words
from kugelpendel.cli.job_file.kinds import TIME
from kugelpendel.cli.output import staged
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import write_json

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Generator

    import xarray as xr

    from kugelpendel.errors import Language
    from kugelpendel.tracks import Profile

RESULTS = "fit.json"
ELLIPSES = "ellipses.nc"
PAGE = "report.html"
FIGURES = ("seen", "course", "spectrum", "profile", "correlations")
FILES = (*(f"{name}.png" for name in FIGURES), ELLIPSES, PAGE, RESULTS)

_STAGES = 100

_TOO_LITTLE = ("fit_windows", "fit_table_length")
"""What leaves the ellipses as they are, but tells too little for a model."""


def fit(options: argparse.Namespace) -> int:
    """Do what the options ask: fit a track, follow a file, or plan a recording.

    Raises
    ------
    InvalidInput
        Anything wrong with the options, the file or the folder. Nothing is left half-written.
    """
    asked = read_options(options)
    if options.plan:
        from kugelpendel.cli.fit.plan import plan

        return plan(options, asked)
    if options.track is None:
        raise kp.InvalidInput.of("option_no_track")
    if options.follow:
        from kugelpendel.cli.fit.follow import follow

        idle = quantity(options, "idle", TIME)
        return follow(options.track, asked, options.out, math.inf if idle is None else idle)
    _fit_track(options.track, asked, options.out, as_json_only=options.json)
    return 0


def _fit_track(file: Path, asked: Asked, folder: Path | None, *, as_json_only: bool) -> None:
    target = folder if folder is not None else Path("out") / file.stem
    title = words(asked.language)["fitting"]
    with (
        Progress(title, _STAGES, language=asked.language) as progress,
        staged(target, FILES) as temporary,
    ):
        parts = _parts(progress)
        found, profile = _found(file, asked, parts)
        results = as_json.as_json(found)
        report = make_report(found, asked.language)
        with parts["drawn"].counted() as advance:
            figures = _drawn(found, profile, asked.language, advance)
        for name, figure in figures.items():
            (temporary / f"{name}.png").write_bytes(figure)
        (temporary / PAGE).write_text(page(report, figures), encoding="utf-8")
        _write_netcdf(found.ellipses, temporary / ELLIPSES)
        (temporary / RESULTS).write_text(results, encoding="utf-8")
    if as_json_only:
        write_json(results)
        return
    written = [*(f"{name}.png" for name in figures), ELLIPSES, PAGE, RESULTS]
    _say(report, target, written)


def _say(report: FitReport, target: Path, written: list[str]) -> None:
    print(report_text(report))
    said = words(report.language)["in_folder"].format(folder=target, files=", ".join(written))
    print(f"\n{said}")


@dataclass(frozen=True)
class _Part:
    """A function that takes the share done of one part of the work."""

    progress: Progress
    size: float

    @contextmanager
    def counted(self) -> Generator[Callable[[float], None]]:
        """Lend that function, and count the whole part as done at the end."""
        done = 0.0

        def advance(share: float) -> None:
            nonlocal done
            now = self.size * min(max(share, 0.0), 1.0)
            if now > done:
                self.progress.advance(now - done)
                done = now

        yield advance
        advance(1.0)


def _parts(progress: Progress) -> dict[str, _Part]:
    """The parts of the work by how long they take of a long track."""
    sizes = {"read": 25.0, "ellipses": 45.0, "fit": 15.0, "drawn": 15.0}
    return {name: _Part(progress, size) for name, size in sizes.items()}


def _found(file: Path, asked: Asked, parts: dict[str, _Part]) -> tuple[Findings, Profile | None]:
    """Read, reduce and fit."""
    with parts["read"].counted() as advance:
        track = kp.tracks.read(file, **asked.reading, progress=advance)
    with parts["ellipses"].counted() as advance:
        ellipses = ellipses_of(track, asked.swings, advance)
    is_phone = track.axes == "phone"
    with parts["fit"].counted() as advance:
        fitted = profile = why_not = None
        try:
            fitted = kp.tracks.fit(
                ellipses,
                length=asked.length,
                gravity=asked.gravity,
                latitude=asked.latitude,
                damping_unevenness=asked.unevenness,
                tilt=asked.tilt,
                progress=advance,
            )
        except kp.InvalidInput as error:
            if error.kind not in _TOO_LITTLE:
                raise
            why_not = error
        if fitted is not None and "headline" in fitted.models and not is_phone:
            profile = kp.tracks.profile(fitted)
    found = Findings(
        file.name,
        track,
        ellipses,
        fitted,
        (asked.unevenness, asked.tilt),
        asked.latitude,
        asked.length is not None,
        asked.swings,
        why_not,
    )
    return found, profile


def ellipses_of(
    track: kp.tracks.Track | kp.tracks.EllipseTable,
    swings: float,
    progress: Callable[[float], None] | None = None,
) -> xr.Dataset:
    """The ellipses of a track, or those that a table has ready."""
    if isinstance(track, kp.tracks.EllipseTable):
        return kp.tracks.tabulated(track.time, track.a, track.b, track.azimuth, unit=track.unit)
    return kp.tracks.ellipses(track, swings=swings, progress=progress)


def _drawn(
    found: Findings,
    profile: Profile | None,
    language: Language,
    progress: Callable[[float], None],
) -> dict[str, bytes]:
    """Each figure that there is, as PNG."""
    track, ellipses, fitted = found.track, found.ellipses, found.fit
    model = None if fitted is None else fitted.models.get("headline")
    figures = {
        "seen": plot.tracks.seen(track, ellipses, language=language),
        "course": plot.tracks.course(ellipses, model, language=language),
    }
    progress(0.3)
    if isinstance(track, kp.tracks.Track):
        residuals = kp.tracks.residuals(track, swings=found.swings)
        frequency = float(ellipses.frequency.mean())
        figures["spectrum"] = plot.tracks.spectrum(residuals, frequency, language=language)
    progress(0.6)
    if profile is not None:
        figures["profile"] = plot.tracks.profile(profile, language=language)
    if model is not None and profile is not None:
        figures["correlations"] = plot.tracks.correlations(model, language=language)
    written: dict[str, bytes] = {}
    for name, figure in figures.items():
        plot.save(figure, file := BytesIO())
        written[name] = file.getvalue()
    return written


def _write_netcdf(ellipses: xr.Dataset, path: Path) -> None:
    """Write the ellipses; what NetCDF has no type for is left out of their attributes."""
    plain = {
        key: int(value) if isinstance(value, bool) else value
        for key, value in ellipses.attrs.items()
        if isinstance(value, str | int | float)
    }
    ellipses.drop_attrs(deep=False).assign_attrs(plain).to_netcdf(  # pyright: ignore[reportUnknownMemberType]
        path, engine="h5netcdf"
    )
