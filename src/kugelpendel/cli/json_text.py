"""Results as JSON, which has no word for what is infinite or not a number."""

from __future__ import annotations

import json
import math
from typing import Any, cast


def json_text(tables: dict[str, Any] | list[Any]) -> str:
    """Write tables, or a list of them, as indented JSON with a newline at the end.

    What is infinite or not a number becomes null, wherever it stands; the first key of a file of
    this package, "about", says what null means in it. Numbers of NumPy become those of Python.
    """
    return json.dumps(_sayable(tables), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _sayable(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _sayable(entry) for key, entry in cast("dict[str, Any]", value).items()}
    if isinstance(value, list | tuple):
        return [_sayable(entry) for entry in cast("list[Any]", value)]
    if hasattr(value, "tolist"):
        return _sayable(value.tolist())
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value
