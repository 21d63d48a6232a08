"""The script that builds the explorer's core: which toolchain it takes, or what it says."""

import shutil
import stat
import subprocess
from pathlib import Path

import pytest

RUSTC = """#!{bash}
echo "{sysroot}"
"""

CARGO = """#!{bash}
printf '%s\\n' "$@" > asked
printf '%s' "$CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS|${{RUSTC_BOOTSTRAP-unset}}" > flags
"{mkdir}" -p target/wasm/wasm32-unknown-unknown/wasm
echo core > target/wasm/wasm32-unknown-unknown/wasm/kugelpendel_wasm.wasm
"""


@pytest.fixture
def programs(tmp_path: Path) -> Path:
    """A folder with a toolchain as rustup installs it, but without the target; nothing else."""
    folder = tmp_path / "bin"
    folder.mkdir()
    found = {name: shutil.which(name) for name in ("bash", "mkdir")}
    for name, text in (("rustc", RUSTC), ("cargo", CARGO)):
        program = folder / name
        program.write_text(text.format(sysroot=tmp_path / "toolchain", **found))
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
    copier = shutil.which("cp")
    assert copier is not None
    (folder / "cp").symlink_to(copier)
    return folder


def built(repository: Path, programs: Path, wanted: str) -> subprocess.CompletedProcess[str]:
    bash = shutil.which("bash")
    assert bash is not None
    script = repository / "crates" / "kugelpendel-wasm" / "build.sh"
    return subprocess.run(
        [bash, script, wanted],
        cwd=programs.parent,
        env={"PATH": str(programs)},
        capture_output=True,
        text=True,
        check=False,
        timeout=30,
    )


def test_the_target_of_rustup_is_taken_where_it_is_installed(
    repository: Path, programs: Path
) -> None:
    folder = programs.parent
    (folder / "toolchain/lib/rustlib/wasm32-unknown-unknown/lib").mkdir(parents=True)
    assert built(repository, programs, "--check").returncode == 0
    assert not (folder / "asked").exists()
    answer = built(repository, programs, "core.wasm")
    assert (answer.returncode, answer.stderr) == (0, "")
    assert (folder / "core.wasm").read_text() == "core\n"
    asked = (folder / "asked").read_text().split()
    assert asked[:2] == ["build", "--locked"]
    assert asked[asked.index("--target") + 1] == "wasm32-unknown-unknown"
    # A stable compiler has the standard library ready, and needs none of its unstable options.
    assert not any(word.startswith("-Z") for word in asked)
    assert (folder / "flags").read_text() == "-Ctarget-feature=+simd128 |unset"


def test_without_a_toolchain_the_way_out_is_said(repository: Path, programs: Path) -> None:
    answer = built(repository, programs, "--check")
    assert answer.returncode == 3
    assert answer.stderr == (
        "To build the explorer's core, add the target wasm32-unknown-unknown with rustup, "
        "or on Debian install rustc-web, cargo-web, rust-web-src and lld.\n"
    )
