"""How it moves: every motion has the one interface of `Motion`."""

from kugelpendel.motion._base import EventKind as EventKind
from kugelpendel.motion._base import Motion as Motion
from kugelpendel.motion._budget import CAUSES as CAUSES
from kugelpendel.motion._budget import PrecessionBudget as PrecessionBudget
from kugelpendel.motion._budget import Stretch as Stretch
from kugelpendel.motion._envelope import EnvelopeMotion as EnvelopeMotion
from kugelpendel.motion._exact import ExactMotion as ExactMotion
from kugelpendel.motion._problems import Problems as Problems
from kugelpendel.motion._problems import Reasons as Reasons
from kugelpendel.motion._real import RealMotion as RealMotion
from kugelpendel.motion._spectrum import Spectrum as Spectrum
from kugelpendel.motion._walk import AskedEvent as AskedEvent
from kugelpendel.motion._walk import Leg as Leg
from kugelpendel.motion._walk import Passages as Passages
from kugelpendel.motion._walk import SteppedMotion as SteppedMotion
from kugelpendel.motion._walk import Walk as Walk
from kugelpendel.motion.approximations._cubic import CubicMotion as CubicMotion
from kugelpendel.motion.approximations._linear import LinearMotion as LinearMotion
from kugelpendel.motion.approximations._olsson import OlssonMotion as OlssonMotion
from kugelpendel.motion.approximations._plane import PlaneMotion as PlaneMotion
from kugelpendel.motion.approximations._series import SeriesMotion as SeriesMotion
