"""What one reads off a motion, and what one would read off an ideal one."""

from kugelpendel.observables._apsides import Apsides as Apsides
from kugelpendel.observables._compare import Compared as Compared
from kugelpendel.observables._compare import Comparison as Comparison
from kugelpendel.observables._compare import compare as compare
from kugelpendel.observables._ellipse import Ellipse as Ellipse
from kugelpendel.observables._ellipse import ellipse as ellipse
from kugelpendel.observables._ellipse import osculating_ellipse as osculating_ellipse
from kugelpendel.observables._measured import Rates as Rates
from kugelpendel.observables._measured import measured_rates as measured_rates
from kugelpendel.observables._pieces import Told as Told
from kugelpendel.observables._portrait import Equilibrium as Equilibrium
from kugelpendel.observables._portrait import Orbit as Orbit
from kugelpendel.observables._portrait import Portrait as Portrait
from kugelpendel.observables._real_summary import Explanation as Explanation
from kugelpendel.observables._real_summary import Follower as Follower
from kugelpendel.observables._real_summary import RealSummary as RealSummary
from kugelpendel.observables._real_summary import Revolutions as Revolutions
from kugelpendel.observables._real_summary import explain as explain
from kugelpendel.observables._summary import IdealSummary as IdealSummary
from kugelpendel.observables._summary import Regime as Regime
from kugelpendel.observables._turning_points import TurningPoints as TurningPoints
from kugelpendel.observables._validity import LEVELS as LEVELS
from kugelpendel.observables._validity import Validity as Validity
from kugelpendel.observables._validity import ValidityMap as ValidityMap
from kugelpendel.observables._validity import validity as validity
from kugelpendel.observables._validity import validity_map as validity_map
