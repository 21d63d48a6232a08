"""Every public callable with wrong types in place of each argument: an answer, or a sentence."""

import contextlib
import inspect
import tempfile
import warnings
from collections.abc import Callable, Iterator
from io import BytesIO
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel import errors, observables, olsson, plot, series, tracks

PENDULUM = kp.Pendulum(1.0)
LAUNCH = kp.Launch.ellipse(0.1, 0.02)
EXACT = kp.ExactMotion(PENDULUM, LAUNCH)
FORCES = kp.Forces(site=kp.Site(0.9), suspension=kp.Suspension(1e-6))
REAL = kp.RealMotion(PENDULUM, LAUNCH, FORCES)
MEAN = kp.EnvelopeMotion(PENDULUM, LAUNCH, FORCES)
PORTRAIT = kp.Portrait.of(MEAN)
DESIGN = kp.design(PENDULUM, 0.1, checked=False)
MAP = kp.validity_map(2)
COMPARED = kp.compare(PENDULUM, LAUNCH, 2.0)
TIMES = np.array([0.0, 1.0])
DAY = observables.Apsides(TIMES, 0.1 + 0 * TIMES, 0.02 + 0 * TIMES, 0.1 * TIMES, 0.1, 0.02)
TRACK = tracks.synthesise(REAL, 150.0, 10.0, noise=1e-4)
ELLIPSES = tracks.ellipses(TRACK)
FIT = tracks.fit(ELLIPSES, models=("narrow",))
FIGURE = plot.portrait(PORTRAIT)

ODD = (
    "x", b"1", None, True, 1j, -1, 0, 1.5, 10**400, float("nan"), float("inf"), [], ["a"], {}, (),
    object(), type, lambda: 0, np.array(["a"]), np.zeros((2, 3)), np.array([1, None]),
    np.datetime64("now"), np.ma.array([1.0, 2.0], mask=[True, False]), PENDULUM, LAUNCH, EXACT,
)  # fmt: skip

Call = tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]

