"""``kugelpendel fit --plan``: how long to record, before anyone hangs a pendulum up."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

import kugelpendel as kp
from kugelpendel.cli.fit.asked import Asked, half_life, needed, number
from kugelpendel.cli.fit.words import words
from kugelpendel.cli.job_file.kinds import LENGTH
from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.terminal.streams import write_json
from kugelpendel.cli.terminal.tables import facts, numbers, paragraph
from kugelpendel.spelling import significant, spell

if TYPE_CHECKING:
    import argparse

    from kugelpendel.errors import Language
    from kugelpendel.tracks import Plan

_SHARE = 0.01


def plan(options: argparse.Namespace, asked: Asked) -> int:
    """Print how long to record for κ and for the latitude to one per cent.

    Raises
    ------
    InvalidInput
        The length, the swing, the noise or the rate is missing.
    """
    if options.track is not None:
        raise kp.InvalidInput.of("option_plan_of_track")
    rate = number(options, "rate", least=0.0)
    if rate is None:
        raise kp.InvalidInput.of("option_needed", option="--rate", example="30")
    found = kp.tracks.plan(
        needed(options, "length", LENGTH, "3 m"),
        a=needed(options, "a", LENGTH, "15 cm"),
        b=needed(options, "b", LENGTH, "1 cm"),
        noise=needed(options, "noise", LENGTH, "0.5 mm"),
        rate=rate,
        gravity=asked.gravity,
        latitude=asked.latitude,
        half_life=half_life(options),
        share=_SHARE,
    )
    if options.json:
        write_json(_as_json(found))
    else:
        print(_text(found, asked.language))
    return 0


def _as_json(found: Plan) -> str:
    return json_text(
        {
            "about": "kugelpendel: least recording times by the Cramér–Rao bound; null is beyond "
            "30 days",
            "share": _SHARE,
            "intrinsic_time_s": found.intrinsic_time,
            "intrinsic_time_known_s": found.intrinsic_time_known,
            "latitude_time_s": found.latitude_time,
            "half_life_s": found.half_life,
            "table": [
                {
                    "duration_s": row.duration,
                    "intrinsic_share": row.intrinsic,
                    "intrinsic_share_known": row.intrinsic_known,
                    "latitude_share": row.latitude,
                }
                for row in found.rows
            ],
        }
    )


def _text(found: Plan, language: Language) -> str:
    said = words(language)
    share = significant(100 * _SHARE, 1, language=language)

    def time(value: float) -> str:
        return (
            spell(value, "s", 3, language=language) if np.isfinite(value) else said["plan_beyond"]
        )

    times = {
        "plan_intrinsic": found.intrinsic_time,
        "plan_known": found.intrinsic_time_known,
        "plan_latitude": found.latitude_time,
    }
    rows = [
        (said[key].format(share=share), time(value), said[f"{key}_mean"])
        for key, value in times.items()
    ]
    table = [
        (
            time(row.duration),
            *(
                _percent(value, language)
                for value in (row.intrinsic, row.intrinsic_known, row.latitude)
            ),
        )
        for row in found.rows
        if np.isfinite(row.intrinsic)  # longer than the swing lasts
    ]
    halved = said["plan_bound"].format(half_life=time(found.half_life))
    return "\n\n".join(
        (
            said["plan_title"],
            facts(rows),
            numbers(said["plan_columns"].split("|"), table),
            paragraph(halved),
        )
    )


def _percent(share: float, language: Language) -> str:
    return f"{significant(100 * share, 2, language=language)} %" if math.isfinite(share) else "–"
