"""What was measured: recorded tracks of a pendulum, and what they say about it."""

from kugelpendel.tracks._ellipse_table import EllipseTable as EllipseTable
from kugelpendel.tracks._note import Note as Note
from kugelpendel.tracks._plan import Plan as Plan
from kugelpendel.tracks._plan import PlanRow as PlanRow
from kugelpendel.tracks._plan import plan as plan
from kugelpendel.tracks._synthesise import Colour as Colour
from kugelpendel.tracks._synthesise import synthesise as synthesise
from kugelpendel.tracks._track import Track as Track
from kugelpendel.tracks.fitting import Estimate as Estimate
from kugelpendel.tracks.fitting import FittedModel as FittedModel
from kugelpendel.tracks.fitting import Misfit as Misfit
from kugelpendel.tracks.fitting import PeriodTable as PeriodTable
from kugelpendel.tracks.fitting import Profile as Profile
from kugelpendel.tracks.fitting import Stiffening as Stiffening
from kugelpendel.tracks.fitting import TrackFit as TrackFit
from kugelpendel.tracks.fitting import Wobble as Wobble
from kugelpendel.tracks.fitting import fit as fit
from kugelpendel.tracks.fitting import profile as profile
from kugelpendel.tracks.read import read as read
from kugelpendel.tracks.reduction import ellipses as ellipses
from kugelpendel.tracks.reduction import residuals as residuals
from kugelpendel.tracks.reduction import tabulated as tabulated
