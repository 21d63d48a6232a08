"""The ellipse that a bob runs through at the moment."""

from __future__ import annotations

from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.motion import Motion
from kugelpendel.parameters import Numbers, Pendulum, Scalars, as_array, require_type


class Ellipse(NamedTuple):
    """An ellipse in the plan view, or many of them: arrays of one shape.

    Attributes
    ----------
    a
        Outer turning radius, m.
    b
        Inner turning radius, m, positive where the ellipse is run through counter-clockwise seen
        from above.
    azimuth
        Of the major axis, rad, counter-clockwise from x.
    """

    a: Numbers
    b: Numbers
    azimuth: Numbers


def ellipse(motion: Motion, t: ArrayLike) -> Ellipse:
    """Semi-axes and azimuth of the ideal motion with the position and velocity of each time.

    Parameters
    ----------
    motion
        Any motion, or an ensemble.
    t
        Times in s.

    Returns
    -------
    a, b and azimuth by name, each of shape (*motion.shape, *t.shape). The azimuth is at the
    earliest time that towards the turning point nearest to the bob, then continuous modulo π along
    the times, which must follow close enough for the axis to turn by less than 90° from one to the
    next. NaN where the bob is off its sphere.

    Raises
    ------
    InvalidInput
        For what is no motion, and as `motion.position`.

    Notes
    -----
    Osculating, not averaged: under forces a, b and the azimuth waver within a swing by the change
    that these make in it; `EnvelopeMotion.semi_axes` and `azimuth` are the averages. Where the
    motion has a site, the ellipse is that of the plane at rest (velocity plus Ω_z × r): a bob let
    go at rest on the turning Earth runs through one.
    """
    require_type("The motion", motion, Motion, way_out="write kp.ExactMotion(pendulum, launch)")
    times = as_array(t, "The times", "s")
    place, velocity = motion.position(times), motion.velocity(times)
    return osculating_ellipse(place, velocity, motion.effective_pendulum, motion.rotation, times)


def osculating_ellipse(
    place: Numbers, velocity: Numbers, pendulum: Pendulum, rotation: Scalars, times: Numbers
) -> Ellipse:
    """As `ellipse`, of positions and velocities that are known already.

    Parameters
    ----------
    place, velocity
        Positions in m and velocities in m/s, shape (*shape, *times.shape, 3).
    pendulum
        The point mass that moves like the bob.
    rotation
        Ω_z of the ground, rad/s; 0 where it does not turn.
    times
        Times in s.
    """
    shape = place.shape[: place.ndim - 1 - times.ndim]
    columns = [
        np.ascontiguousarray(np.broadcast_to(value, shape).ravel())
        for value in (*pendulum.values, rotation)
    ]
    found = _core.osculating_ellipses(
        prod(shape), columns, place.ravel(), velocity.ravel(), times.ravel()
    )
    return Ellipse(*(values.reshape((*shape, *times.shape)) for values in found))
