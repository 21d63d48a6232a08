"""How it moves: every motion has the one interface of `Motion`."""

from ._base import Motion as Motion
from ._cubic import CubicMotion as CubicMotion
from ._envelope import EnvelopeMotion as EnvelopeMotion
from ._envelope import TurningRates as TurningRates
from ._exact import ExactMotion as ExactMotion
from ._linear import LinearMotion as LinearMotion
from ._olsson import OlssonMotion as OlssonMotion
from ._plane import PlaneMotion as PlaneMotion
from ._pumping import refuse_pumping as refuse_pumping
from ._real import RealMotion as RealMotion
from ._series import SeriesMotion as SeriesMotion
from ._spectrum import Spectrum as Spectrum
