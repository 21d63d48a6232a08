"""Which packages of an extra are not installed."""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, requires
from importlib.util import find_spec


def missing_of(extra: str) -> list[str]:
    """Name the packages of an extra that cannot be imported; each has the name of its module."""
    try:
        needed = requires("kugelpendel") or []
    except PackageNotFoundError:
        return []
    names = [
        re.split(r"[^\w-]", requirement)[0]
        for requirement in needed
        if re.search(rf"extra\s*==\s*['\"]{extra}['\"]", requirement)
    ]
    return [name for name in names if not _is_there(name)]


def _is_there(name: str) -> bool:
    try:
        return find_spec(name) is not None
    except (ImportError, ValueError):  # blocked, or half imported
        return False
