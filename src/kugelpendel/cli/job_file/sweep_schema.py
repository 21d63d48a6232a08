"""What the file of a sweep may say: a job without output, and what is asked of many of them."""

from __future__ import annotations

from kugelpendel.cli.job_file.kinds import TIME
from kugelpendel.cli.job_file.schema import (
    FORCES,
    LAUNCH,
    PENDULUM,
    Choice,
    FileSchema,
    Key,
    Number,
    Section,
    Several,
    Truth,
)

SWEEP = Section(
    "sweep",
    (
        Key(
            "design",
            Choice(("grid", "sample", "sobol")),
            "all combinations, independent draws, or Saltelli's design for Sobol indices",
            default="grid",
        ),
        Key(
            "motion",
            Choice(("exact", "averaged", "real")),
            "which is followed",
            needed=True,
            example='"averaged"',
        ),
        Key(
            "quantities",
            Several("azimuth"),
            "what is read of each case, by the names in docs/sweeps.md",
            needed=True,
            example='["azimuth", "b"]',
        ),
        Key("times", Several(TIME), "when it is read: a list or a range", example='["1 h", "6 h"]'),
        Key("count", Number(10000), "cases of a sample; base points of Sobol's, a power of two"),
        Key("seed", Number(1), "of the draws", default=0.0),
        Key("second_order", Truth(), "whether Sobol's design tells pairs too", default=True),
        Key(
            "keep",
            Several("all"),
            "all values, or reductions of them: `moments`, `quantiles`, `histograms`",
            unless="all",
            example='["moments", "quantiles"]',
        ),
        Key(
            "chunk",
            Number(65536),
            "cases that are done and stored together",
            unless="about a second of work for one core",
        ),
    ),
    needed=True,
)

SWEEP_FILE = FileSchema(
    (PENDULUM, LAUNCH, SWEEP, *FORCES),
    {
        "pendulum": {"length": '"20 m"'},
        "launch": {
            "kind": '"ellipse"',
            "a": '{ from = "20 cm", to = "2 m", count = 40 }',
            "b": '"0 cm"',
        },
        "site": {"latitude": '"50 deg"'},
        "suspension": {
            "anisotropy": '{ from = "1e-7 rad/s", to = "1e-5 rad/s", count = 40, scale = "log" }',
            "axis": '["0 deg", "45 deg"]',
        },
        "sweep": {
            "motion": '"averaged"',
            "quantities": '["stalls", "azimuth"]',
            "times": '["6 h"]',
        },
    },
)
"""A job in which any number may be a list, a range or, for samples, a distribution."""
