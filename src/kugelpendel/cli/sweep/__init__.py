"""kugelpendel sweep: many pendulums from one file, and what they come to."""
