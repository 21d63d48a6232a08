"""The exact motion, in closed form."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel import _core
from kugelpendel.errors import InvalidInput
from kugelpendel.motion._base import Motion
from kugelpendel.motion._kept import kept
from kugelpendel.motion._spectrum import Spectrum
from kugelpendel.motion._times import (
    check_memory,
    check_out,
    checked_count,
    checked_grid,
    checked_times,
    motion_shape,
)
from kugelpendel.parameters import (
    Launch,
    Numbers,
    Pendulum,
    Scalar,
    Scalar_co,
    column,
    require_given,
)


@final
class ExactMotion(Motion[Scalar_co]):
    """The ideal spherical pendulum from any launch, at any time: no integration, no drift.

    Ellipses of any size, libration and rotation in a plane, cones, paths above the support and over
    the top, the separatrix and rest are one closed form. Arrays in the pendulum or the launch
    broadcast to an ensemble.

    Parameters
    ----------
    pendulum
        What swings.
    launch
        Position and velocity at t = 0.

    Raises
    ------
    InvalidInput
        For a single motion whose launch does not lie on the pendulum's sphere or is not finite. In
        an ensemble such a case gives NaN everywhere, and `reason` says why.

    Notes
    -----
    Error of a position, as a fraction of the length: at most 3 (spread + 4e-16), where spread is
    how far the position moves when the inputs change by half a unit in the last place; relative
    error of frequency and precession: 4e-16, down to ellipses of 1e-9 l (tests/reference). The
    inputs are taken as exact binary numbers and the phase is reduced in twice the working
    precision, so the error does not grow with the time beyond what spread does.
    Source: Whittaker, Analytical Dynamics, §55; this project's form of it is in
    crates/kugelpendel/src.
    The motion is that of a rod: where `goes_slack` is true, a thread would leave the sphere.
    """

    @overload
    def __init__(
        self: ExactMotion[float], pendulum: Pendulum[float], launch: Launch[float]
    ) -> None: ...

    @overload
    def __init__(
        self: ExactMotion[Scalar],
        pendulum: Pendulum[Scalar] | Pendulum[float],
        launch: Launch[Scalar] | Launch[float],
    ) -> None: ...

    def __init__(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
    ):
        require_given("ExactMotion", pendulum, launch)
        self._pendulum = pendulum
        self._launch = launch
        self._shape = motion_shape(pendulum, launch)
        self._motions = _core.ExactMotions(
            self._count,
            [column(value, self._shape) for value in pendulum.values],
            launch.kind,
            launch.columns(self._shape),
        )
        self._refuse_bad()

    if TYPE_CHECKING:  # one of an ensemble may be a single motion: its type knows its class alone

        def __getitem__(self, key: Any) -> ExactMotion: ...
        def __iter__(self) -> Iterator[ExactMotion]: ...

    def _arguments(self) -> dict[str, Any]:
        return {"pendulum": self._pendulum, "launch": self._launch}

    @property
    def pendulum(self) -> Pendulum[Scalar_co] | Pendulum[float]:
        """The pendulum as it was given."""
        return self._pendulum

    @property
    def launch(self) -> Launch[Scalar_co] | Launch[float]:
        """Position and velocity at t = 0, as they were given."""
        return self._launch

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the ensemble; () for a single motion."""
        return self._shape

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s: all of them."""
        return (-np.inf, np.inf)

    @property
    def trust(self) -> str:
        """A sentence on where the motion holds."""
        return "Everywhere and for ever, as far as the inputs are known."

    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3).

        t in s, any times, negative too. Raises InvalidInput where t is not finite.
        """
        times = self._times(t, 3)
        return self._shaped(self._motions.position(times.ravel()), *times.shape, 3)

    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3); t and errors as in `position`."""
        times = self._times(t, 3)
        return self._shaped(self._motions.velocity(times.ravel()), *times.shape, 3)

    def sample(self, start: float, step: float, count: int, out: Numbers | None = None) -> Numbers:
        """Positions at start + step·k, k = 0 … count − 1: m, shape (*shape, count, 3).

        The fast path; the sum is taken exactly, not rounded to a binary time first. `out`, a
        C-contiguous float64 array of that shape, is filled and returned in place of a new one: to
        be handed new memory takes about as long as the positions themselves. Raises InvalidInput
        for a step of zero, numbers that are not finite, a negative count, more samples than fit
        into memory, and an `out` that does not fit.
        """
        size = checked_grid(start, step, count, 3 * self._count)
        if out is not None:
            check_out(out, (*self._shape, size, 3))
            self._motions.sample_into(float(start), float(step), out.reshape(-1))
            return out
        return self._shaped(self._motions.sample(float(start), float(step), size), size, 3)

    def tension(self, t: ArrayLike) -> Numbers:
        """Pull of the thread, N: shape (*shape, *t.shape); t and errors as in `position`.

        Negative where a thread would be slack and only a rod holds the motion: Olsson (1981),
        eq. (5a).
        """
        times = self._times(t, 1)
        return self._shaped(self._motions.tension(times.ravel()), *times.shape)

    @kept
    def frequency(self) -> Scalar_co:
        """ω, rad/s: of the swing, in the frame that turns with the precession.

        π/T, T the time between highest points; 0 on the separatrix. In a vertical plane over the
        top, of the revolutions: 2π/T. This is not the rate of the azimuth.
        """
        return self._constant(self._motions.frequency())

    @kept
    def period(self) -> Scalar_co:
        """2π/ω, s: there and back, or once round a vertical circle; infinite on the separatrix."""
        return self._constant(self._motions.swing_period())

    @kept
    def precession(self) -> Scalar_co:
        """Ω, rad/s, positive counter-clockwise seen from above: of the ellipse's major axis.

        (apsidal_angle − π)/radial_period for counter-clockwise motion; 0 in a vertical plane. Full
        relative accuracy however small the ellipse. This is not the azimuth's own mean rate, which
        is the precession plus or minus the frequency. To first order Olsson (1981), eq. (25).
        """
        return self._constant(self._motions.precession())

    @kept
    def radial_period(self) -> Scalar_co:
        """T, s: from one highest (outer) turning point to the next, half a swing to and fro.

        On a cone the limit of small oscillations about it; infinite on the separatrix; in a
        vertical plane over the top, of one revolution.
        """
        return self._constant(self._motions.radial_period())

    @kept
    def apsidal_angle(self) -> Scalar_co:
        """Azimuth from one highest turning point to the next, rad, signed like the motion.

        π in a vertical plane, 2π over the top in it.
        """
        return self._constant(self._motions.apsidal_angle())

    @kept
    def apsis_time(self) -> Scalar_co:
        """First time ≥ 0 at a highest turning point, s; infinite on the separatrix."""
        return self._constant(self._motions.apsis_time())

    @kept
    def apsis_azimuth(self) -> Scalar_co:
        """Azimuth at that time, rad in (−π, π]; 0 on the separatrix and at rest."""
        return self._constant(self._motions.apsis_azimuth())

    @kept
    def energy(self) -> Scalar_co:
        """Kinetic and potential, J/kg, from the lowest point of the sphere."""
        return self._constant(self._motions.energy())

    @kept
    def angular_momentum(self) -> Scalar_co:
        """x·vy − y·vx, m²/s, positive counter-clockwise seen from above."""
        return self._constant(self._motions.angular_momentum())

    @kept
    def turning_radii(self) -> Numbers:
        """Distance from the axis at the highest and at the lowest turning point, m: (*shape, 2)."""
        return self._constant(self._motions.turning_radii(), 2)

    @kept
    def turning_heights(self) -> Numbers:
        """Height above the lowest point at the highest and lowest turning point, m: (*shape, 2)."""
        return self._constant(self._motions.turning_heights(), 2)

    @kept
    def tension_range(self) -> Numbers:
        """Smallest and largest pull of the thread on the whole path, N: (*shape, 2)."""
        return self._constant(self._motions.tension_range(), 2)

    @property
    def goes_slack(self) -> bool | NDArray[np.bool_]:
        """Whether a thread would go slack somewhere on the path (tension below zero)."""
        slack = np.asarray(self.tension_range[..., 0] < 0)
        slack.flags.writeable = False
        return bool(slack) if self._shape == () else slack

    @kept
    def slack_time(self) -> Scalar_co:
        """First time ≥ 0 at which a thread goes slack, s; infinite if it never does."""
        return self._constant(self._motions.slack_time())

    def spectrum(self, n: int) -> Spectrum:
        """The exact harmonics up to the order 2n − 1, all of them from one formula.

        Raises InvalidInput for an n that is not a whole number ≥ 1, and for a single motion on the
        separatrix.
        """
        n = checked_count(n, 1, "The count n of pairs of harmonics")
        check_memory(n, 9 * self._count)
        (order, frequency, amplitude), (order_z, frequency_z, amplitude_z), problem = (
            self._motions.spectrum(n)
        )
        if self._shape == () and problem:
            raise InvalidInput.told(problem)
        plan, vertical = (*self._shape, 2 * n), (*self._shape, n + 1)
        return Spectrum(
            order.reshape(plan),
            frequency.reshape(plan),
            amplitude.reshape(plan),
            order_z.reshape(vertical),
            frequency_z.reshape(vertical),
            amplitude_z.reshape(vertical),
        )

    @property
    def amplitude(self) -> Scalar_co:
        """The outer turning radius, m, or the length where the path rises above the support.

        What errors of position are given as a fraction of.
        """
        return self._constant(self._motions.amplitude())

    def apsidal_times(self, until: float, most: int) -> Numbers:
        """Times of outer turning points of a single motion, s, evenly spread up to `until`.

        At most so many; none at rest, on the separatrix, or when the first comes too late.
        """
        return self._motions.apsidal_times(until, most)

    def turned(self, times: ArrayLike) -> Numbers:
        """By how much a single motion's outer turning points have moved round since the first, rad.

        `times` are some of theirs, s: shape (n,). Counter-clockwise seen from above, unwrapped by
        half turns, or by whole ones for a path over the top whose highest points are closer to it.
        """
        asked = self._times(times, 3)
        x, y, _ = self.position(asked).T
        return self._motions.turned(asked, np.arctan2(y, x))

    @property
    def comparison_swing(self) -> float:
        """A swing of a single motion as comparisons count them, s: small swings' where ω = 0."""
        return self._motions.comparison_swing()

    def comparison_count(self, duration: float) -> int:
        """At how many evenly spread times a comparison over so many s shows its largest error."""
        return self._motions.comparison_count(duration)

    def ellipse_rates(self, a: ArrayLike, b: ArrayLike) -> Numbers:
        """What the formulas for small ellipses are judged by: shape (*shape, 7).

        a and b are the turning radii, m, between which the motions were launched. Precession and
        frequency in rad/s, a/l and b/l, the relative errors of (25) and (26), and 1 where the
        ellipse is so small that every formula is exact.
        """
        columns = [column(np.asarray(r, dtype=np.float64), self._shape) for r in (a, b)]
        return self._shaped(self._motions.ellipse_rates(columns), 7)

    def launch_ellipse(self) -> Numbers:
        """Semi-axes a and b, m, and azimuth of the major axis, rad, at the launch: (*shape, 3).

        b and the azimuth as in `kp.ellipse`, for many motions at once.
        """
        return self._shaped(self._motions.ellipses(), 3)

    def summary(self) -> tuple[Any, ...]:
        """What `kp.IdealSummary.of` is made of, for a single motion."""
        return self._motions.summary()

    def _find_events(
        self, kind: str, value: float, between: tuple[float, float], most: int
    ) -> Numbers:
        return self._motions.events(kind, value, between, most)

    def _times(self, t: ArrayLike, numbers_each: int) -> Numbers:
        return checked_times(t, numbers_each * self._count)

    def _shaped(self, flat: Numbers, *tail: int) -> Numbers:
        return flat.reshape((*self._shape, *tail))
