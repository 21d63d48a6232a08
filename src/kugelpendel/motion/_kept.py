"""A property that is worked out once."""

from __future__ import annotations

from typing import Any


class kept(property):  # noqa: N801 (it is used like `property`)
    """A property whose value is kept; unlike `functools.cached_property` it cannot be set.

    For values that cannot be changed either: floats, tuples, read-only arrays.
    """

    def __get__(self, instance: Any, owner: type | None = None) -> Any:
        """The value that was found when it was first asked for."""
        if instance is None:
            return self
        values: dict[property, Any] = instance.__dict__.setdefault("_kept", {})
        if self not in values:
            values[self] = super().__get__(instance, owner)
        return values[self]
