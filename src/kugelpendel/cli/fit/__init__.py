"""kugelpendel fit: from a recorded track to the pendulum."""
