"""The one exception of this package."""


class InvalidInput(ValueError):
    """A value that makes no sense; the message says which, what it was, and the way out."""