CALLS: dict[str, Call] = {
    "Bob": (kp.Bob, (0.03, 7860.0, 0.0, 1.2), {}),
    "Bob.gravity_factor": (kp.Bob(0.03, 7860.0).gravity_factor, (1.0,), {}),
    "Comparison.row": (COMPARED.row, ("LinearMotion",), {}),
    "CubicMotion": (kp.CubicMotion, (PENDULUM, LAUNCH), {}),
    "Design.__getitem__": (DESIGN.__getitem__, ("period",), {}),
    "Design.amplitude": (DESIGN.amplitude, (1.0,), {}),
    "Drag": (kp.Drag, (1e-4, 0.0), {}),
    "Drag.from_bob": (
        kp.Drag.from_bob,
        (kp.Bob(0.03, 7860.0), PENDULUM),
        {"air_viscosity": 1.8e-5, "drag_coefficient": 0.4, "thread_diameter": 1e-4,
         "thread_drag_coefficient": 1.1},
    ),
    "Drag.from_half_life": (kp.Drag.from_half_life, (100.0,), {}),
    "Drag.from_quality": (kp.Drag.from_quality, (100.0, PENDULUM), {}),
    "Drive": (kp.Drive, (1e-6,), {"phase": 0.4}),
    "EnvelopeMotion": (kp.EnvelopeMotion, (PENDULUM, LAUNCH, FORCES), {"exact": True}),
    "ExactMotion": (kp.ExactMotion, (PENDULUM, LAUNCH), {}),
    "ExactMotion.sample": (EXACT.sample, (0.0, 0.1, 3), {"out": np.zeros((3, 3))}),
    "ExactMotion.spectrum": (EXACT.spectrum, (2,), {}),
    "Spectrum.position": (EXACT.spectrum(2).position, (1.0,), {}),
    "Forces": (kp.Forces, (), {"site": None, "drag": None, "suspension": None, "bob": None,
                               "drive": None}),
    "Forces.effective_pendulum": (FORCES.effective_pendulum, (PENDULUM,), {}),
    "IdealSummary.of": (kp.IdealSummary.of, (EXACT,), {}),
    "Launch.angles": (kp.Launch.angles, (0.1, 0.2, 0.3, 0.4), {}),
    "Launch.apsides": (kp.Launch.apsides, (0.1, 0.05, 0.0), {}),
    "Launch.at_rest": (kp.Launch.at_rest, (0.1, 0.2), {}),
    "Launch.ellipse": (kp.Launch.ellipse, (0.1, 0.05, 0.0), {}),
    "Launch.plane": (kp.Launch.plane, (0.1, 0.05, 0.0, 0.1), {}),
    "Launch.state": (kp.Launch.state, ((0.0, 0.6, 0.8), (0.1, 0.0, 0.0)), {}),
    "LinearMotion": (kp.LinearMotion, (PENDULUM, LAUNCH), {}),
    "OlssonMotion": (kp.OlssonMotion, (PENDULUM, LAUNCH), {}),
    "Pendulum": (kp.Pendulum, (1.0, 9.81, 1.0), {}),
    "PlaneMotion": (kp.PlaneMotion, (PENDULUM, LAUNCH), {}),
    "Portrait": (kp.Portrait, (PENDULUM, 0.1, 0.01, 0.0, FORCES), {}),
    "Portrait.invariant": (PORTRAIT.invariant, (0.1, 0.2), {}),
    "Portrait.mean_rate": (PORTRAIT.mean_rate, (0.1, 0.2), {}),
    "Portrait.of": (kp.Portrait.of, (MEAN, 0.0), {}),
    "Portrait.path": (PORTRAIT.path, (5,), {}),
    "RealMotion": (kp.RealMotion, (PENDULUM, LAUNCH, FORCES), {"thread": "ends", "tolerance": 0.0}),
    "SeriesMotion": (kp.SeriesMotion, (PENDULUM, LAUNCH, 6), {}),
    "Site": (kp.Site, (0.9, 9.81, 0.0), {}),
    "Suspension": (kp.Suspension, (1e-6, 0.1, 1e-6, 0.1), {}),
    "Suspension.from_periods": (kp.Suspension.from_periods, (2.0, 2.001, 0.1, 0.0, 0.0), {}),
    "ValidityMap.reach": (MAP.reach, (MAP.errors.formula_25, 0.01), {}),
    "Wire": (kp.Wire, (1e-3, 2e11, 1e-5), {}),
    "cite": (kp.cite, ("text",), {}),
    "compare": (kp.compare, (PENDULUM, LAUNCH, 2.0, (6,)), {}),
    "design": (
        kp.design, (PENDULUM, 0.1, 0.01),
        {"azimuth": 0.0, "forces": FORCES, "wire": None, "share": 0.01, "after": 60.0,
         "radius": None, "time": None, "checked": False},
    ),
    "ellipse": (kp.ellipse, (EXACT, TIMES), {}),
    "measured_rates": (kp.measured_rates, (EXACT, 1.0), {}),
    "olsson.frequency": (olsson.frequency, (0.1, 0.05, 1.0, 9.81), {}),
    "olsson.precession": (olsson.precession, (0.1, 0.05, 1.0, 9.81), {}),
    "plot.compared": (lambda odd: plot.compared(odd, ""), (COMPARED,), {}),
    "plot.compared title": (lambda odd: plot.compared(COMPARED, odd), ("",), {}),
    "plot.day": (plot.day, (REAL, DAY, MEAN.rates(TIMES), ""), {}),
    "plot.design": (lambda odd: plot.design(odd, ""), (DESIGN,), {}),
    "plot.overview": (lambda odd: plot.overview(odd, 2.0), (None,), {}),
    "plot.portrait": (lambda odd: plot.portrait(odd), (PORTRAIT,), {}),
    "plot.save": (lambda odd: plot.save(odd, BytesIO()), (FIGURE,), {}),
    "plot.save path": (lambda odd: plot.save(FIGURE, odd), (BytesIO(),), {}),
    "plot.validity": (lambda odd: plot.validity(odd), (MAP,), {}),
    "series.frequency": (series.frequency, (4, "radii"), {}),
    "series.harmonics": (series.harmonics, (4, "radii"), {}),
    "series.precession": (series.precession, (4, "radii"), {}),
    "series.radius": (series.radius, (0.1, "radii"), {}),
    "series.trusted": (series.trusted, (0.1, 0.05, 4), {}),
    "tracks.EllipseTable": (tracks.EllipseTable, (TIMES, TIMES, TIMES, TIMES, "m"), {}),
    "tracks.Track": (tracks.Track, (TIMES, TIMES, TIMES, "m"), {}),
    "tracks.ellipses": (tracks.ellipses, (TRACK,), {"swings": 8.0}),
    "tracks.fit": (tracks.fit, (ELLIPSES,), {"length": None, "models": ("narrow",)}),
    "tracks.fit options": (
        lambda **odd: tracks.fit(ELLIPSES, models=("narrow",), **odd), (),
        {"gravity": 9.81, "latitude": None, "damping_unevenness": 0.1, "tilt": 0.02},
    ),
    # Of b > a no plan is made, which would take long; all else is looked at before.
    "tracks.plan": (
        tracks.plan, (1.0,),
        {"a": 0.1, "b": 0.2, "noise": 1e-4, "rate": 10.0, "gravity": 9.81, "latitude": 0.9,
         "half_life": 600.0, "share": 0.01},
    ),
    "tracks.profile": (tracks.profile, (FIT, "rotation"), {"model": "narrow", "points": 5}),
    "tracks.read": (
        tracks.read, ("none.csv",),
        {"columns": None, "mass": None, "rate": None, "scale": None, "y_down": None},
    ),
    "tracks.residuals": (tracks.residuals, (TRACK,), {"swings": 8.0}),
    "tracks.synthesise": (
        tracks.synthesise, (MEAN, 10.0, 10.0),
        {"start": 0.0, "noise": 1e-4, "colour": "white", "noise_ratio": 1.0, "jitter": 0.0,
         "gaps": (), "outliers": 0.0, "tilt": 0.0, "tilt_axis": 0.0, "pixel": None, "seed": 0},
    ),
    "tracks.tabulated": (tracks.tabulated, (np.arange(6.0),) * 4, {"unit": "m"}),
    "validity": (kp.validity, (0.1, 0.05, 1.0), {}),
    "validity_map": (kp.validity_map, (3, 0.9), {}),
}  # fmt: skip
for _motion in (EXACT, REAL, MEAN):
    _name = type(_motion).__name__
    CALLS |= {
        f"{_name}.position": (_motion.position, (TIMES,), {}),
        f"{_name}.velocity": (_motion.velocity, (TIMES,), {}),
        f"{_name}.tension": (_motion.tension, (TIMES,), {}),
        f"{_name}.events": (_motion.events, ("radius", 0.0, 1.0, 0.05), {}),
        f"{_name}.next_event": (_motion.next_event, ("radius", 0.0, 1.0, 0.05), {}),
        f"{_name}.to_xarray": (_motion.to_xarray, (TIMES,), {}),
    }


