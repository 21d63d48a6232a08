"""The command starts at once: nothing heavy is imported before it is needed."""

import importlib.metadata
import subprocess
import sys

import pytest

HEAVY = {"numpy", "pint", "matplotlib", "xarray", "pandas", "pyarrow", "h5netcdf", "rich", "scipy"}


@pytest.mark.parametrize(
    "arguments",
    [
        ["--help"],
        ["run", "--help"],
        ["compare", "--help"],
        ["validity", "--help"],
        ["--version"],
        [],
    ],
)
def test_nothing_heavy_is_imported(arguments: list[str]) -> None:
    program = (
        "import sys\n"
        "from kugelpendel.cli import main\n"
        "try:\n"
        f"    main({arguments!r})\n"
        "except SystemExit:\n"
        "    pass\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules}), file=sys.stderr)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    loaded = set(done.stderr.splitlines()[-1].split())
    assert "kugelpendel" in loaded
    assert not loaded & HEAVY


def test_the_main_job_does_without_pandas_xarray_and_pint(write, tmp_path) -> None:
    program = (
        "import sys\n"
        "from kugelpendel.cli import main\n"
        f"code = main(['run', {str(write())!r}, '--out', {str(tmp_path / 'o')!r}])\n"
        "assert code == 0\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules}), file=sys.stderr)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert not set(done.stderr.split()) & {"pandas", "xarray", "pint"}


def test_version() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "kugelpendel", "--version"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == f"kugelpendel {importlib.metadata.version('kugelpendel')}\n"


def test_help_shows_a_job(call) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "kugelpendel", "run", "--help"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert '[pendulum]\n  length = "67 m"' in done.stdout
