"""What a fit has found as JSON: units in the keys or beside the numbers, and nothing in words."""

from __future__ import annotations

from importlib.metadata import version
from typing import TYPE_CHECKING, Any

from kugelpendel.cli.json_text import json_text

if TYPE_CHECKING:
    import xarray as xr

    from kugelpendel.cli.fit.report import Findings
    from kugelpendel.tracks import Estimate, FittedModel, Note, TrackFit

_VARIABLES = ("a", "b", "azimuth", "frequency", "x0", "y0")

_ABOUT = (
    "kugelpendel: a recorded track; SI units, or those of the track as named; azimuths, b and "
    "rates are positive counter-clockwise seen from above, but the rotation of the ground turns "
    "the plane by its negative; null is not determined, or not there"
)


def as_json(found: Findings) -> str:
    """All that was found as JSON text."""
    fit = found.fit
    is_phone = found.track.axes == "phone"
    tables: dict[str, Any] = {
        "about": _ABOUT,
        "version": version("kugelpendel"),
        "file": found.file,
        "unit": found.track.unit,
        "axes": found.track.axes,
        "notes": [note_table(note) for note in found.notes],
        "ellipses": ellipses_table(found.ellipses),
    }
    if found.why_not is not None:
        tables["why_no_model"] = found.why_not.sentence(door="file")
    if fit is not None:
        tables |= {
            "assumed": {"damping_unevenness": found.sizes[0], "tilt": found.sizes[1]},
            "pendulum": {
                "length_m": fit.length,
                "length_is_given": found.is_length_given,
                "gravity_m_per_s2": fit.gravity,
                "frequency_rad_per_s": fit.frequency,
                "reference_time_s": fit.time,
                "latitude_given_rad": found.latitude,
                "is_planar": fit.planar,
                "is_scaled": fit.scaled,
            },
            "misfit": fit.misfit.__dict__ | {"excess": dict(fit.misfit.excess)},
            "models": {name: _model(model) for name, model in fit.models.items()}
            if not is_phone
            else {"headline": _of_phone(fit.headline)},
            **_extras(fit, is_phone),
        }
    return json_text(tables)


def note_table(note: Note) -> dict[str, Any]:
    """A note as data, with its sentences."""
    return {
        "kind": note.kind,
        "action": note.action,
        "values": dict(note.values),
        "en": note.sentence("en"),
        "de": note.sentence("de"),
    }


def ellipses_table(ellipses: xr.Dataset) -> dict[str, Any]:
    """The ellipses as columns, with their errors, their covariance and what was seen on the way."""
    columns: dict[str, Any] = {"time": ellipses.time.values}
    for name in _VARIABLES:
        columns[name] = ellipses[name].values
        columns[f"{name}_stderr"] = ellipses[f"{name}_stderr"].values
    return {
        **columns,
        "covariance": ellipses["covariance"].values,
        "covariance_of": list(_VARIABLES),
        "attributes": dict(ellipses.attrs),
    }


def _model(model: FittedModel) -> dict[str, Any]:
    return {
        "parameters": {name: _estimate(one) for name, one in model.parameters.items()},
        "correlation": model.correlation,
        "chi_square": model.chi_square,
        "degrees_of_freedom": model.degrees,
        "failed": model.failed,
        "time": model.time,
        **{name: getattr(model, name) for name in ("a", "b", "azimuth")},
        **{
            f"residual_{name}": getattr(model, f"residual_{name}") for name in ("a", "b", "azimuth")
        },
    }


def _of_phone(model: FittedModel) -> dict[str, Any]:
    """What a phone tells in its own axes, which turn with it: size and decay, never a direction."""
    known = ("a", "linear", "quadratic")
    return {"parameters": {name: _estimate(model.parameters[name]) for name in known}}


def _estimate(estimate: Estimate) -> dict[str, Any]:
    return dict(estimate.__dict__)


def _extras(fit: TrackFit, is_phone: bool) -> dict[str, Any]:
    extras: dict[str, Any] = {}
    if fit.period is not None:
        extras["period"] = {
            "slope": _estimate(fit.period.slope),
            "theory": fit.period.theory,
            "drift": _estimate(fit.period.drift),
            "both": [_estimate(one) for one in fit.period.both],
            "chi_square": dict(fit.period.chi_square),
            "degrees_of_freedom": fit.period.degrees,
        }
    if fit.wobble is not None and not is_phone:
        extras["wobble"] = dict(fit.wobble.__dict__)
    if fit.stiffening is not None and not is_phone:
        names = ("from_intrinsic", "from_period", "joint")
        read = {name: _estimate(getattr(fit.stiffening, name)) for name in names}
        extras["stiffening"] = {**read, "agree": fit.stiffening.agree}
    return extras
