"""What a sweep is: the same description, the same fingerprint; what makes no sense, a sentence."""

# What is refused stands in rows, whatever their length.
# ruff: noqa: E501

import copy
import pickle
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.sweeps import Listed, Normal, Spaced, Uniform
from kugelpendel.sweeps.cases import usual_chunk
from kugelpendel.sweeps.cases._cost import LEAF

GIVEN: dict[str, dict[str, Any]] = {
    "pendulum": {"length": 1.0},
    "launch": {"kind": "ellipse", "a": Spaced(0.1, 0.2, 3), "b": 0.0},
}


def made(changes: dict[str, dict[str, Any]] | None = None, **options: Any) -> kp.Sweep:
    given = copy.deepcopy(GIVEN)
    for name, entries in (changes or {}).items():
        given.setdefault(name, {}).update(entries)
    usual: dict[str, Any] = {"design": "grid", "motion": "exact", "quantities": ("period",)}
    return kp.Sweep(given, **{**usual, **options})


def test_it_comes_back_from_json_and_pickle() -> None:
    sweep = made({"launch": {"b": Listed((0.0, 0.1))}}, quantities=("azimuth",), times=(1.0, 2.0))
    for again in (kp.Sweep.from_json(sweep.as_json()), pickle.loads(pickle.dumps(sweep))):
        assert again == sweep
        assert hash(again) == hash(sweep)
        assert again.digest == sweep.digest
        assert again.names == ("launch.a", "launch.b")


def test_equal_descriptions_have_one_fingerprint() -> None:
    one = made({"pendulum": {"length": 1, "gravity": 9.8}})
    other = made({"pendulum": {"gravity": 9.8, "length": 1.0}})
    assert one == other
    assert one.digest == other.digest
    for changed in (
        made({"pendulum": {"length": 1.0 + 2**-52, "gravity": 9.8}}),
        made({"pendulum": {"gravity": 9.8}}, quantities=("frequency",)),
        made({"pendulum": {"gravity": 9.8}}, keep=("moments",)),
    ):
        assert changed.digest != one.digest
        assert changed != one


def test_chunks_are_no_part_of_it() -> None:
    one, other = made(chunk=4), made()
    assert one == other
    assert one.digest == other.digest
    assert pickle.loads(pickle.dumps(one)).chunk == 4


def test_the_usual_chunk_takes_about_a_second() -> None:
    for seconds in (0.3e-6, 1e-5, 1e-3, 0.1):
        chunk = usual_chunk(made(), seconds)
        assert chunk & (chunk - 1) == 0
        assert 0.5 <= chunk * seconds <= 2.0
    many = made(quantities=("azimuth",), times=tuple(np.arange(1.0, 1000.0)))
    assert usual_chunk(many, 1e-6) * 8 * 999 < 1 << 26  # bytes
    reduced = made(keep=("moments",))
    assert usual_chunk(reduced, 10.0) == LEAF


