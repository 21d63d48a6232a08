"""The number of threads changes nothing, the portable arithmetic the last few bits only."""

import os
import platform
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

Results = dict[str, np.ndarray]
Run = Callable[..., Results]


@pytest.fixture(scope="module")
def run(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """The workload, in a process with this environment."""

    def run(**environment: str) -> Results:
        path = tmp_path_factory.mktemp("workload") / "results.npz"
        inherited = {k: v for k, v in os.environ.items() if k != "KUGELPENDEL_PORTABLE"}
        subprocess.run(
            [sys.executable, "-m", "tests.motion.workload", path],
            cwd=repository,
            env=inherited | environment,
            check=True,
        )
        with np.load(path) as file:
            return dict(file)

    return run


@pytest.fixture(scope="module")
def alone(run: Run) -> Results:
    return run(RAYON_NUM_THREADS="1")


@pytest.mark.parametrize("threads", ["2", "5"])
def test_any_number_of_threads(threads: str, alone: Results, run: Run) -> None:
    together = run(RAYON_NUM_THREADS=threads)
    assert together.keys() == alone.keys()
    for name, expected in alone.items():
        np.testing.assert_array_equal(together[name], expected, name)


def test_portable_arithmetic(alone: Results, run: Run) -> None:
    portable = run(RAYON_NUM_THREADS="2", KUGELPENDEL_PORTABLE="1")
    assert portable.keys() == alone.keys()
    for name, expected in alone.items():
        # Twice the error of one, 1e-14 (test_equations), of the largest number.
        scale = np.abs(expected[np.isfinite(expected)]).max()
        np.testing.assert_allclose(
            portable[name], expected, rtol=0, atol=2e-14 * scale, err_msg=name
        )
    if fused():
        grids = [name for name in alone if name.endswith("grid")]
        assert any((portable[name] != alone[name]).any() for name in grids)


def fused() -> bool:
    """Whether this processor fuses multiplication and addition, as NumPy sees it."""
    if platform.machine() == "aarch64":
        return True
    features = np._core._multiarray_umath.__cpu_features__  # pyright: ignore[reportAttributeAccessIssue]
    return bool(features.get("FMA3") and features.get("AVX2"))
