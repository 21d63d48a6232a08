"""The exceptions of this package."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

from kugelpendel.errors._seen import Door, FileLine, Language, Seen, Told


class KugelpendelError(Exception):
    """The base of everything that this package raises on purpose.

    Parameters
    ----------
    sentence
        What was wrong, the value seen, and the way out, where no kind says it.
    kind
        A word for what is wrong that stays from one version to the next; "" for what only has a
        sentence.
    values
        What was seen.
    place
        Where, in front of the sentence, such as "job.toml: ", from the outermost on.
    """

    def __init__(
        self,
        sentence: str = "",
        *,
        kind: str = "",
        values: Sequence[Seen] = (),
        place: tuple[str | FileLine, ...] = (),
    ):
        super().__init__(sentence)
        self.kind = kind
        self.values = tuple(values)
        self.place = place

    @classmethod
    def of(cls, kind: str, /, **values: float | str | tuple[float, str]) -> Self:
        """An error of a kind, with the values seen: each a number, text, or (number, unit)."""
        seen = (
            Seen(name, *value) if isinstance(value, tuple) else Seen(name, value)
            for name, value in values.items()
        )
        return cls(kind=kind, values=tuple(seen))

    @classmethod
    def told(cls, problem: Told) -> Self:
        """An error as the core tells it."""
        kind, values = problem
        return cls(kind=kind, values=tuple(Seen(*value) for value in values))

    def sentence(self, language: Language = "en", door: Door = "python") -> str:
        """What was wrong, the value seen, and the way out.

        Parameters
        ----------
        language
            "en" or "de". What has no kind has one sentence, in the language of whoever wrote it.
        door
            "python" for a way out in Python, "file" for one in a job file.
        """
        place = "".join(p if isinstance(p, str) else p.said(language) for p in self.place)
        if not self.kind:
            return f"{place}{self.args[0]}"
        # Read with the first error only: most programs never need a sentence.
        from kugelpendel.errors._sentences import sentence

        return f"{place}{sentence(self.kind, self.values, language, door)}"

    def at(self, place: str | FileLine) -> Self:
        """The same error with its place in front of the sentence, such as "job.toml: "."""
        again = type(self)(
            *self.args, kind=self.kind, values=self.values, place=(place, *self.place)
        )
        again.__dict__.update({**self.__dict__, "place": again.place})
        return again

    def __str__(self) -> str:
        return self.sentence()

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), self.args, self.__dict__)


class InvalidInput(KugelpendelError, ValueError):
    """A value that makes no sense; the sentence says which, what it was, and the way out."""


class MotionEnded(KugelpendelError, ValueError):
    """A single motion was asked for times beyond its end; an ensemble has NaN there."""

    @property
    def time(self) -> float:
        """When it ended, s."""
        return next(float(seen.value) for seen in self.values if seen.name == "time")


class EventNotFound(KugelpendelError, ValueError):
    """An event did not come within the time in which it was looked for."""


class MissingExtra(KugelpendelError, ImportError):
    """Packages are not installed that an extra of this package brings."""

    @property
    def extra(self) -> str:
        """The extra to install, as in "run" for ``pip install 'kugelpendel[run]'``."""
        return next(str(seen.value) for seen in self.values if seen.name == "extra")


for _error in (KugelpendelError, InvalidInput, MotionEnded, EventNotFound, MissingExtra):
    _error.__module__ = "kugelpendel"  # what a traceback shows is the name to catch
