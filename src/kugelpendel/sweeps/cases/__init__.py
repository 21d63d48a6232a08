"""What varies, and the cases of a sweep from their index."""

from kugelpendel.sweeps.cases._checks import MOST_CASES as MOST_CASES
from kugelpendel.sweeps.cases._checks import where as where
from kugelpendel.sweeps.cases._cost import bytes_kept as bytes_kept
from kugelpendel.sweeps.cases._cost import core_seconds as core_seconds
from kugelpendel.sweeps.cases._cost import tried_core_seconds as tried_core_seconds
from kugelpendel.sweeps.cases._cost import usual_chunk as usual_chunk
from kugelpendel.sweeps.cases._laws import Law as Law
from kugelpendel.sweeps.cases._laws import Listed as Listed
from kugelpendel.sweeps.cases._laws import Normal as Normal
from kugelpendel.sweeps.cases._laws import Spaced as Spaced
from kugelpendel.sweeps.cases._laws import Uniform as Uniform
from kugelpendel.sweeps.cases._pendulums import UNITS as UNITS
from kugelpendel.sweeps.cases._pendulums import assembled as assembled
from kugelpendel.sweeps.cases._pendulums import motions as motions
from kugelpendel.sweeps.cases._sweep import Sweep as Sweep
