"""What the extras bring, and what is said where one is missing."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

from kugelpendel.errors._types import MissingExtra

EXTRAS = {
    "run": ("h5netcdf", "h5py", "matplotlib", "pandas", "pint", "pyarrow", "rich", "xarray"),
    "fit": (
        "defusedxml",
        "h5netcdf",
        "h5py",
        "jinja2",
        "matplotlib",
        "pandas",
        "pint",
        "pyarrow",
        "rich",
        "scipy",
        "xarray",
    ),
    "sweep": ("SALib", "matplotlib", "pint", "rich", "scipy", "xarray", "zarr"),
    "cluster": ("dask", "distributed"),
    "paper": ("markdown-it-py", "mpmath", "rich", "sympy"),
}
"""The packages of each extra in pyproject.toml."""

_IMPORTED = {"markdown-it-py": "markdown_it"}
"""The names under which packages are imported, where these are not their own."""


def require_extra(extra: str, what: str, *packages: str) -> None:
    """Raise MissingExtra where packages are missing, with all of them named at once.

    Parameters
    ----------
    extra
        That brings them, such as "run".
    what
        What needs them, such as "kugelpendel.plot".
    packages
        All of the extra unless some are named.
    """
    missing = [name for name in packages or EXTRAS[extra] if not _is_there(name)]
    if missing:
        *most, last = missing
        listed = f"{', '.join(most)} and {last}" if most else last
        kind = "missing_extras" if most else "missing_extra"
        raise MissingExtra.of(kind, missing=listed, what=what, extra=extra)


def with_extra(
    get: Callable[[str], Any], extra: str, what: str, *packages: str
) -> Callable[[str], Any]:
    """The `__getattr__` of a package whose names need an extra; for the rest as `require_extra`.

    Parameters
    ----------
    get
        Its own `__getattr__`, which imports.
    """

    def getattr_(name: str) -> Any:
        try:
            return get(name)
        except MissingExtra:
            raise
        except ImportError:
            require_extra(extra, what, *packages)
            raise

    return getattr_


def _is_there(name: str) -> bool:
    try:
        return find_spec(_IMPORTED.get(name, name)) is not None
    except (ImportError, ValueError):  # blocked by a finder, or set to None in sys.modules
        return False
