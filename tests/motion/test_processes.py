"""Motions in child processes: forked ones, whose threads do not come along, and spawned ones."""

import multiprocessing
import warnings
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp

PENDULUM = kp.Pendulum(1.0)
WIDTHS = np.linspace(0.1, 0.9, 3000)
TIMES = np.array([1.0, 2.0])


def positions(kind: str) -> Any:
    """Each on all processors: many motions, and many times of one."""
    launch = kp.Launch.ellipse(WIDTHS, 0.1)
    match kind:
        case "exact":
            return kp.ExactMotion(PENDULUM, launch).position(TIMES)
        case "long":
            return kp.ExactMotion(PENDULUM, kp.Launch.ellipse(0.3, 0.1)).sample(0.0, 0.1, 200_000)
        case "real":
            return kp.RealMotion(PENDULUM, launch, drag=kp.Drag(1e-3)).position(TIMES)
        case _:
            few = kp.Launch.ellipse(WIDTHS[:1000], 0.1)
            return kp.EnvelopeMotion(PENDULUM, few, drag=kp.Drag(1e-3)).position(TIMES)


KINDS = ("exact", "long", "real", "envelope")


def say(kind: str, queue: Any) -> None:
    queue.put(float(np.abs(positions(kind)).sum()))


def grandchild(kind: str, queue: Any) -> None:
    say(kind, queue)
    child = multiprocessing.get_context("fork").Process(target=say, args=(kind, queue))
    child.start()
    child.join()


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_children_move_alike(method: str) -> None:
    if method not in multiprocessing.get_all_start_methods():
        pytest.fail(f"this system has no {method}; say so here")
    here = {kind: float(np.abs(positions(kind)).sum()) for kind in KINDS}
    context: Any = multiprocessing.get_context(method)
    for kind in KINDS if method == "fork" else KINDS[:1]:
        queue = context.Queue()
        start = grandchild if method == "fork" else say
        child = context.Process(target=start, args=(kind, queue))
        with warnings.catch_warnings():
            # From Python 3.12 on a fork beside threads warns of just what is mended here.
            warnings.simplefilter("ignore", DeprecationWarning)
            child.start()
        try:
            said = [queue.get(timeout=60) for _ in range(2 if method == "fork" else 1)]
        finally:
            child.join(timeout=10)
            alive = child.is_alive()
            child.kill()
        assert not alive
        assert said == [here[kind]] * len(said), kind
