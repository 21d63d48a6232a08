"""Generator of the reference motions in ``tests/reference/ideal.json``."""
