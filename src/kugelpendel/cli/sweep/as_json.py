"""What a sweep has come to, as JSON."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.sweep.report import answers
from kugelpendel.errors import InvalidInput
from kugelpendel.sweeps import QUANTITIES, STATUS, why
from kugelpendel.sweeps._reductions import evenly
from kugelpendel.sweeps._sensitivity import sensitivity

if TYPE_CHECKING:
    from xarray import Dataset

    from kugelpendel.sweeps import Sweep
    from kugelpendel.sweeps._sensitivity import Share

_ABOUT = "kugelpendel sweep: what the cases came to; SI and radians; null where there is no number"
_SHARES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)


def as_json(sweep: Sweep, dataset: Dataset) -> str:
    """Write counts, bad cases, distributions and Sobol indices."""
    status = dataset["status"].attrs
    return json_text(
        {
            "about": _ABOUT,
            "sweep": json.loads(sweep.as_json()),
            "cases": sweep.size,
            "status": dict(zip(STATUS, status["counts"], strict=True)),
            "bad": [_bad(sweep, index) for index in status["first_bad"]],
            "results": [*_results(sweep, dataset), *_reduced(sweep, dataset)],
        }
    )


def _bad(sweep: Sweep, index: int) -> dict[str, Any]:
    given = {name: float(value[0]) for name, value in sweep.values(index, index + 1).items()}
    return {"case": index, "given": given, "why": why(sweep, index, door="file")}


def _results(sweep: Sweep, dataset: Dataset) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = []
    for answer in answers(sweep, dataset) if sweep.keeps_all else ():
        finite = answer.values[np.isfinite(answer.values)]
        result: dict[str, Any] = {
            "quantity": answer.name,
            "unit": QUANTITIES[answer.name].unit,
            "time": answer.time,
            "answers": int(finite.size),
            "infinite": int(np.isinf(answer.values).sum()),
        }
        if finite.size:
            shares = np.quantile(evenly(finite), _SHARES)
            result |= {
                "mean": finite.mean(),
                "std": finite.std(ddof=1) if finite.size > 1 else np.nan,
                "least": finite.min(),
                "most": finite.max(),
                "quantiles": {f"{q:g}": v for q, v in zip(_SHARES, shares, strict=True)},
            }
        if sweep.design == "sobol":
            result["causes"] = _causes(sweep, answer.values)
        found.append(result)
    return found


def _causes(sweep: Sweep, values: np.ndarray[Any, Any]) -> dict[str, Any] | None:
    """Sobol indices, where they can be told."""
    try:
        told = sensitivity(values, sweep.names, second_order=sweep.second_order, seed=sweep.seed)
    except InvalidInput:
        return None
    return {
        "alone": {name: _share(share) for name, share in told.alone.items()},
        "total": {name: _share(share) for name, share in told.total.items()},
        "together": {" × ".join(pair): _share(share) for pair, share in told.together.items()},
        "blocks": told.blocks,
        "dropped": told.dropped,
    }


def _share(share: Share) -> dict[str, float]:
    return {"value": share.value, "error_95_percent": share.error}


def _reduced(sweep: Sweep, dataset: Dataset) -> list[dict[str, Any]]:
    """Where only reductions are kept: each of them under its name."""
    if sweep.keeps_all:
        return []
    found: list[dict[str, Any]] = []
    for name in sweep.quantities:
        kept = [str(key) for key in dataset if str(key).startswith(f"{name}_")]
        found.append(
            {
                "quantity": name,
                "unit": QUANTITIES[name].unit,
                **{key.removeprefix(f"{name}_"): dataset[key].values for key in kept},
            }
        )
    return found
