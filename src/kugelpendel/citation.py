"""How to cite this package."""

from __future__ import annotations

from importlib.metadata import version
from typing import Literal

_YEAR = 2026
"""Of the release in CITATION.cff, which a test compares with what is said here."""

_TITLE = "kugelpendel: exact motion of the spherical pendulum"

_AUTHORS = "The kugelpendel authors"


def cite(form: Literal["text", "bibtex"] = "text") -> str:
    """How to cite this package and the paper whose law it extends.

    Parameters
    ----------
    form
        "text" for two sentences, "bibtex" for two entries.

    Raises
    ------
    InvalidInput
        For any other form.
    """
    from kugelpendel.parameters import InvalidInput

    number = version("kugelpendel")
    if not isinstance(form, str) or form not in ("text", "bibtex"):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput(f'A citation comes as "text" or as "bibtex", but not as {form!r:.60}.')
    if form == "text":
        return (
            f"{_AUTHORS}, {_TITLE}, version {number} ({_YEAR}). "
            f"M. G. Olsson, Spherical pendulum revisited, American Journal of Physics 49 (6), "
            f"531–534 (1981)."
        )
    return (
        f"@software{{kugelpendel,\n"
        f"  author = {{{{{_AUTHORS}}}}},\n"
        f"  title = {{{{{_TITLE}}}}},\n"
        f"  version = {{{number}}},\n"
        f"  year = {{{_YEAR}}}\n"
        f"}}\n\n"
        f"@article{{olsson1981,\n"
        f"  author = {{Olsson, M. G.}},\n"
        f"  title = {{Spherical pendulum revisited}},\n"
        f"  journal = {{American Journal of Physics}},\n"
        f"  volume = {{49}},\n"
        f"  number = {{6}},\n"
        f"  pages = {{531--534}},\n"
        f"  month = jun,\n"
        f"  year = {{1981}}\n"
        f"}}\n"
    )
