"""Figures of a recorded track: where it went, how its ellipse changed, what is left over."""

from kugelpendel.plot.tracks._course import course as course
from kugelpendel.plot.tracks._noise import correlations as correlations
from kugelpendel.plot.tracks._noise import profile as profile
from kugelpendel.plot.tracks._noise import spectrum as spectrum
from kugelpendel.plot.tracks._seen import seen as seen

__all__ = ["correlations", "course", "profile", "seen", "spectrum"]
