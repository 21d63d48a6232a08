"""The ellipse that a bob runs through at the moment."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.motion import EnvelopeMotion, ExactMotion, Motion, RealMotion
from kugelpendel.parameters import Launch, Numbers, Pendulum, Scalars


def ellipse(motion: Motion, t: ArrayLike) -> tuple[Numbers, Numbers, Numbers]:
    """Semi-axes and azimuth of the ideal motion with the place and velocity of each time.

    Parameters
    ----------
    motion
        Any.
    t
        s.

    Returns
    -------
    a, b, azimuth: shapes (*motion.shape, *t.shape). a and b are turning radii, m, b positive where
    the ellipse is run through counter-clockwise seen from above. The azimuth is that of the major
    axis, rad, counter-clockwise from x: at the earliest time towards the turning point nearest to
    the bob, then continuous modulo π along the times, which must follow close enough for the axis
    to turn by less than 90° from one to the next. NaN where the bob is off its sphere.

    Notes
    -----
    Osculating, not averaged: under forces a, b and the azimuth waver within a swing by the change
    that these make in it. Where the motion has a site, the ellipse is that of the plane at rest
    (velocity plus Ω_z × r): a bob let go at rest on the turning Earth runs through one.
    """
    times = np.asarray(t, dtype=np.float64)
    pendulum, rotation = motion.pendulum, 0.0
    if isinstance(motion, RealMotion | EnvelopeMotion):
        pendulum = motion.effective_pendulum
        if motion.site is not None:
            rotation = motion.site.vertical_rotation
    place, velocity = motion.position(times), motion.velocity(times)
    return osculating_ellipse(place, velocity, pendulum, rotation, times)


def osculating_ellipse(
    place: Numbers, velocity: Numbers, pendulum: Pendulum, rotation: Scalars, times: Numbers
) -> tuple[Numbers, Numbers, Numbers]:
    """As `ellipse`, of positions and velocities that are known already.

    Parameters
    ----------
    place, velocity
        m, m/s, shape (*shape, *times.shape, 3).
    pendulum
        The point mass that moves like the bob.
    rotation
        Ω_z of the ground, rad/s; 0 where it does not turn.
    times
        s.
    """
    shape = place.shape[: place.ndim - 1 - times.ndim]
    tail = (1,) * times.ndim
    turn = np.broadcast_to(rotation, shape).reshape((*shape, *tail))
    x, y = place[..., 0], place[..., 1]
    velocity = velocity + np.stack([-turn * y, turn * x, np.zeros_like(x)], axis=-1)
    # Rounding of the position alone is more than a launch allows beside the small speed of a
    # turning point.
    along = (velocity * place).sum(axis=-1) / np.square(place).sum(axis=-1)
    velocity = velocity - along[..., np.newaxis] * place
    columns = (np.broadcast_to(value, shape) for value in pendulum.values)
    each = Pendulum(*(column.reshape((*shape, *tail, 1)) for column in columns))
    ideal = ExactMotion(each, Launch.state(place[..., np.newaxis, :], velocity[..., np.newaxis, :]))
    radii = ideal.turning_radii[..., 0, :]
    sense = np.where(np.asarray(ideal.angular_momentum)[..., 0] < 0, -1.0, 1.0)
    until = np.asarray(ideal.apsis_time)[..., 0]
    azimuth = np.asarray(ideal.apsis_azimuth)[..., 0]
    azimuth = azimuth - np.asarray(ideal.precession)[..., 0] * until
    behind = np.asarray(ideal.frequency)[..., 0] * until > np.pi / 2
    azimuth = np.where(behind, azimuth - np.pi, azimuth)
    return radii[..., 0], sense * radii[..., 1], _continuous(azimuth, times)


def _continuous(azimuth: Numbers, times: Numbers) -> Numbers:
    """The same axes, by whole half turns from one time to the next."""
    if times.size < 2:
        return azimuth
    order = np.argsort(times, axis=None)
    rows = azimuth.reshape((-1, times.size))
    followed = np.empty_like(rows)
    followed[:, order] = np.unwrap(rows[:, order], period=np.pi, axis=-1)
    return followed.reshape(azimuth.shape)
