"""What one reads off a motion, and what one would read off an ideal one."""

from ._olsson import precession_rate as precession_rate
from ._olsson import swing_frequency as swing_frequency
