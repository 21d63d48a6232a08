"""Olsson's (20) with (25) and (26): the turning ellipse."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, final, overload

from kugelpendel.motion.approximations._harmonic import HarmonicMotion
from kugelpendel.parameters import Launch, Pendulum, Scalar, Scalar_co


@final
class OlssonMotion(HarmonicMotion[Scalar_co]):
    """The turning ellipse: Olsson (1981), eq. (20), its Ω from (25) and its ω from (26).

    Semi-axes are the launch's exact turning radii, z lies on the sphere; no harmonics but the
    first. Raises InvalidInput where the path rises above the support; in an ensemble such a case
    is NaN.
    """

    _law = "olsson"

    @overload
    def __init__(
        self: OlssonMotion[float], pendulum: Pendulum[float], launch: Launch[float]
    ) -> None: ...

    @overload
    def __init__(
        self: OlssonMotion[Scalar],
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

        def __getitem__(self, key: Any) -> OlssonMotion: ...
        def __iter__(self) -> Iterator[OlssonMotion]: ...

    @property
    def trust(self) -> str:
        """A sentence that says where the motion holds."""
        return (
            "Small ellipses: Ω is low by a relative (7/32)(a² + b²)/l², and the shape lacks "
            "harmonics of relative size (a² + b²)/l²."
        )
