"""The one exception of this package."""


class InvalidInput(ValueError):
    """A value that makes no sense; the message says which, what it was, and the way out."""


InvalidInput.__module__ = "kugelpendel"  # what a traceback shows is the name to catch
