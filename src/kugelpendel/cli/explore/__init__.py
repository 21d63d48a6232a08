"""``kugelpendel explore``."""
