"""What was measured: recorded tracks of a pendulum, and what they say about it."""

from kugelpendel.tracks._track import Track as Track
