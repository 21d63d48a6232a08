"""What an import costs: nothing is loaded that was not asked for."""

import subprocess
import sys

import pytest

HEAVY = ("h5netcdf", "matplotlib", "pandas", "pint", "pyarrow", "rich", "scipy", "xarray")


def loaded_after(statement: str) -> set[str]:
    """Top-level packages that a fresh interpreter has loaded after a statement."""
    return {name.partition(".")[0] for name in modules_after(statement)}


def modules_after(statement: str) -> set[str]:
    script = f"{statement}\nimport sys\nprint(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    return set(done.stdout.split())


def test_command_line_starts_without_numpy() -> None:
    loaded = loaded_after("import kugelpendel.cli")
    assert "kugelpendel" in loaded
    assert loaded.isdisjoint({"numpy", *HEAVY})


def called(*arguments: str) -> str:
    return (
        "import contextlib, io, kugelpendel.cli\n"
        "with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit):\n"
        f"    kugelpendel.cli.main({list(arguments)!r})"
    )


@pytest.mark.parametrize("arguments", [["--help"], ["run", "--help"]])
def test_help_needs_no_numpy(arguments: list[str]) -> None:
    assert loaded_after(called(*arguments)).isdisjoint({"numpy", *HEAVY})


def test_help_of_all_commands_reads_what_none_of_them_needs() -> None:
    schema = "kugelpendel.cli.job_file.schema"
    assert schema not in modules_after(called("--help"))
    assert schema in modules_after(called("run", "--help"))


def test_motion_needs_numpy_alone() -> None:
    loaded = loaded_after(
        "import kugelpendel as kp\n"
        "kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.ellipse(0.1, 0.02)).position(1.0)"
    )
    assert "numpy" in loaded
    assert loaded.isdisjoint(HEAVY)
