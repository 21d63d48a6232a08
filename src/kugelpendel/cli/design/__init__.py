"""kugelpendel design: what a builder asks."""
