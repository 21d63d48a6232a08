"""The pendulum behind the ellipses of a track."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._asked import require, require_listener
from kugelpendel.tracks._scipy import chi_square_tail
from kugelpendel.tracks.fitting._intervals import Judge, is_misfit
from kugelpendel.tracks.fitting._measured import azimuth_alone
from kugelpendel.tracks.fitting._period import period_table, stiffening
from kugelpendel.tracks.fitting._problem import problem_of, silent
from kugelpendel.tracks.fitting._results import FittedModel, Misfit, TrackFit
from kugelpendel.tracks.fitting._search import Found
from kugelpendel.tracks.fitting._wobble import wobble
from kugelpendel.tracks.reduction import column

MODELS = (
    "headline",
    "narrow",
    "uneven",
    "tilted",
    "intrinsic",
    "intrinsic_narrow",
    "intrinsic_known",
    "measured",
    "measured_anisotropy",
)
"""Every model, the one to quote first."""


def fit(
    ellipses: Any,
    *,
    length: float | None = None,
    gravity: float = 9.80665,
    latitude: float | None = None,
    damping_unevenness: float = 0.1,
    tilt: float = 0.02,
    models: Sequence[str] = MODELS,
    progress: Callable[[float], None] | None = None,
) -> TrackFit:
    """What turns the plane and what takes the amplitude, with intervals that say what they assume.

    Parameters
    ----------
    ellipses
        The data set of `ellipses` or `tabulated`, or a `Track`.
    length
        Of the pendulum, m, where it was measured; the gravity then follows from the frequency.
        Otherwise the length does.
    gravity
        m/s², where no length is given.
    latitude
        Of the place, rad: for one more model, with κ free and the ground's rotation known.
    damping_unevenness
        Standard deviation of Δγ/γ about 0, of each of its two components: how unequal the decay in
        two directions may be. It is there in every real support, and cannot be seen in χ².
    tilt
        The same of the difference of scales in two directions: of a camera that looks askew.
    models
        Those that are wanted; the narrow one comes always, as the others start from it.
    progress
        Called with the share that is done; what it raises ends the work.

    Returns
    -------
    TrackFit
        Several models; the headline is the one with nuisances. All 95 % intervals are t times the
        standard error that the covariance of the ellipses gives. χ²/ndof is multiplied in where it
        is a misfit, and for a table of ellipses always, with the correlation of the residuals.

    Raises
    ------
    InvalidInput
        For what is of another type, fewer than six windows, a track in one plane that does
        not turn, lengths and sizes that are not positive.

    Notes
    -----
    Averaged equations of the real pendulum (docs/conventions.md), in the core; the phase is not
    fitted, for it knows more only if the clock and the −1/16 of the amplitude are perfect. A
    parameter whose interval is wider than its physical range (|Ω_z| ≤ Ω_E, |Δγ| ≤ 2γ, 0 ≤ κ ≤ 1)
    is "not determined". Coverage on synthetic tracks is in docs/tracks.md.
    """
    is_list = isinstance(models, (list, tuple))
    require(is_list, "models", models, "list of names", 'write models=["narrow"]')
    require_listener(progress)
    for name in models:
        if not isinstance(name, str) or name not in MODELS:  # pyright: ignore[reportUnnecessaryIsInstance]
            raise InvalidInput.of("fit_model", seen=str(name), known=", ".join(MODELS))
    tell = progress or silent
    problem = problem_of(ellipses, length, gravity, latitude, damping_unevenness, tilt, tell)
    ellipses, measured = problem.ellipses, problem.measured
    judge = Judge(measured, problem.scale, ellipses, problem.scaled)
    narrow = problem.narrow()
    minima = {"narrow": narrow}
    for done, name in enumerate(problem.free):
        if name in models and name not in minima:
            minima[name] = problem.solved(name, narrow.row)
        tell(0.3 + 0.7 * (done + 1) / len(problem.free))
    fitted = {
        name: judge.model(name, found, tuple(problem.stated(name)))
        for name, found in minima.items()
    }
    for name in ("measured", "measured_anisotropy"):
        if name in models:
            fitted[name] = azimuth_alone(name, measured, judge, name != "measured")
    lengths, gravities, omega0 = measured.pendulum(narrow.row[None])
    period = period_table(ellipses, float(lengths[0]), problem.scaled)
    return TrackFit(
        time=float(column(ellipses, "time")[problem.middle]),
        length=float(lengths[0]),
        gravity=float(gravities[0]),
        frequency=float(omega0[0]),
        scaled=problem.scaled,
        models={name: fitted[name] for name in MODELS if name in fitted},
        misfit=_misfit(narrow, fitted["narrow"], ellipses),
        period=period,
        wobble=wobble(ellipses),
        stiffening=stiffening(fitted.get("measured"), period) if problem.scaled else None,
        planar=bool(ellipses.attrs["planar"]),
        problem=problem,
        minima=minima,
    )


def _misfit(found: Found, model: FittedModel, ellipses: Any) -> Misfit:
    rests = {"a": model.residual_a, "b": model.residual_b, "azimuth": model.residual_azimuth}
    excess = {
        name: float(np.sqrt(np.mean((rest / column(ellipses, f"{name}_stderr")) ** 2)))
        for name, rest in rests.items()
    }
    degrees = max(found.degrees, 1)
    probability = chi_square_tail(found.chi_square, degrees)
    return Misfit(
        chi_square=found.chi_square,
        degrees=degrees,
        ratio=found.chi_square / degrees,
        probability=probability,
        excess=excess,
        is_misfit=is_misfit(found.chi_square, degrees),
    )