def swept(spec: Any, out: Any, client: Any) -> None:
    """A sweep in a folder that goes again."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        kp.sweep(spec, out, client)


SWEEP: tuple[Any, ...] = (
    {"pendulum": {"length": 1.0}, "launch": {"kind": "ellipse", "a": kp.sweeps.Listed((0.1, 0.2)),
                                             "b": 0.0}},
    "grid", "exact", ("period",), (), None, 0, True, ("all",), None,
)  # fmt: skip
CALLS |= {
    "Sweep": (kp.Sweep, SWEEP, {}),
    "sweep": (swept, (kp.Sweep(*SWEEP), "out", None), {}),
}
CALLS |= {
    "RealMotion.sample": (REAL.sample, (0.0, 0.1, 3), {}),
    "EnvelopeMotion.rates": (MEAN.rates, (TIMES,), {}),
    "EnvelopeMotion.semi_axes": (MEAN.semi_axes, (TIMES,), {}),
    "EnvelopeMotion.course": (MEAN.course, (10.0,), {}),
    "EnvelopeMotion.pace": (MEAN.pace, (0.0, 10.0), {}),
    "RealMotion.course": (REAL.course, (TIMES,), {}),
}

MADE_BY_OTHERS = {
    "Comparison", "Design", "DesignAnswer", "DesignCheck", "Ellipse", "IdealSummary", "Launch",
    "Motion", "PrecessionBudget", "Rates", "Spectrum", "Validity", "ValidityMap",
}  # fmt: skip
"""What nobody makes by hand; a launch has its named makers."""


def variations(call: Call) -> Iterator[tuple[str, Call]]:
    """The call with one wrong argument each."""
    what, given, named = call
    for odd in ODD:
        for place in range(len(given)):
            changed = (*given[:place], odd, *given[place + 1 :])
            yield f"argument {place}: {odd!r:.40}", (what, changed, named)
        for name in named:
            yield f"{name}: {odd!r:.40}", (what, given, {**named, name: odd})


@pytest.mark.parametrize("name", CALLS)
def test_a_wrong_type_is_a_sentence(name: str) -> None:
    faults: list[str] = []
    for how, (what, given, named) in variations(CALLS[name]):
        with warnings.catch_warnings(), contextlib.suppress(kp.KugelpendelError):
            warnings.simplefilter("ignore")
            try:
                what(*given, **named)
            except kp.KugelpendelError as error:
                if len(str(error)) < 20:
                    faults.append(f"{how}: {error!r} is no sentence")
            except Exception as error:  # noqa: BLE001 — any of them is what is looked for
                faults.append(f"{how}: {error!r:.150}")
    assert faults == []


def test_none_is_left_out() -> None:
    public = [name for name in kp.__all__ if callable(getattr(kp, name))]
    made = {name.split(".")[0] for name in CALLS} | MADE_BY_OTHERS
    wrong = [name for name in public if name not in made and not hasattr(errors, name)]
    assert wrong == []
    for module in (plot, series, tracks):
        for name, _ in inspect.getmembers(module, inspect.isfunction):
            if not name.startswith("_"):
                assert f"{module.__name__.removeprefix('kugelpendel.')}.{name}" in CALLS


@pytest.mark.parametrize("odd", [1, "x", b"1", TIMES])
def test_a_listener_is_a_function(odd: Any) -> None:
    for call in (
        lambda: tracks.ellipses(TRACK, progress=odd),
        lambda: tracks.fit(ELLIPSES, progress=odd),
        lambda: tracks.read("none.csv", progress=odd),
        lambda: tracks.synthesise(MEAN, 10.0, 10.0, done=odd),
        lambda: kp.sweep(kp.Sweep(*SWEEP), "out", progress=odd),
    ):
        with pytest.raises(kp.InvalidInput, match="function"):
            call()
