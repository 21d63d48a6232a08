"""Olsson's (16): the standing ellipse of infinitesimal swings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, final, overload

from kugelpendel.motion.approximations._harmonic import HarmonicMotion
from kugelpendel.parameters import Launch, Pendulum, Scalar, Scalar_co


@final
class LinearMotion(HarmonicMotion[Scalar_co]):
    """The standing ellipse: frequency ω0, no precession. Olsson (1981), eq. (16).

    Semi-axes are the launch's exact turning radii, z lies on the sphere. Raises InvalidInput where
    the path rises above the support; in an ensemble such a case is NaN.
    """

    _law = "linear"

    @overload
    def __init__(
        self: LinearMotion[float], pendulum: Pendulum[float], launch: Launch[float]
    ) -> None: ...

    @overload
    def __init__(
        self: LinearMotion[Scalar],
        pendulum: Pendulum[Scalar] | Pendulum[float],
        launch: Launch[Scalar] | Launch[float],
    ) -> None: ...

    def __init__(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
    ):
        super().__init__(pendulum, launch)  # only a class of its own can be told its scalars

    if TYPE_CHECKING:  # one of an ensemble may be a single motion: its type knows its class alone

        def __getitem__(self, key: Any) -> LinearMotion: ...
        def __iter__(self) -> Iterator[LinearMotion]: ...

    @property
    def trust(self) -> str:
        """A sentence that says where the motion holds."""
        return (
            "Infinitesimal swings, for few of them: the phase is off by (a² + b²)/16l² and the "
            "azimuth by (3/8)ab/l² in each radian of swing."
        )
