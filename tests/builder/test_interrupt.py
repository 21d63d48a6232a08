"""Ctrl-C ends a design at once, whatever it is at."""

import math
import signal
import time

import pytest

import kugelpendel as kp

SITE = kp.Site(math.radians(50.0))


@pytest.mark.parametrize("delay", [0.05, 0.3, 1.0])
def test_interrupted_within_a_fifth_of_a_second(delay: float) -> None:
    pendulum = kp.Pendulum(1.0, SITE.gravity)
    forces = kp.Forces(site=SITE, suspension=kp.Suspension(1e-6, 0.3, 1e-6),
                       drag=kp.Drag(1e-4), drive=kp.Drive(1e-5, phase=0.4))  # fmt: skip

    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    def design_until_stopped() -> None:
        # Half a turn of 28 000 swings, and a settled motion; again until the signal comes.
        for _ in range(1000):
            kp.design(pendulum, 0.05, forces=forces)

    before = signal.signal(signal.SIGALRM, stop)
    try:
        sent = time.perf_counter() + delay
        signal.setitimer(signal.ITIMER_REAL, delay)
        with pytest.raises(KeyboardInterrupt):
            design_until_stopped()
        late = time.perf_counter() - sent
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert late < 0.2
