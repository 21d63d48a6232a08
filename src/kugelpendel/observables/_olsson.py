"""Olsson's two results for small ellipses."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters import InvalidInput, Pendulum, Scalars, as_numbers, common_shape, unfit


def precession_rate(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike = 9.80665
) -> Scalars:
    """Angular velocity of a small ellipse's major axis: Ω = (3/8) ω0 ab/l².

    Parameters
    ----------
    a, b
        m, semi-axes; the sign of ab is the sense, positive counter-clockwise seen from above.
    length, gravity
        m, m/s².

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
    rate is `ExactMotion.precession`. Source: M. G. Olsson, Am. J. Phys. 49, 531 (1981), eq. (25).
    """
    a, b, pendulum = _checked(a, b, length, gravity)
    with np.errstate(all="ignore"):
        return _finite(0.375 * np.multiply(np.multiply(a, b), pendulum.angular_frequency))


def swing_frequency(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike = 9.80665
) -> Scalars:
    """Angular frequency of a small ellipse's swing: ω = ω0 √(1 − (a² + b²)/8l²).

    Arguments, shape and errors as in `precession_rate`; semi-axes beyond √8 l, where the formula
    has no value, are an InvalidInput, or NaN in arrays. rad/s; the exact frequency is
    `ExactMotion.frequency`. Source: M. G. Olsson, Am. J. Phys. 49, 531 (1981), eq. (26).
    """
    a, b, pendulum = _checked(a, b, length, gravity)
    with np.errstate(all="ignore"):
        shift = (np.square(a) + np.square(b)) / 8
        if np.ndim(shift) == 0 and shift >= 1:
            raise InvalidInput(
                f"The formula ω² = ω0² (1 − (a² + b²)/8l²) has no value at a = {a} l, b = {b} l, "
                f"length l = {pendulum.length} m; it is meant for a, b ≪ l. Use ExactMotion."
            )
        return _finite(pendulum.angular_frequency * np.sqrt(1 - shift))


def _checked(
    a: ArrayLike, b: ArrayLike, length: ArrayLike, gravity: ArrayLike
) -> tuple[Scalars, Scalars, Pendulum]:
    """The semi-axes in lengths, so that no square of theirs underflows before it must."""
    pendulum = Pendulum(length, gravity)
    axes = as_numbers(a, "The semi-axis a", "m"), as_numbers(b, "The semi-axis b", "m")
    for name, axis in zip("ab", axes, strict=True):
        if isinstance(axis, float) and not np.isfinite(axis):
            raise InvalidInput(f"The semi-axis {name} must be finite, but it is {axis} m.")
    values = (*axes, *pendulum.values[:2])
    try:
        common_shape(values)
    except ValueError:
        raise unfit("a, b, length and gravity", values) from None
    with np.errstate(all="ignore"):
        reduced = [np.divide(axis, pendulum.length) for axis in axes]
    return reduced[0], reduced[1], pendulum


def _finite(rate: Scalars) -> Scalars:
    """NaN for the bad cases of an array."""
    return float(rate) if np.ndim(rate) == 0 else np.where(np.isfinite(rate), rate, np.nan)
