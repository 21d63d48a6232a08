"""Output folders: all files or none, whatever fails at whatever step, and nobody else's files."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from kugelpendel import InvalidInput
from kugelpendel.cli.output import manifest, one_file, staged, write_file

OLD = {"track.csv": "old track", "figure.png": "old figure", "results.json": "old results"}
NEW = {"track.nc": "new track", "figure.png": "new figure", "results.json": "new results"}
NAMES = ("track.csv", "track.nc", "figure.png", "results.json")


def put(folder: Path, files: dict[str, str]) -> None:
    with staged(folder, NAMES) as temporary:
        for name, text in files.items():
            (temporary / name).write_text(text)


def seen(folder: Path) -> dict[str, str]:
    """The files that are not hidden."""
    return {
        path.name: path.read_text()
        for path in folder.iterdir()
        if path.is_file() and not path.name.startswith(".")
    }


def hidden(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.rglob(".kugelpendel*"))


# One process that forks: at its n-th file operation the child kills itself, or fails once, or fails
# for good. Every file operation of Python passes the audit hook before it is done.
SCRIPT = """
import json, os, signal, sys, traceback
from pathlib import Path
from kugelpendel import InvalidInput
from kugelpendel.cli.output import staged

base, how = Path(sys.argv[1]), sys.argv[2]
OLD, NEW, NAMES = json.loads(sys.argv[3])
EVENTS = ("os.rename", "os.remove", "os.link", "os.mkdir", "os.rmdir", "open", "shutil.copyfile")

def put(folder, files):
    with staged(folder, NAMES) as temporary:
        for name, text in files.items():
            (temporary / name).write_text(text)

def child(folder, step):
    count, over = 0, False
    def watch(event, arguments):
        nonlocal count
        if over or event not in EVENTS or (event == "open" and "w" not in str(arguments[1])):
            return
        count += 1
        if how == "kill" and count == step:
            os.kill(os.getpid(), signal.SIGKILL)
        if how == "fail" and count == step or how == "keep failing" and count >= step:
            raise OSError(28, "No space left on device")
        if how == "interrupt" and count == step:
            raise KeyboardInterrupt
    sys.addaudithook(watch)
    code, said = 0, ""
    try:
        put(folder, NEW)
    except (InvalidInput, KeyboardInterrupt) as error:
        code, said = 2, str(error)
    except BaseException:
        traceback.print_exc()
        code = 1
    over = True
    (folder.parent / "said").write_text(said)
    return 3 if count < step else code

step, codes = 0, []
while not codes or codes[-1] != 3:
    step += 1
    folder = base / str(step) / "out"
    put(folder, OLD)
    pid = os.fork()
    if not pid:
        code = child(folder, step)
        os._exit(code)
    codes.append(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]))
