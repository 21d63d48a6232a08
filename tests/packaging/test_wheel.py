"""A wheel is built from the checkout, installed outside it, and does the main job there."""

import fcntl
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from urllib.request import urlopen

import pytest


def tool(name: str) -> str:
    """A program of the environment that runs the tests."""
    found = shutil.which(name, path=str(Path(sys.executable).parent))
    if found is None:
        pytest.skip(f"{name} is not installed beside {sys.executable}; run make test")
    return found


def call(*command: str | Path, cwd: Path) -> str:
    """Run a command with nothing of this environment around it and return what it prints."""
    private = ("VIRTUAL_ENV", "PYTHONPATH", "PYTHONHOME")
    environment = {key: value for key, value in os.environ.items() if key not in private}
    environment |= {"UV_SYSTEM_CERTS": "1", "MPLBACKEND": "agg"}
    done = subprocess.run(
        command, cwd=cwd, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{command} ended with {done.returncode}:\n{done.stderr}"
    return done.stdout


@pytest.fixture(scope="session")
def wheel(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built once: maturin must not run twice at a time in one target folder."""
    several = "PYTEST_XDIST_WORKER" in os.environ
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if several else base) / "dist"
    with (folder.parent / "dist.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            options = ("--release", "--locked", "--interpreter", sys.executable)
            call(tool("maturin"), "build", *options, "--out", folder, cwd=repository)
    (built,) = folder.glob("*.whl")
    return built


def environment_with(requirement: str, repository: Path, folder: Path) -> Path:
    """Make an environment, with the versions that `make run` has, and return its programs."""
    uv, python = tool("uv"), folder / "venv" / "bin" / "python"
    call(uv, "venv", "--python", sys.executable, folder / "venv", cwd=folder)
    pins = repository / "requirements" / "run.lock"
    options = ("--python", python, "--constraints", pins)
    call(uv, "pip", "install", *options, requirement, cwd=folder)
    return python.parent


def built_page(repository: Path) -> list[Path]:
    """The files of the explorer's page, which git has not; none where it has not been built."""
    folder = repository / "src/kugelpendel/cli/explore/page"
    return [path for path in folder.rglob("*") if path.is_file()]


def test_one_wheel_serves_every_python_from_3_11(wheel: Path) -> None:
    assert re.fullmatch(r"kugelpendel-[\d.]+-cp311-abi3-\w+\.whl", wheel.name)


def test_wheel_holds_the_package_and_nothing_else(wheel: Path, repository: Path) -> None:
    listed = ("git", "ls-files", "--cached", "--others", "--exclude-standard", "src/kugelpendel")
    sources = {name.removeprefix("src/") for name in call(*listed, cwd=repository).splitlines()}
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if not name.endswith("/")}
        (metadata,) = (name for name in names if name.endswith(".dist-info/METADATA"))
        text = archive.read(metadata).decode()
    package = {name for name in names if ".dist-info/" not in name}
    page = {str(path.relative_to(repository / "src")) for path in built_page(repository)}
    assert package == sources | page | {"kugelpendel/_core.abi3.so"}
    assert "kugelpendel/py.typed" in package
    licences = {Path(name).name for name in names if ".dist-info/licenses/" in name}
    assert licences == {"LICENSE-APACHE", "LICENSE-MIT"}
    assert "License-Expression: MIT OR Apache-2.0" in text


def test_the_wheel_carries_the_explorers_page(wheel: Path, repository: Path) -> None:
    page = built_page(repository)
    if not page:
        pytest.skip("the explorer's page has not been built; run make explorer")
    assert {"index.html", "engine.js"} <= {path.name for path in page}
    with zipfile.ZipFile(wheel) as archive:
        for path in page:
            content = archive.read(str(path.relative_to(repository / "src")))
            assert content == path.read_bytes(), path


def test_library_needs_no_extra(wheel: Path, repository: Path, tmp_path: Path) -> None:
    programs = environment_with(str(wheel), repository, tmp_path)
    script = (
        "import kugelpendel as kp\n"
        "motion = kp.ExactMotion(kp.Pendulum(67.0), kp.Launch.ellipse(3.0, 0.01))\n"
        "print(motion.precession > 0, motion.position([0.0, 1.0]).shape)\n"
    )
    assert call(programs / "python", "-c", script, cwd=tmp_path) == "True (2, 3)\n"
    installed = {path.name for path in programs.parent.glob("lib/python*/site-packages/*")}
    assert "numpy" in installed
    assert installed.isdisjoint({"matplotlib", "pandas", "pint", "pyarrow", "xarray"})


def test_installed_wheel_does_the_main_job(wheel: Path, repository: Path, tmp_path: Path) -> None:
    programs = environment_with(f"kugelpendel[run] @ {wheel.as_uri()}", repository, tmp_path)
    shutil.copy(repository / "examples" / "pantheon.toml", tmp_path)
    where = "import kugelpendel; print(kugelpendel.__path__[0])"
    assert call(programs / "python", "-c", where, cwd=tmp_path).startswith(str(tmp_path))
    arguments = ("run", "pantheon.toml", "--out", "results", "--json")
    assert json.loads(call(programs / "kugelpendel", *arguments, cwd=tmp_path))
    assert {path.suffix for path in (tmp_path / "results").iterdir()} >= {".json", ".png"}
    if built_page(repository):
        assert b"<h1" in explored(programs / "kugelpendel", tmp_path)


def explored(program: Path, folder: Path) -> bytes:
    """The page as an installed kugelpendel serves it on a job."""
    arguments = (program, "explore", "pantheon.toml", "--no-browser")
    with subprocess.Popen(arguments, cwd=folder, stdout=subprocess.PIPE, text=True) as server:
        try:
            assert server.stdout is not None
            said = server.stdout.readline()
            address = re.fullmatch(r"The explorer is at (http://127\.0\.0\.1:\d+/)#.+\n", said)
            assert address, said
            with urlopen(address[1], timeout=10) as answer:
                return answer.read()
        finally:
            server.terminate()
