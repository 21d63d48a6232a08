"""Tracks of a known motion, spoilt as cameras and sensors spoil them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel.errors import InvalidInput
from kugelpendel.motion import Motion
from kugelpendel.observables import Told
from kugelpendel.parameters import Numbers, as_array, one_number, require_type
from kugelpendel.tracks._asked import require, require_listener, whole
from kugelpendel.tracks._scipy import first_order
from kugelpendel.tracks._track import Track

Colour: TypeAlias = Literal["white", "slow", "t3"] | float

_FAR = 50.0
"""Outliers lie up to so many times the noise away, and at least ten."""

_MOST = 50_000_000


def synthesise(
    motion: Motion,
    duration: float,
    rate: float,
    *,
    start: float = 0.0,
    noise: float = 0.0,
    colour: Colour = "white",
    noise_ratio: float = 1.0,
    jitter: float = 0.0,
    gaps: Sequence[tuple[float, float]] = (),
    outliers: float = 0.0,
    tilt: float = 0.0,
    tilt_axis: float = 0.0,
    pixel: float | None = None,
    seed: int = 0,
    done: Callable[[int, int], None] | None = None,
) -> Track:
    """A track as a camera would have recorded it of this motion.

    Parameters
    ----------
    motion
        A single one, such as `RealMotion`.
    duration, start
        How long is recorded, from when, s; the times of the track begin at 0.
    rate
        Points a second.
    noise
        Standard deviation of each coordinate, m.
    colour
        "white"; "slow", which drifts as well: half of its variance is a first-order process with a
        memory of 60 s; "t3", with the tails of Student's distribution of three degrees; or the
        coefficient of a first-order process from point to point, in (−1, 1).
    noise_ratio
        By which the noise of x is larger than that of y; `noise` is then the geometric mean.
    jitter
        Share of the step by which each time is off at the most, up to 0.45; the times that
        the track says are the true ones.
    gaps
        First time and length, s, of stretches without points.
    outliers
        Share of points that lie elsewhere, by 10 to 50 times the noise, or up to a tenth of the
        reach of the track where there is no noise.
    tilt, tilt_axis
        Share by which the scale along an axis is shorter than across it, half of it on either side,
        and the azimuth of the axis in rad: what a camera sees that does not look straight down,
        and whose scale was taken in both directions.
    pixel
        Size of a pixel in m: places are whole pixels then, and the unit is "px".
    seed
        The same one gives the same track.
    done
        Told, now and then, how many of how many positions are worked out.

    Raises
    ------
    InvalidInput
        For what is of another type, ensembles, shares out of range, and durations and
        rates that make no track.
    MotionEnded
        Where the motion ends before its track.
    """
    way_out = "write kp.ExactMotion(pendulum, launch), for instance"
    require_type("What is recorded", motion, Motion, way_out=way_out)
    require_listener(done)
    given = {
        "duration": (duration, "s"), "rate": (rate, "1/s"), "start": (start, "s"),
        "noise": (noise, "m"), "noise_ratio": (noise_ratio, ""), "jitter": (jitter, ""),
        "outliers": (outliers, ""), "tilt": (tilt, ""), "tilt_axis": (tilt_axis, "rad"),
    }  # fmt: skip
    numbers = [one_number(value, name, unit) for name, (value, unit) in given.items()]
    duration, rate, start, noise, noise_ratio, jitter, outliers, tilt, tilt_axis = numbers
    pixel = None if pixel is None else one_number(pixel, "pixel", "m")
    seed = whole("seed", seed, 0, 2**53)
    shares = {"jitter": (jitter, 0.45), "outliers": (outliers, 0.5), "tilt": (abs(tilt), 0.5)}
    for name, (value, most) in shares.items():
        if not 0 <= value <= most:
            raise InvalidInput.of("synth_share", what=name, seen=value, most=most)
    sizes = {"duration": duration, "rate": rate, "noise_ratio": noise_ratio}
    if pixel is not None:
        sizes["pixel"] = pixel
    for name, value in sizes.items():
        if not 0 < value < np.inf:
            raise InvalidInput.of("synth_positive", what=name, seen=value)
    if not 0 <= noise < np.inf:
        raise InvalidInput.of("synth_positive", what="noise", seen=noise)
    if motion.shape != ():
        raise InvalidInput.of("synth_single", shape=str(motion.shape))
    if not 8 <= duration * rate <= _MOST:
        raise InvalidInput.of("synth_points", points=duration * rate, most=float(_MOST))
    random = np.random.default_rng(seed)
    count = int(duration * rate) + 1
    time = np.arange(count) / rate
    time[1:-1] += random.uniform(-jitter, jitter, count - 2) / rate
    keep = np.ones(count, dtype=bool)
    for begin, length in _stretches(gaps):
        keep &= (time < begin) | (time >= begin + length)
    place = Told(done, count).positions(motion, start + time)
    z: NDArray[np.complex128] = place[:, 0] + 1j * place[:, 1]
    z = z - 0.5 * tilt * np.exp(2j * tilt_axis) * z.conj()
    spoilt = np.stack([_noise(random, colour, time, rate) for _ in range(2)])
    stretch = noise * np.sqrt(np.array([noise_ratio, 1 / noise_ratio]))
    z = z + spoilt[0] * stretch[0] + 1j * spoilt[1] * stretch[1]
    far = random.random(count) < outliers
    reach = noise * _FAR if noise else 0.1 * float(np.abs(z).max())
    away = reach * random.uniform(0.2, 1.0, count) * np.exp(2j * np.pi * random.random(count))
    z = np.where(far, z + away, z)[keep]
    if pixel is None:
        return Track(time[keep], z.real, z.imag)
    return Track(time[keep], np.rint(z.real / pixel), np.rint(z.imag / pixel), unit="px")


def _stretches(gaps: ArrayLike) -> Numbers:
    """First time and length of each gap, shape (n, 2); raises InvalidInput for anything else."""
    pairs = as_array(gaps, "gaps", "s")
    is_right = pairs.size == 0 or (pairs.ndim == 2 and pairs.shape[1] == 2)
    way_out = "write [(start, length), …] in s"
    require(is_right, "gaps", gaps, "list of pairs of numbers", way_out)
    return pairs.reshape(-1, 2)


def _noise(random: np.random.Generator, colour: Colour, time: Numbers, rate: float) -> Numbers:
    """Noise with variance 1 at these times; the coloured kinds run from point to point."""
    count = len(time)
    if not isinstance(colour, (str, int, float)):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput.of("synth_colour", seen=f"{colour!r:.60}")
    if colour == "white":
        return random.standard_normal(count)
    if colour == "t3":
        return random.standard_t(3, count) / np.sqrt(3)
    if colour == "slow":
        drift = _first_order(random, count, float(np.exp(-1 / (60 * rate))))
        return np.sqrt(0.5) * (random.standard_normal(count) + drift)
    if isinstance(colour, str) or not -1 < colour < 1:
        raise InvalidInput.of("synth_colour", seen=f"{colour!r:.60}")
    return _first_order(random, count, float(colour))


def _first_order(random: np.random.Generator, count: int, memory: float) -> Numbers:
    """A first-order process with variance 1: each value is `memory` times the last, and new."""
    new = random.standard_normal(count)
    new[1:] *= np.sqrt(1 - memory**2)
    return first_order(new, memory)
