"""kugelpendel synth: a track as a camera would have recorded it."""
