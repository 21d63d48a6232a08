"""Whether the formulas are printed as they stand in the paper, told where the paper is not at hand.

A digest of each printed formula is kept beside the derivation. `python -m
kugelpendel.paper.checks.printed_text` writes them anew, after a formula has been compared with the
paper; tests compare all of them with its text where that is present.
"""

from __future__ import annotations

import tomllib
from functools import cache
from hashlib import sha256
from importlib.resources import files

from kugelpendel.paper.derivation.graph import FORMULAS
from kugelpendel.paper.derivation.model import Formula

_NAME = "printed.toml"


def is_as_printed(one: Formula) -> bool:
    """Whether the formula's printed form is the one that was compared with the paper."""
    return _kept().get(one.label) == digest(one.printed)


def digest(latex: str) -> str:
    """Give the digest of a formula, whatever spaces it is written with."""
    return sha256("".join(latex.split()).encode()).hexdigest()[:16]


@cache
def _kept() -> dict[str, str]:
    text = (files("kugelpendel.paper.derivation") / _NAME).read_text(encoding="utf-8")
    kept: dict[str, str] = tomllib.loads(text)["printed"]
    return kept


def written() -> str:
    """Give the file of digests for the formulas as they are now."""
    lines = [f'"{one.label}" = "{digest(one.printed)}"' for one in FORMULAS if not one.is_ours]
    head = "# Digests of the formulas as the paper prints them; checks/printed_text.py writes this."
    return "\n".join([head, "", "[printed]", *lines, ""])


if __name__ == "__main__":
    print(written(), end="")
