"""Olsson's two results for small ellipses: first order, not the exact rates.

Source: M. G. Olsson, Spherical pendulum revisited, Am. J. Phys. 49, 531 (1981), eqs. (25), (26).
"""

# One number is array-like too, so overloads for it come first.
# pyright: reportOverlappingOverload=false

from __future__ import annotations

from math import prod
from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.parameters import (
    InvalidInput,
    Numbers,
    OneNumber,
    Pendulum,
    Scalars,
    as_numbers,
    common_shape,
    unfit,
)


@overload
def precession(
    a: OneNumber, b: OneNumber, length: OneNumber, gravity: OneNumber = ...
) -> float: ...
@overload
def precession(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike = ...
) -> Numbers: ...
def precession(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike = 9.80665
) -> Scalars:
    """Angular velocity of a small ellipse's major axis by (25): Ω = (3/8) ω0 ab/l².

    Parameters
    ----------
    a, b
        Semi-axes, m; the sign of ab is the sense, positive counter-clockwise seen from above.
    length, gravity
        Length of the pendulum, m, and gravity, m/s².

    Returns
    -------
    rad/s, in the common shape of the arguments.

    Raises
    ------
    InvalidInput
        For a single pendulum without a positive finite length and gravity, and semi-axes that are
        not finite. In arrays a bad case gives NaN.

    Notes
    -----
    First order: low by a relative (7/32)(a² + b²)/l² + …, which is 0.2 % at a = 0.1 l; the exact
    rate is `ExactMotion.precession`.
    """
    shape, columns = _checked(a, b, length, gravity)
    return _shaped(_core.olsson_precession(prod(shape), columns), shape)


@overload
def frequency(a: OneNumber, b: OneNumber, length: OneNumber, gravity: OneNumber = ...) -> float: ...
@overload
def frequency(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike = ...
) -> Numbers: ...
def frequency(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike = 9.80665
) -> Scalars:
    """Angular frequency of a small ellipse's swing by (26): ω = ω0 √(1 − (a² + b²)/8l²).

    Arguments, shape and errors as in `precession`; semi-axes beyond √8 l, where the formula has no
    value, are an InvalidInput, or NaN in arrays. rad/s; the exact frequency is
    `ExactMotion.frequency`.
    """
    shape, columns = _checked(a, b, length, gravity)
    found = _shaped(_core.olsson_frequency(prod(shape), columns), shape)
    if isinstance(found, float) and np.isnan(found):
        size = [float(axis[0] / columns[2][0]) for axis in columns[:2]]
        raise InvalidInput(
            f"The formula ω² = ω0² (1 − (a² + b²)/8l²) has no value at a = {size[0]} l, "
            f"b = {size[1]} l, length l = {columns[2][0]} m; it is meant for a, b ≪ l. Use "
            f"ExactMotion."
        )
    return found


def _checked(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike
) -> tuple[tuple[int, ...], list[Numbers]]:
    """The common shape, and columns a, b, length, gravity for the core."""
    pendulum = Pendulum(length, gravity)
    axes = as_numbers(a, "The semi-axis a", "m"), as_numbers(b, "The semi-axis b", "m")
    for name, axis in zip("ab", axes, strict=True):
        if isinstance(axis, float) and not np.isfinite(axis):
            raise InvalidInput(f"The semi-axis {name} must be finite, but it is {axis} m.")
    values = (*axes, pendulum.length, pendulum.gravity)
    try:
        shape = common_shape(values)
    except ValueError:
        raise unfit("a, b, length and gravity", values) from None
    return shape, [np.broadcast_to(value, shape).ravel() for value in values]


def _shaped(rates: Numbers, shape: tuple[int, ...]) -> Scalars:
    return float(rates[0]) if shape == () else rates.reshape(shape)