REFUSED: dict[str, tuple[Any, str]] = {
    "key": (lambda: made({"wind": {"speed": 1.0}}), "[wind] speed is not known in a sweep; there are pendulum, "),
    "key of a table": (lambda: made({"pendulum": {"lenght": 1.0}}), "[pendulum] lenght is not known in a sweep; there are length, gravity, mass."),
    "key of a launch": (lambda: made({"launch": {"theta": 1.0}}), "[launch] theta is not known in a sweep; there are a, b, azimuth."),
    "word": (lambda: made(design="lattice"), "design must be one of 'grid', 'sample', 'sobol', but it is 'lattice'."),
    "kind": (lambda: made({"launch": {"kind": "circle"}}), "[launch] kind must be one of 'ellipse', "),
    "missing": (lambda: kp.Sweep({"launch": {"kind": "ellipse"}}, "grid", "exact", ("period",)), "A sweep needs [pendulum] length; "),
    "missing of a launch": (lambda: kp.Sweep({"pendulum": {"length": Listed((1.0,))}, "launch": {"kind": "ellipse", "a": 0.1}}, "grid", "exact", ("period",)), "A sweep needs [launch] b; "),
    "wrong for all": (lambda: made({"pendulum": {"length": -1.0}}), "The pendulum's length must be positive"),
    "empty list": (lambda: made({"launch": {"a": Listed(())}}), "The list of [launch] a is empty; "),
    "empty range": (lambda: made({"launch": {"a": Spaced(0.1, 0.1, 5)}}), "The range of [launch] a is empty: it goes from 0.1 to 0.1 with a count of 5; "),
    "range of one": (lambda: made({"launch": {"a": Spaced(0.1, 0.2, 1)}}), "The range of [launch] a is empty: it goes from 0.1 to 0.2 with a count of 1; "),
    "empty uniform": (lambda: made({"launch": {"a": Uniform(0.2, 0.1)}}, design="sample", count=5), "The range of [launch] a is empty: "),
    "logarithm": (lambda: made({"launch": {"a": Spaced(0.0, 0.1, 5, log=True)}}), "The range of [launch] a goes from 0 to 0.1 in logarithmic steps, "),
    "deviation": (lambda: made({"launch": {"b": Normal(0.0, 0.0)}}, design="sample", count=5), "The standard deviation of [launch] b must be positive, but it is 0; "),
    "not finite": (lambda: made({"pendulum": {"length": float("nan")}}), "[pendulum] length must be finite, but it is NaN."),
    "nothing varies": (lambda: made({"launch": {"a": 0.1}}), "Nothing varies in this sweep; "),
    "normal on a grid": (lambda: made({"launch": {"b": Normal(0.0, 0.1)}}), "[launch] b is distributed (normal), which a grid cannot count through; "),
    "no count of a range": (lambda: made({"launch": {"a": Spaced(0.1, 0.2)}}), "The range of [launch] a lacks a count: "),
    "count of a range": (lambda: made(design="sample", count=10), "The range of [launch] a has a count, which is for grids; "),
    "count of a grid": (lambda: made(count=10), "A grid counts itself, but a count of 10 is given; "),
    "count": (lambda: made({"launch": {"a": Uniform(0.1, 0.2)}}, design="sample", count=0), "count must be a whole number of at least 1, but it is 0."),
    "seed": (lambda: made(seed=-1), "seed must be a whole number of at least 0, but it is -1."),
    "chunk": (lambda: made(chunk=48), "The cases of a chunk must be a power of two of at least 1, but they are 48; "),
    "chunk of a reduction": (lambda: made(chunk=32, keep=("moments",)), "The cases of a chunk must be a power of two of at least 64, but they are 32; "),
    "power of two": (lambda: made({"launch": {"a": Uniform(0.1, 0.2)}}, design="sobol", count=100), "A Sobol design needs a power of two of base points, 2^30 at most, but the count is 100; take 64."),
    "keep": (lambda: made(keep=("all", "moments")), "keep must be 'all', or some of moments, quantiles, histograms, but it is all, moments."),
    "quantities": (lambda: made(quantities=()), "A sweep reads one quantity or more, "),
    "quantity": (lambda: made(quantities=("colour",)), "A sweep cannot read 'colour'; it reads "),
    "times": (lambda: made(quantities=("azimuth",)), '"azimuth" needs times; '),
    "forces": (lambda: made({"drag": {"linear": 1e-4}}), "An exact motion knows no forces, but drag is given; "),
    "too many": (lambda: made({"launch": {"a": Spaced(0.1, 0.2, 10**6), "b": Spaced(0.0, 0.1, 10**6)}}), "This sweep has 1e+12 cases, which take 111 h of one core or more, and 9e+03 GB; 1e+11 cases are the most. "),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name: str) -> None:
    make, sentence = REFUSED[name]
    with pytest.raises(kp.InvalidInput) as raised:
        make()
    assert str(raised.value).startswith(sentence)
    if raised.value.kind:
        said = {
            raised.value.sentence(lang, door)
            for lang in ("en", "de")
            for door in ("python", "file")
        }  # type: ignore[arg-type]
        assert len(said) >= 2
        for text in said:
            assert text.endswith(".")
        for lang in ("en", "de"):
            assert "kp." not in raised.value.sentence(lang, "file")


def test_a_case_that_is_not_there() -> None:
    with pytest.raises(kp.InvalidInput, match=r"^There is no case 3: the sweep has 3 cases"):
        made().case(3)
