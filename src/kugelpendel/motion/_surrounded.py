"""What the motions of a real pendulum have in common: what they were given."""

from __future__ import annotations

from typing import Any

from kugelpendel.motion._base import Motion
from kugelpendel.motion._surroundings import Surroundings
from kugelpendel.parameters import Bob, Drag, Drive, Launch, Pendulum, Scalars, Site, Suspension


class Surrounded(Motion):
    """A pendulum among the forces that act on it."""

    _around: Surroundings

    def _arguments(self) -> dict[str, Any]:
        around = self._around
        given = {
            "site": around.site, "drag": around.drag, "suspension": around.suspension,
            "bob": around.bob, "drive": around.drive,
        }  # fmt: skip
        acting = {name: value for name, value in given.items() if value is not None}
        return {"pendulum": around.pendulum, "launch": around.launch, **acting}

    @property
    def frequency(self) -> Scalars:
        """There is none that stays: forces change it. Raises AttributeError with the way out."""
        raise AttributeError(self._changes("frequency"))

    @property
    def precession(self) -> Scalars:
        """There is none that stays: forces change it. Raises AttributeError with the way out."""
        raise AttributeError(self._changes("precession"))

    def _changes(self, rate: str) -> str:
        return (
            f"{type(self).__name__} has no {rate} that stays: forces change it under way. Ask for "
            f"the times of its turning points, events('outer', …), for kp.ellipse(motion, t), or "
            f"for EnvelopeMotion.rates(t)."
        )

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
    def rotation(self) -> Scalars:
        """Rate of the ground about the vertical, rad/s, counter-clockwise seen from above."""
        return 0.0 if self.site is None else self.site.vertical_rotation

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single motion."""
        return self._around.shape
