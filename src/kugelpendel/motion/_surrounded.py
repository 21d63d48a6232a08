"""What the motions of a real pendulum have in common: what they were given."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from kugelpendel.motion._surroundings import Surroundings
from kugelpendel.parameters import Bob, Drag, Drive, Launch, Pendulum, Scalars, Site, Suspension


class Surrounded:
    """A pendulum among the forces that act on it."""

    _around: Surroundings

    @property
    def pendulum(self) -> Pendulum:
        """What swings, as given."""
        return self._around.pendulum

    @property
    def launch(self) -> Launch:
        """Position and velocity at t = 0, as given."""
        return self._around.launch

    @property
    def site(self) -> Site | None:
        """Where it hangs; None for a ground that does not turn."""
        return self._around.site

    @property
    def drag(self) -> Drag | None:
        """Of the air; None for a vacuum."""
        return self._around.drag

    @property
    def suspension(self) -> Suspension | None:
        """None for a perfect one."""
        return self._around.suspension

    @property
    def bob(self) -> Bob | None:
        """None for a point mass."""
        return self._around.bob

    @property
    def drive(self) -> Drive | None:
        """None for a free pendulum."""
        return self._around.drive

    @property
    def effective_pendulum(self) -> Pendulum:
        """The point mass that moves like this bob."""
        return self._around.effective_pendulum

    @property
    def angular_frequency(self) -> Scalars:
        """ω0, rad/s: of infinitesimal swings, with the bob's correction."""
        return self.effective_pendulum.angular_frequency

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single motion."""
        return self._around.shape

    def _reasons(self, problems: Iterable[tuple[int, str]]) -> NDArray[np.str_]:
        sentences = [""] * self._around.count
        for index, sentence in problems:
            sentences[index] = sentence
        return np.array(sentences, dtype=np.str_).reshape(self.shape)
