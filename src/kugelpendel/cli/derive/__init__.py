"""kugelpendel derive: the derivation, and its check."""
