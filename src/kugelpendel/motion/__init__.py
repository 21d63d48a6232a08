"""How it moves: every motion has the one interface of `Motion`."""

from ._base import Motion as Motion
from ._exact import ExactMotion as ExactMotion
from ._spectrum import Spectrum as Spectrum