print(json.dumps(codes))
"""


def every_step(tmp_path: Path, how: str) -> list[tuple[Path, int]]:
    """Do the move once for each of its steps, with a fault at that step; folders and exit codes."""
    texts = json.dumps([OLD, NEW, NAMES])
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, tmp_path, how, texts],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stderr == ""
    codes: list[int] = json.loads(done.stdout)
    assert codes.pop() == 3  # there were no more steps
    assert len(codes) > 20
    return [(tmp_path / str(step) / "out", code) for step, code in enumerate(codes, start=1)]


def whole_sets(folder: Path) -> list[dict[str, str]]:
    """What the folder shows, and the sets that the stage of a dead run has kept."""
    stages = [path for path in folder.glob(".kugelpendel-*") if (path / "move.json").exists()]
    return [seen(folder), *(seen(stage / which) for stage in stages for which in ("old", "new"))]


def test_killed_at_any_step_a_whole_set_is_there_and_the_next_run_completes_it(
    tmp_path: Path,
) -> None:
    for folder, code in every_step(tmp_path, "kill"):
        assert code == -9
        shown, *kept = whole_sets(folder)
        assert shown in (OLD, NEW) or kept == [OLD, NEW], folder
        assert all((folder / name).read_text() in (OLD[name], NEW[name])
                   for name in ("figure.png", "results.json"))  # fmt: skip
        # A run that comes to nothing completes what the killed one has left.
        with pytest.raises(ZeroDivisionError), staged(folder, NAMES):
            raise ZeroDivisionError
        assert seen(folder) in (OLD, NEW)
        assert hidden(folder) == [".kugelpendel.json"]
        # The next one replaces that set, since a run made it.
        put(folder, NEW)
        assert seen(folder) == NEW


def test_a_failure_at_any_step_leaves_the_old_set(tmp_path: Path) -> None:
    for folder, code in every_step(tmp_path, "fail"):
        assert code in (2, 0)
        assert seen(folder) == (NEW if code == 0 else OLD)
        if code == 2:
            said = folder.with_name("said").read_text()
            assert "No space left on device" in said
        put(folder, OLD)
        assert seen(folder) == OLD
        assert hidden(folder) == [".kugelpendel.json"]


def test_an_interruption_at_any_step_leaves_a_whole_set(tmp_path: Path) -> None:
    for folder, code in every_step(tmp_path, "interrupt"):
        assert code == 2
        # In the end, when all is in place but the stage is not yet removed, that is the new one.
        assert seen(folder) in (OLD, NEW)
        put(folder, OLD)
        assert seen(folder) == OLD
        assert hidden(folder) == [".kugelpendel.json"]


def test_what_cannot_even_be_put_back_is_kept_and_told(tmp_path: Path) -> None:
    told = 0
    for folder, code in every_step(tmp_path, "keep failing"):
        assert code in (2, 0)
        shown, *kept = whole_sets(folder)
        assert shown in (OLD, NEW) or kept == [OLD, NEW], folder
        said = folder.with_name("said").read_text()
        if "could not all be put back" in said:
            told += 1
            found = re.search(r"All of them are in (\S+), and the new ones in", said)
            assert found is not None
            assert seen(Path(found[1])) == OLD
        with pytest.raises(ZeroDivisionError), staged(folder, NAMES):
            raise ZeroDivisionError
        assert seen(folder) in (OLD, NEW)
        assert hidden(folder) == [".kugelpendel.json"]
    assert told > 0


def test_files_on_a_system_without_links_are_copied(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(self: Path, target: Path) -> None:
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(Path, "hardlink_to", refuse)
    put(tmp_path / "out", OLD)
    put(tmp_path / "out", NEW)
    assert seen(tmp_path / "out") == NEW


@pytest.mark.parametrize("links", [True, False])
def test_a_file_that_cannot_be_replaced_leaves_both_sets(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, links: bool
) -> None:
    """As one that is immutable, of which there is not even a second link, or another user's."""
    put(tmp_path / "out", OLD)
    replace = Path.replace

    def immutable(self: Path, target: Path) -> Path:
        if Path(target).name == "results.json":
            raise PermissionError(1, "Operation not permitted", str(self), None, str(target))
        return replace(self, target)

    link = Path.hardlink_to

    def no_link(self: Path, target: Path) -> None:
        if target.name == "results.json" and not links:
            raise PermissionError(1, "Operation not permitted")
        link(self, target)

    monkeypatch.setattr(Path, "replace", immutable)
    monkeypatch.setattr(Path, "hardlink_to", no_link)
    with pytest.raises(InvalidInput, match=r"failed: results\.json: Operation not permitted; noth"):
        put(tmp_path / "out", NEW)
    assert seen(tmp_path / "out") == OLD
    assert hidden(tmp_path) == [".kugelpendel.json"]


