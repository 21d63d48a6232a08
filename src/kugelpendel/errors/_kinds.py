"""What can be wrong with what is given."""

from __future__ import annotations


def problem_kinds() -> dict[int, str]:
    """The word for each kind of problem, by the number that a motion's `status` has for it.

    Numbers and words stay what they are from one version to the next; 0, which is not among them,
    is a good case.
    """
    from kugelpendel import _core  # not before it is asked for: an error needs no compiled core

    return dict(_core.problem_kinds())
