"""The report on a track as one self-contained page."""

from __future__ import annotations

import re
from base64 import b64encode
from importlib.metadata import version
from importlib.resources import files
from typing import TYPE_CHECKING

from kugelpendel.cli.fit.words import words

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kugelpendel.cli.fit.report import FitReport

_LAST_FIGURES = ("spectrum",)
"""Figures that belong to no section of their own."""

_WITHIN = re.compile("(?<=[0-9\u2070-\u2079\u00b9\u00b2\u00b3]) (?=1/|[°%]|[^\\W\\d_])|(?<=±) ")
"""The gap between a number and its unit, or before an error."""


def page(report: FitReport, figures: Mapping[str, bytes]) -> str:
    """The page as HTML, with the figures, PNG, in it.

    Jinja escapes whatever is filled in, so that names and headers out of a file are text there and
    never markup.
    """
    from jinja2 import Environment, StrictUndefined

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    source = files(__name__).joinpath("page.html.j2").read_text(encoding="utf-8")
    style = files(__name__).joinpath("page.css").read_text(encoding="utf-8")
    return environment.from_string(source).render(
        report=report,
        said=words(report.language),
        figures={name: _embedded(figure) for name, figure in figures.items()},
        last=[name for name in _LAST_FIGURES if name in figures],
        style=style,
        version=version("kugelpendel"),
        unbroken=_unbroken,
    )


def _unbroken(text: str) -> str:
    """Keep numbers on one line with their units."""
    return _WITHIN.sub("\u00a0", text)


def _embedded(figure: bytes) -> str:
    return f"data:image/png;base64,{b64encode(figure).decode()}"
