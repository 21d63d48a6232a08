"""From ellipses to the pendulum: models, intervals, and what cannot be known."""

from kugelpendel.tracks.fitting._fit import fit as fit
from kugelpendel.tracks.fitting._profile import profile as profile
from kugelpendel.tracks.fitting._results import Estimate as Estimate
from kugelpendel.tracks.fitting._results import FittedModel as FittedModel
from kugelpendel.tracks.fitting._results import Misfit as Misfit
from kugelpendel.tracks.fitting._results import PeriodTable as PeriodTable
from kugelpendel.tracks.fitting._results import Profile as Profile
from kugelpendel.tracks.fitting._results import Stiffening as Stiffening
from kugelpendel.tracks.fitting._results import TrackFit as TrackFit
from kugelpendel.tracks.fitting._results import Wobble as Wobble
