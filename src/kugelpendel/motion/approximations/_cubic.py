"""Olsson's (13): the equation of motion to third order."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, final, overload

from kugelpendel.motion.approximations._integrated import IntegratedMotion
from kugelpendel.parameters import Launch, Pendulum, Scalar, Scalar_co


@final
class CubicMotion(IntegratedMotion[Scalar_co]):
    """The law to third order in x, y, integrated without further approximation: Olsson's (13).

    Olsson (1981), eqs. (13a), (13b). Over 100 swings, to t = 628/ω0, the integration's error stays
    below 1e-12 l where the energy keeps the bob below 60° from the vertical: of 200 random launches
    the worst had 3.6e-13 l, against the same equation in fixed point
    (references/equations/cubic.py). Where the bob reaches the height of the support the motion
    would leave the sphere: `span` ends there. Raises InvalidInput for a launch on the upper half of
    the sphere; in an ensemble such a case is NaN.
    """

    _equation = "cubic"

    @overload
    def __init__(
        self: CubicMotion[float], pendulum: Pendulum[float], launch: Launch[float]
    ) -> None: ...

    @overload
    def __init__(
        self: CubicMotion[Scalar],
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

        def __getitem__(self, key: Any) -> CubicMotion: ...
        def __iter__(self) -> Iterator[CubicMotion]: ...

    @property
    def trust(self) -> str:
        """A sentence on where the motion holds."""
        return (
            "Small swings: the precession and the shift of the frequency are right to leading "
            "order only, off by a relative (a² + b²)/l²."
        )
