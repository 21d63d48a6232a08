"""χ² along one parameter."""

from __future__ import annotations

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Numbers, require_type
from kugelpendel.tracks._asked import require_text, whole
from kugelpendel.tracks.fitting._intervals import Judge
from kugelpendel.tracks.fitting._model import ALL
from kugelpendel.tracks.fitting._results import Profile, TrackFit
from kugelpendel.tracks.fitting._search import search

_FAR = 3.5
"""Standard errors to either side."""

_MOST = 10_000
"""Points; each is a search of its own."""


def profile(
    fit: TrackFit, name: str = "rotation", *, model: str = "headline", points: int = 15
) -> Profile:
    """χ² as one parameter is held and all others are fitted: whether, and where, it closes.

    Parameters
    ----------
    fit
        What `fit` found.
    name
        The parameter, in SI units; it must be free in the model.
    model
        One of the models of the averaged motion that were fitted.
    points
        How many values, at least five and at most 10 000, up to three and a half standard
        errors to either side.

    Returns
    -------
    Profile
        Of a model without a misfit it is a parabola but for |δ| near 0 and parameters that are
        hardly determined, so that `fit` does without.

    Raises
    ------
    InvalidInput
        For what is of another type, a model that was not fitted, and a parameter that is not free
        in it.
    """
    way_out = "give what kugelpendel.tracks.fit(ellipses) gives"
    require_type("What is profiled", fit, TrackFit, way_out=way_out)
    require_text("model", model)
    require_text("name", name)
    points = whole("points", points, 1, _MOST)
    if model not in fit.minima:
        raise InvalidInput.of("fit_model", seen=model, known=", ".join(fit.minima))
    problem, found = fit.problem, fit.minima[model]
    free = problem.free[model]
    if name not in free:
        raise InvalidInput.of("fit_parameter", seen=name, known=", ".join(free))
    stderr = found.stderr(name)
    if found.failed or not np.isfinite(stderr):
        stderr = float(problem.measured.steps()[ALL.index(name)]) * 1e4
    values = found.value(name) + stderr * np.linspace(-_FAR, _FAR, max(points, 5) | 1)
    rest = tuple(each for each in free if each != name)
    stated = problem.stated(model)
    held = stated.pop(name, None)
    chi_square = np.empty(len(values))
    middle = len(values) // 2
    for order in (range(middle, len(values)), range(middle - 1, -1, -1)):
        row = found.row.copy()
        for index in order:
            row[ALL.index(name)] = values[index]
            step = search(problem.measured, row, rest, stated)
            row = step.row.copy()
            prior = 0.0 if held is None else (values[index] / held) ** 2
            chi_square[index] = step.chi_square + prior
    judge = Judge(problem.measured, problem.scale, problem.ellipses, problem.scaled)
    chi_square -= min(found.chi_square, float(np.nanmin(chi_square)))
    level = judge.quantile(found.degrees) ** 2
    low = _crossing(values[: middle + 1][::-1], chi_square[: middle + 1][::-1], level)
    high = _crossing(values[middle:], chi_square[middle:], level)
    scale = {"a": 1 / problem.scale, "b": 1 / problem.scale, "quadratic": problem.scale}
    unit = scale.get(name, 1.0)
    closes = bool(np.isfinite(low) and np.isfinite(high))
    return Profile(name, values * unit, chi_square, level, low * unit, high * unit, closes)


def _crossing(values: Numbers, chi_square: Numbers, level: float) -> float:
    """Where χ² first passes a level, from the minimum outwards; NaN where it does not."""
    above = np.flatnonzero(chi_square > level)
    if len(above) == 0 or above[0] == 0:
        return float("nan")
    k = int(above[0])
    # Between two points χ² is nearer to a parabola than to a line: its root is taken.
    before, after = np.sqrt(np.maximum(chi_square[k - 1 : k + 1], 0.0))
    share = (np.sqrt(level) - before) / (after - before)
    return float(values[k - 1] + share * (values[k] - values[k - 1]))