@pytest.mark.parametrize("name", ["figure.png", "results.json", "track.nc"])
def test_files_of_the_user_are_refused_before_any_work(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("mine")
    with (
        pytest.raises(InvalidInput, match=rf"has {name} already: not made by an earlier"),
        staged(tmp_path, NAMES),
    ):
        raise AssertionError
    assert seen(tmp_path) == {name: "mine"}
    assert hidden(tmp_path) == []


def test_a_file_that_the_user_has_changed_is_the_users(tmp_path: Path) -> None:
    put(tmp_path / "out", OLD)
    (tmp_path / "out" / "figure.png").write_text("improved")
    with pytest.raises(
        InvalidInput, match=r"figure\.png already.*or changed since; move that away"
    ):
        put(tmp_path / "out", NEW)
    assert seen(tmp_path / "out") == {**OLD, "figure.png": "improved"}


def test_a_link_of_the_user_is_the_users(tmp_path: Path) -> None:
    put(tmp_path / "out", OLD)
    (tmp_path / "out" / "figure.png").rename(tmp_path / "elsewhere")
    (tmp_path / "out" / "figure.png").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(InvalidInput, match=r"figure\.png already"):
        put(tmp_path / "out", NEW)


def test_only_what_may_be_written_is_refused(tmp_path: Path) -> None:
    (tmp_path / "track.csv").write_text("mine")
    with staged(tmp_path, NAMES, writes=("track.nc", "results.json")) as temporary:
        (temporary / "track.nc").write_text("new")
    assert seen(tmp_path) == {"track.csv": "mine", "track.nc": "new"}


def test_a_file_that_appears_meanwhile_is_not_replaced(tmp_path: Path) -> None:
    def work() -> None:
        with staged(tmp_path, NAMES) as new:
            (new / "figure.png").write_text("ours")
            (tmp_path / "figure.png").write_text("mine")

    with pytest.raises(InvalidInput, match=r"figure\.png already"):
        work()
    assert seen(tmp_path) == {"figure.png": "mine"}


def test_two_commands_share_a_folder(tmp_path: Path) -> None:
    put(tmp_path, OLD)
    with staged(tmp_path, ("design.png",)) as temporary:
        (temporary / "design.png").write_text("design")
    put(tmp_path, NEW)
    assert seen(tmp_path) == {**NEW, "design.png": "design"}
    with staged(tmp_path, ("design.png",)) as temporary:
        (temporary / "design.png").write_text("another")
    assert seen(tmp_path) == {**NEW, "design.png": "another"}


def test_a_folder_may_be_copied_and_moved(tmp_path: Path) -> None:
    put(tmp_path / "out", OLD)
    subprocess.run(["cp", "-r", tmp_path / "out", tmp_path / "copy"], check=True)
    os.utime(tmp_path / "copy" / "track.csv", (0, 0))
    put(tmp_path / "copy", NEW)
    assert seen(tmp_path / "copy") == NEW


@pytest.mark.parametrize("text", ["", "{", "[]", '{"files": 3}', '{"files": {"track.csv": 3}}'])
def test_a_broken_manifest_makes_all_files_the_users(tmp_path: Path, text: str) -> None:
    put(tmp_path, OLD)
    (tmp_path / manifest.NAME).write_text(text)
    with pytest.raises(InvalidInput, match=r"figure\.png"):
        put(tmp_path, NEW)
    assert seen(tmp_path) == OLD


def test_a_fingerprint_sees_length_start_and_end(tmp_path: Path) -> None:
    prints: set[str] = set()
    base = bytearray(3 << 20)
    for at, value in ((0, 0), (5, 1), (len(base) - 1, 1)):
        changed = base.copy()
        changed[at] = value
        (tmp_path / "file").write_bytes(changed)
        prints.add(manifest.of(tmp_path / "file"))
    (tmp_path / "file").write_bytes(base + b"\0")
    prints.add(manifest.of(tmp_path / "file"))
    (tmp_path / "file").write_bytes(b"")
    prints.add(manifest.of(tmp_path / "file"))
    assert len(prints) == 5


def test_stages_of_living_runs_and_folders_of_the_user_stay(tmp_path: Path) -> None:
    mine = tmp_path / ".kugelpendel-notes"
    mine.mkdir()
    dead = tmp_path / ".kugelpendel-0123456789ab"
    (dead / "new").mkdir(parents=True)
    (dead / "new" / "track.csv").write_text("left behind")
    with staged(tmp_path / "one", NAMES) as first:
        (first / "track.csv").write_text("first")
        assert not dead.exists()
        put(tmp_path / "two", OLD)
        assert first.exists()
    assert seen(tmp_path / "one") == {"track.csv": "first"}
    assert mine.exists()


def test_what_a_killed_run_left_above_a_new_folder_is_removed(tmp_path: Path) -> None:
    script = (
        "import os, signal, sys\nfrom pathlib import Path\n"
        "from kugelpendel.cli.output import staged\n"
        "with staged(Path(sys.argv[1]), ('a',)) as new:\n"
        "    (new / 'a').write_text('half')\n"
        "    os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    folder = tmp_path / "deep" / "out" / "job"
    done = subprocess.run([sys.executable, "-c", script, folder], check=False)
    assert done.returncode == -9
    assert len(hidden(tmp_path)) == 1
    put(folder, NEW)
    assert hidden(tmp_path) == [".kugelpendel.json"]
    assert seen(folder) == NEW


def test_one_file_is_there_complete_or_not_at_all(tmp_path: Path) -> None:
    path = tmp_path / "a.md"
    path.write_text("before")

    def fail() -> None:
        with one_file(path) as temporary:
            temporary.write_text("half")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail()
    assert path.read_text() == "before"
    write_file(path, "after\n")
    assert path.read_bytes() == b"after\n"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.md"]


def test_one_file_where_none_can_be(tmp_path: Path) -> None:
    with pytest.raises(InvalidInput, match="cannot be written: it is a folder; choose another"):
        write_file(tmp_path, "")
    with pytest.raises(InvalidInput, match="cannot be written: No such file or directory"):
        write_file(tmp_path / "no" / "a.md", "")
    with one_file(tmp_path / "yes" / "a.md", makes_parents=True) as temporary:
        temporary.write_text("")
    (tmp_path / "taken").write_text("mine")
    with (
        pytest.raises(InvalidInput, match=r"cannot be written: .*taken is a file"),
        one_file(tmp_path / "taken" / "deep" / "a.md", makes_parents=True),
    ):
        raise AssertionError
