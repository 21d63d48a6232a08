"""What one reads off a motion, and what one would read off an ideal one."""

from ._compare import Compared as Compared
from ._compare import Comparison as Comparison
from ._compare import compare as compare
from ._course import Course as Course
from ._ellipse import ellipse as ellipse
from ._ellipse import osculating_ellipse as osculating_ellipse
from ._measured import Rates as Rates
from ._measured import measured_rates as measured_rates
from ._olsson import precession_rate as precession_rate
from ._olsson import swing_frequency as swing_frequency
from ._shares import CAUSES as CAUSES
from ._shares import Shares as Shares
from ._shares import Stretch as Stretch
from ._validity import Validity as Validity
from ._validity import ValidityMap as ValidityMap
from ._validity import validity as validity
from ._validity import validity_map as validity_map
