"""What a fit has come to, in words: one report for the terminal and for the page."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

import kugelpendel as kp
from kugelpendel.cli.fit.numbers import Shown, interval, plus_minus, shown_in
from kugelpendel.cli.fit.words import words
from kugelpendel.spelling import as_given, general, grouped, significant, spell
from kugelpendel.tracks import Note

if TYPE_CHECKING:
    import xarray as xr

    from kugelpendel.errors import Language
    from kugelpendel.tracks import EllipseTable, Estimate, Track, TrackFit


@dataclass(frozen=True)
class ReportRow:
    """A number with its name and what it is."""

    name: str
    value: str
    meaning: str


@dataclass
class ReportSection:
    """Numbers that belong together, sentences about them, and keys of figures."""

    key: str
    title: str
    rows: list[ReportRow] = field(default_factory=list[ReportRow])
    sentences: list[str] = field(default_factory=list[str])
    figures: tuple[str, ...] = ()


@dataclass(frozen=True)
class FitReport:
    """All that is said about a track.

    Attributes
    ----------
    file, title
        The name of the file, and a title with it.
    headline
        Whether the model describes the track at all; it comes first.
    is_misfit
        Whether it does not.
    sections
        Numbers, sentences and figures.
    notes
        What was changed, dropped or assumed: a label and a sentence each.
    """

    language: Language
    file: str
    title: str
    headline: str
    is_misfit: bool
    sections: list[ReportSection]
    notes: list[tuple[str, str]]


@dataclass(frozen=True)
class Findings:
    """What a report is made of.

    Attributes
    ----------
    fit
        None where only ellipses could be found.
    sizes
        The unevenness of the damping and the tilt that the headline allows for, as shares.
    latitude
        The one that was given, rad, or None.
    is_length_given
        Whether the length was.
    swings
        In a window.
    why_not
        Why no model could be fitted; None where one was.
    """

    file: str
    track: Track | EllipseTable
    ellipses: xr.Dataset
    fit: TrackFit | None
    sizes: tuple[float, float]
    latitude: float | None
    is_length_given: bool
    swings: float
    why_not: kp.InvalidInput | None = None

    @property
    def notes(self) -> tuple[Note, ...]:
        """What was changed, dropped or assumed in reading and in finding the ellipses."""
        found = {
            "outliers": int(self.ellipses.attrs.get("rejected", 0)),
            "pieces_left_out": int(self.ellipses.attrs.get("left_out", 0)),
        }
        dropped = (Note.of(kind, count=count) for kind, count in found.items() if count)
        return (*self.track.notes, *dropped)


def make_report(found: Findings, language: Language) -> FitReport:
    """Word what was found."""
    return _Writer(found, language).report()


def note_lines(notes: tuple[Note, ...], language: Language) -> list[tuple[str, str]]:
    """Each note as a label and a sentence, what was changed first."""
    said = words(language)
    order = ("changed", "dropped", "assumed", "seen")
    ordered = sorted(notes, key=lambda note: order.index(note.action))
    return [(said[note.action], note.sentence(language)) for note in ordered]


class _Writer:
    def __init__(self, found: Findings, language: Language) -> None:
        self._found = found
        self._language: Language = language
        self._words = words(language)

    def report(self) -> FitReport:
        found, fit = self._found, self._found.fit
        headline, is_misfit = self._headline()
        sections = [self._track(), self._ellipse()]
        if fit is not None and self._has_axes_of_room:
            sections += [self._turning(fit), self._damping(fit), self._suspension(fit)]
            sections += [self._intrinsic(fit), self._wobble(fit), self._stiffening(fit)]
        elif fit is not None:
            sections += [self._damping(fit)]
        if fit is not None:
            sections.append(self._period(fit))
        return FitReport(
            self._language,
            found.file,
            self._say("title", file=found.file),
            headline,
            is_misfit,
            [one for one in sections if one.rows or one.sentences],
            note_lines(found.notes, self._language),
        )

    @property
    def _has_axes_of_room(self) -> bool:
        return self._found.track.axes == "room"

    def _say(self, key: str, **values: str) -> str:
        return self._words[key].format_map(values)

    def _number(self, value: float, digits: int = 3) -> str:
        return significant(value, digits, language=self._language)

    def _headline(self) -> tuple[str, bool]:
        fit = self._found.fit
        if fit is None:
            why = self._found.why_not
            said = "" if why is None else why.sentence(self._language, "file")
            return f"{self._say('ellipses_only')} {said}".strip(), False
        misfit = fit.misfit
        excess = ", ".join(
            self._say("excess_one", name=self._words[name], ratio=self._number(ratio, 2))
            for name, ratio in misfit.excess.items()
        )
        said = self._say(
            "misfit" if misfit.is_misfit else "fits",
            chi_square=self._number(misfit.chi_square),
            degrees=str(int(misfit.degrees)),
            excess=excess,
        )
        return said, bool(misfit.is_misfit)

    def _track(self) -> ReportSection:
        attrs = self._found.ellipses.attrs
        section = ReportSection("track", self._say("section_track"), figures=("seen",))
        count = self._found.ellipses.sizes["time"]
        is_table = attrs.get("origin") == "table"
        if not is_table:
            points = grouped(int(attrs["points"]))
            meaning = self._say("points_mean", rejected=grouped(int(attrs["rejected"])))
            section.rows.append(ReportRow(self._say("points"), points, meaning))
        duration = float(np.ptp(self._found.ellipses.time.values))
        key = "duration_table_mean" if is_table else "duration_mean"
        meaning = self._say(key, count=grouped(count), swings=general(self._found.swings))
        length = spell(duration, "s", language=self._language)
        section.rows.append(ReportRow(self._say("duration"), length, meaning))
        if not is_table and "noise_x" in attrs:
            noises = [self._length(float(attrs[name])) for name in ("noise_x", "noise_y")]
            section.rows.append(
                ReportRow(self._say("noise"), " · ".join(noises), self._say("noise_mean"))
            )
        return section

    def _length(self, value: float) -> str:
        unit = self._found.track.unit
        if unit == "m":
            return spell(value, "m", 3, language=self._language)
        return f"{self._number(value)} {unit}"

    def _estimated(self, key: str, estimate: Estimate | None, name: str = "") -> ReportRow | None:
        """A row of an estimate; without a number where it is not determined."""
        if estimate is None:
            return None
        meaning = self._say(f"{key}_mean", **self._sizes())
        shown = shown_in(name or key, estimate, self._language)
        if estimate.verdict == "not determined":
            bare = "_bare" if estimate.reason == "modulus" and np.isnan(estimate.high) else ""
            reason = self._say(f"reason_{estimate.reason}{bare}", high=shown.whole(estimate.high))
            return ReportRow(
                self._words[key], self._say("not_determined"), f"{meaning} {_capital(reason)}"
            )
        bounds = interval(estimate, shown)
        if bounds:
            meaning = f"{meaning} {self._say('interval', low=bounds[0], high=bounds[1])}."
        return ReportRow(self._words[key], plus_minus(estimate, shown), meaning)

    def _sizes(self) -> dict[str, str]:
        unevenness, tilt = (
            general(100 * size, 3, language=self._language) for size in self._found.sizes
        )
        return {"unevenness": unevenness, "tilt": tilt}

    def _rows(self, section: ReportSection, *rows: ReportRow | None) -> ReportSection:
        section.rows += [row for row in rows if row is not None]
        return section

    def _ellipse(self) -> ReportSection:
        fit, section = self._found.fit, ReportSection("ellipse", self._say("section_ellipse"))
        section.figures = ("course",)
        if fit is None or "headline" not in fit.models:
            middle = self._found.ellipses.isel(time=self._found.ellipses.sizes["time"] // 2)
            for name in ("a", "b", "azimuth"):
                value, error = float(middle[name]), float(middle[f"{name}_stderr"])
                unit = "rad" if name == "azimuth" else self._found.track.unit
                shown = Shown.of(name, unit, value, self._language)
                text = f"{shown.pair(value, error)} {shown.symbol}"
                section.rows.append(ReportRow(self._words[name], text, self._say(f"{name}_mean")))
        else:
            known = fit.models["headline"].parameters
            self._rows(
                section, *(self._estimated(name, known.get(name)) for name in ("a", "b", "azimuth"))
            )
        if not self._has_axes_of_room:
            section.rows = section.rows[:1]
            section.sentences.append(self._say("phone"))
        if fit is not None:
            if np.isfinite(fit.frequency):
                period = spell(2 * np.pi / fit.frequency, "s", 6, language=self._language)
                section.rows.append(
                    ReportRow(self._say("period"), period, self._say("period_mean"))
                )
            if np.isfinite(fit.length):
                length = as_given(float(fit.length), "m", language=self._language)
                key = "length_given_mean" if self._found.is_length_given else "length_mean"
                gravity = general(fit.gravity, 6, language=self._language)
                section.rows.append(
                    ReportRow(self._say("length"), length, self._say(key, gravity=gravity))
                )
            if fit.planar:
                section.sentences.append(self._say("planar"))
        return section

    def _turning(self, fit: TrackFit) -> ReportSection:
        section = ReportSection("turning", self._say("section_turning"), figures=("profile",))
        for key, model in (
            ("rotation", "headline"),
            ("rotation_narrow", "narrow"),
            ("rotation_uneven", "uneven"),
        ):
            if model in fit.models:
                estimate = fit.models[model].parameters.get("rotation")
                if (
                    model == "uneven"
                    and estimate is not None
                    and estimate.verdict == "not determined"
                ):
                    section.sentences.append(self._say("not_determined_sentence"))
                    continue
                self._rows(section, self._estimated(key, estimate, "rotation"))
        if "headline" in fit.models:
            known = fit.models["headline"].parameters
            self._rows(section, self._estimated("latitude", known.get("latitude")))
            section.sentences.append(self._say("assumptions", **self._sizes()))
            self._site(section, known.get("rotation"))
        return section

    def _site(self, section: ReportSection, estimate: Estimate | None) -> None:
        from kugelpendel.parameters import Site

        if self._found.latitude is None or estimate is None:
            return
        rate = float(Site(self._found.latitude).vertical_rotation)
        shown = Shown.of("rotation", "rad/s", rate, self._language)
        is_inside = not estimate.low > rate and not estimate.high < rate
        where = self._say("inside" if is_inside else "outside")
        value = f"{significant(rate * shown.factor, 5, language=self._language)} {shown.symbol}"
        meaning = self._say("latitude_given_mean", where=where)
        section.rows.append(ReportRow(self._say("latitude_given"), value, meaning))

    def _damping(self, fit: TrackFit) -> ReportSection:
        section = ReportSection("damping", self._say("section_damping"))
        if "headline" in fit.models:
            known = fit.models["headline"].parameters
            self._rows(
                section,
                *(self._estimated(name, known.get(name)) for name in ("linear", "quadratic")),
            )
        return section

    def _suspension(self, fit: TrackFit) -> ReportSection:
        section = ReportSection(
            "suspension", self._say("section_suspension"), figures=("correlations",)
        )
        if "headline" in fit.models:
            known = fit.models["headline"].parameters
            names = ("anisotropy", "axis", "anisotropy_cos", "anisotropy_sin")
            self._rows(section, *(self._estimated(name, known.get(name)) for name in names))
        return section

    def _intrinsic(self, fit: TrackFit) -> ReportSection:
        section = ReportSection("intrinsic", self._say("section_intrinsic"))
        if not fit.scaled:
            section.sentences.append(self._say("unscaled"))
            return section
        for key in (
            "intrinsic",
            "intrinsic_narrow",
            "intrinsic_known",
            "measured",
            "measured_anisotropy",
        ):
            estimate = fit.models[key].parameters.get("intrinsic") if key in fit.models else None
            self._rows(section, self._estimated(key, estimate, "intrinsic"))
            if estimate is not None and estimate.verdict == "determined":
                is_theory = estimate.low <= 0.375 <= estimate.high
                said = self._say("agrees" if is_theory else "differs", model=self._words[key])
                section.sentences.append(said)
        return section

    def _wobble(self, fit: TrackFit) -> ReportSection:
        section = ReportSection("wobble", self._say("section_wobble"))
        wobble = fit.wobble
        if wobble is None:
            return section
        shown = Shown.of("rotation", "rad/s", wobble.rate, self._language)
        rate = f"{shown.pair(wobble.rate, wobble.rate_stderr)} {shown.symbol}"
        naive = f"± {shown.number(wobble.naive_stderr)} {shown.symbol}"
        section.rows += [
            ReportRow(self._say("mean_rate"), rate, self._say("mean_rate_mean")),
            ReportRow(self._say("naive"), naive, self._say("naive_mean")),
        ]
        for key in ("explained_2", "explained_4"):
            share = float(getattr(wobble, key))
            if np.isfinite(share):
                value = f"{self._number(100 * share, 2)} %"
                section.rows.append(ReportRow(self._words[key], value, self._say(f"{key}_mean")))
        return section

    def _stiffening(self, fit: TrackFit) -> ReportSection:
        section = ReportSection("stiffening", self._say("section_stiffening"))
        found = fit.stiffening
        if found is not None:
            for key in ("from_intrinsic", "from_period", "joint"):
                self._rows(section, self._estimated(key, getattr(found, key)))
            section.sentences.append(self._say("do_agree" if found.agree else "do_not_agree"))
        return section

    def _period(self, fit: TrackFit) -> ReportSection:
        section = ReportSection("period", self._say("section_period"))
        table = fit.period
        if table is None:
            return section
        self._rows(section, self._estimated("slope", table.slope))
        theory = self._number(table.theory)
        section.rows.append(ReportRow(self._say("theory"), theory, self._say("theory_mean")))
        self._rows(section, self._estimated("drift", table.drift))
        values = {name: self._number(value) for name, value in table.chi_square.items()}
        if {"theory", "slope", "drift", "both"} <= values.keys():
            section.sentences.append(
                self._say("chi_table", degrees=str(int(table.degrees)), **values)
            )
        return section


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
