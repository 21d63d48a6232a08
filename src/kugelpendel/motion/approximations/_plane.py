"""Olsson's (12): the exact equation in the plan view."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, final, overload

from kugelpendel.motion.approximations._integrated import IntegratedMotion
from kugelpendel.parameters import Launch, Pendulum, Scalar, Scalar_co


@final
class PlaneMotion(IntegratedMotion[Scalar_co]):
    """The exact law in x and y alone, integrated: Olsson (1981), eq. (12).

    As printed, the second term lacks a factor 1/l². Over 100 swings the error stays below 1e-12 l
    where the energy keeps the bob below 60° from the vertical, and below 2e-11 l where it keeps it
    below 89°, next to where the equation divides by zero; of 200 random launches each the worst had
    4.3e-13 l and 8.4e-12 l (tests/motion/approximations/test_integrated.py). Where the bob reaches
    the height of the support `span` ends. Raises InvalidInput for a launch on the upper half of the
    sphere; in an ensemble such a case is NaN.
    """

    _equation = "plane"

    @overload
    def __init__(
        self: PlaneMotion[float], pendulum: Pendulum[float], launch: Launch[float]
    ) -> None: ...

    @overload
    def __init__(
        self: PlaneMotion[Scalar],
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

        def __getitem__(self, key: Any) -> PlaneMotion: ...
        def __iter__(self) -> Iterator[PlaneMotion]: ...

    @property
    def trust(self) -> str:
        """A sentence on where the motion holds."""
        return "Exact below the support's level; ends where the bob reaches it."
