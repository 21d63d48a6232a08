"""What the repository's own files promise one another."""

import re
import subprocess
import tomllib
from importlib.metadata import version
from pathlib import Path

import pytest

# Written so that the patterns do not match themselves.
FORBIDDEN = {
    "path of a machine": r"(?<![\w.~:/-])/(?:root|home|Users|work|opt|mnt)/[\w.]",
    "package server": (
        r"(?i)\b(?:pypi[.]org|pythonhosted[.]org|(?:index|static)[.]crates[.]io"
        r"|registry[.]npmjs|--(?:extra-)?index-url|--find-links)"
    ),
}


def committed(repository: Path) -> list[Path]:
    """The files that are, or with the next `git add` would be, in the repository."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        listed = subprocess.run(
            command, cwd=repository, capture_output=True, text=True, check=True
        ).stdout
    except (FileNotFoundError, subprocess.CalledProcessError):
        pytest.skip("not a git checkout")
    return [path for name in listed.split("\0") if name and (path := repository / name).is_file()]


@pytest.mark.parametrize("what", FORBIDDEN)
def test_no_file_names_a_machine_or_a_package_server(what: str, repository: Path) -> None:
    found = [
        f"{path.relative_to(repository)}:{number}: {line.strip()[:120]}"
        for path in committed(repository)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1)
        if re.search(FORBIDDEN[what], line)
    ]
    assert not found, f"{what} in\n" + "\n".join(found)


def test_cargo_lock_has_one_source(repository: Path) -> None:
    packages = tomllib.loads((repository / "Cargo.lock").read_text())["package"]
    sources = {package["source"] for package in packages if "source" in package}
    assert sources == {"registry+https://github.com/rust-lang/crates.io-index"}


def test_one_version_everywhere(repository: Path) -> None:
    project = tomllib.loads((repository / "pyproject.toml").read_text())["project"]["version"]
    cargo = tomllib.loads((repository / "Cargo.toml").read_text())
    citation = re.search(
        r"^version: (\S+)$", (repository / "CITATION.cff").read_text(), re.MULTILINE
    )
    assert citation is not None
    assert {
        project,
        cargo["workspace"]["package"]["version"],
        citation[1],
        version("kugelpendel"),
    } == {project}


def test_every_requirement_is_pinned_with_a_hash(repository: Path) -> None:
    metadata = tomllib.loads((repository / "pyproject.toml").read_text())
    project = metadata["project"]
    groups = [
        project["dependencies"],
        *project["optional-dependencies"].values(),
        *metadata["dependency-groups"].values(),
    ]
    pins: dict[str, bool] = {}
    for lock in sorted((repository / "requirements").glob("*.lock")):
        for entry in re.split(r"\n(?=[a-z0-9])", lock.read_text()):
            if pin := re.match(r"([a-z0-9-]+)(?:\[[\w,]+\])?==", entry):
                pins[pin[1]] = "--hash=sha256:" in entry
    names = {re.split(r"[\[<>=~! ]", requirement)[0] for group in groups for requirement in group}
    assert {name.lower() for name in names} <= pins.keys(), "run make lock"
    assert all(pins.values())


def test_help_lists_every_target(repository: Path) -> None:
    printed = subprocess.run(
        ["make", "help"], cwd=repository, capture_output=True, text=True, check=True
    ).stdout
    listed = {line.split()[1] for line in printed.splitlines() if line.startswith("make ")}
    phony = re.search(r"^\.PHONY: (.*)$", (repository / "Makefile").read_text(), re.MULTILINE)
    assert phony is not None
    assert listed == set(phony[1].split())
    assert listed >= {"run", "test", "check", "bench", "clean", "help"}


def test_an_old_python_is_refused_with_a_sentence(repository: Path, tmp_path: Path) -> None:
    old = tmp_path / "python3.9"
    old.write_text('#!/bin/sh\n[ "$1" = --version ] && echo Python 3.9.2\nexit 1\n')
    old.chmod(0o755)
    done = subprocess.run(
        ["make", "--file", repository / "Makefile", f"PYTHON={old}", ".venv/bin/python"],
        cwd=tmp_path, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 2
    assert "Python 3.11 or newer is needed, Python 3.9.2 found" in done.stderr
    assert not (tmp_path / ".venv").exists()
