"""The user asked to stop."""


class Interrupted(KeyboardInterrupt):
    """An interruption that says in a sentence what is kept."""
