"""The turning ellipse with its harmonics, to any order of the series."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, final, overload

import numpy as np

from kugelpendel import _core, series
from kugelpendel.motion.approximations._harmonic import HarmonicMotion
from kugelpendel.parameters import InvalidInput, Launch, Numbers, Pendulum, Scalar, Scalar_co

_POWERS = _core.HarmonicMotions.powers()
"""How many powers of sin² ζ the core takes for each part of the figure."""


@final
class SeriesMotion(HarmonicMotion[Scalar_co]):
    """The paper's ansatz carried on: frequency, precession and harmonics to order n = 2, 4, …, 12.

    What is left out is of relative order (a/l)^(n+2); semi-axes are the launch's exact turning
    radii, z lies on the sphere.

    Warns (UserWarning) with the expected error where frequency or precession are wrong by more than
    1 %; see `expected`. Raises InvalidInput for an order that is odd or out of range, and where the
    path rises above the support; in an ensemble such a case is NaN.
    Source: `kugelpendel.series`.
    """

    _law = "olsson"  # until its own rates and figure take the place of the formulas'

    @overload
    def __init__(
        self: SeriesMotion[float],
        pendulum: Pendulum[float],
        launch: Launch[float],
        order: int = ...,
    ) -> None: ...

    @overload
    def __init__(
        self: SeriesMotion[Scalar],
        pendulum: Pendulum[Scalar] | Pendulum[float],
        launch: Launch[Scalar] | Launch[float],
        order: int = ...,
    ) -> None: ...

    def __init__(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
        order: int = 6,
    ):
        series.frequency(order)  # raises for an order that makes no sense
        if order > (limit := 2 * (_POWERS - 1)):
            raise InvalidInput(
                f"The order of a SeriesMotion can be {limit} at most, but it is {order}; use "
                f"order={limit}, or ExactMotion, which is right at every amplitude."
            )
        self._order = int(order)
        super().__init__(pendulum, launch)
        self._apsides = self.semi_axes
        self._motions = self._motions.with_figures(self._rows())
        self._expected = series.trusted(*self._relative(), self._order)
        if self._expected.warning is not None:
            warnings.warn(self._expected.warning, stacklevel=2)

    @property
    def expected(self) -> series.Trust:
        """How wrong the motion is expected to be, from the terms left out."""
        return self._expected

    @property
    def order(self) -> int:
        """Highest power of a/l and b/l together in the frequency."""
        return self._order

    if TYPE_CHECKING:  # one of an ensemble may be a single motion: its type knows its class alone

        def __getitem__(self, key: Any) -> SeriesMotion: ...
        def __iter__(self) -> Iterator[SeriesMotion]: ...

    def _arguments(self) -> dict[str, Any]:
        return {**super()._arguments(), "order": self._order}

    def _rows(self) -> Numbers:
        """Frequency and precession, rad/s, and the powers of P and of Q, m: a row for each case."""
        omega0 = np.asarray(self.pendulum.angular_frequency)
        alpha, beta = self._relative()
        rates = (series.frequency(self._order), series.precession(self._order))
        columns = [np.asarray(omega0 * rate(alpha, beta))[..., np.newaxis] for rate in rates]
        columns += self._figure(alpha, beta)
        rows = [np.broadcast_to(c, (*self.shape, c.shape[-1])) for c in columns]
        whole = np.concatenate(rows, axis=-1)
        return whole.reshape(self._count, whole.shape[-1])

    def _figure(self, alpha: Numbers, beta: Numbers) -> list[Numbers]:
        plan = series.harmonics(self._order).plan
        inner, outer = np.zeros((2, *self.shape, _POWERS))
        # cos nζ = cos ζ·p(σ), sin nζ = sin ζ·q(σ) for odd n, σ = sin² ζ, and for p and for q alike
        # p_{n+2} = (2 − 4σ) p_n − p_{n−2}.
        cos, sin = np.zeros((2, 2, _POWERS))
        cos[:, 0], sin[:, 0] = 1.0, (-1.0, 1.0)
        # The series counts from a highest point, the figure from a lowest: a factor i^{n−1}.
        for n in range(1, max(plan) + 1, 2):
            sign = 1.0 if n % 4 == 1 else -1.0
            ahead = np.asarray(plan[n](alpha, beta))[..., np.newaxis] if n in plan else 0.0
            back = np.asarray(plan[-n](alpha, beta))[..., np.newaxis] if -n in plan else 0.0
            inner += sign * (ahead - back) * cos[1]
            outer += sign * (ahead + back) * sin[1]
            cos, sin = (
                np.stack([p[1], 2 * p[1] - 4 * np.append(0.0, p[1][:-1]) - p[0]])
                for p in (cos, sin)
            )
        length = np.asarray(self.pendulum.length)[..., np.newaxis]
        return [length * inner, length * outer]

    def _relative(self) -> tuple[Numbers, Numbers]:
        # Those of the launch; the figure's own would follow them up to the order only.
        a, b = np.moveaxis(self._apsides, -1, 0)
        return a / self.pendulum.length, b / self.pendulum.length

    @property
    def trust(self) -> str:
        """A sentence on where the motion holds."""
        return (
            f"Ellipses well below the support: what is left out is of relative order "
            f"(a/l)^{self._order + 2}; see series.trusted."
        )
