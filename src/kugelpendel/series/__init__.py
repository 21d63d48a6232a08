"""The theory of the paper carried on: frequency, precession and harmonics to any even order."""

from ._functions import Harmonics as Harmonics
from ._functions import frequency as frequency
from ._functions import harmonics as harmonics
from ._functions import precession as precession
from ._polynomial import Polynomial as Polynomial

__all__ = ["Harmonics", "Polynomial", "frequency", "harmonics", "precession"]
