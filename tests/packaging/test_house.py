"""The rules of the house that a machine can hold: rooms, names, docstrings."""

import ast
import re
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOMS = ("src", "crates", "tests", "benchmarks", "references", "explorer")
GENERATED = {"__pycache__", "node_modules", "dist"}
BUILT = "src/kugelpendel/cli/explore/page"
MOST_FILES = 14
MOST_LINES = 400

FRAGMENTS = re.compile(
    r"(?:Of|As|Which|When|Where|What|In|From|To|For|With|At|By|The same|rad|m|s)\b[^,;:]{0,18}\."
)
"""Half sentences that need the name beside them to be understood: "Of the last term.", "When."."""


def code(repository: Path, *folders: str, ending: str = "") -> list[Path]:
    """The files of some folders but those that tools leave there."""
    return [
        path
        for folder in folders
        for path in sorted((repository / folder).rglob(f"*{ending}"))
        if path.is_file() and not GENERATED & set(path.parts)
        and not path.is_relative_to(repository / BUILT)
        and path.suffix not in (".so", ".pyc", ".wasm")
    ]  # fmt: skip


def test_no_folder_has_more_than_fourteen_files(repository: Path) -> None:
    counts = Counter(path.parent.relative_to(repository) for path in code(repository, *ROOMS))
    assert {str(k): v for k, v in counts.items() if v > MOST_FILES} == {}


def test_no_module_has_more_than_four_hundred_lines(repository: Path) -> None:
    sources = [*code(repository, "src", ending=".py"), *code(repository, "crates", ending=".rs")]
    for ending in (".ts", ".tsx", ".css"):
        sources += code(repository, "explorer", ending=ending)
    lengths = {str(p.relative_to(repository)): len(p.read_text().splitlines()) for p in sources}
    assert {name: lines for name, lines in lengths.items() if lines > MOST_LINES} == {}


def test_no_two_classes_share_a_name(repository: Path) -> None:
    places: dict[str, list[str]] = defaultdict(list)
    for path in code(repository, "src", ending=".py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.ClassDef):
                places[node.name].append(str(path.relative_to(repository)))
    assert {name: where for name, where in places.items() if len(where) > 1} == {}


def test_no_two_types_of_the_core_share_a_name(repository: Path) -> None:
    places: dict[str, list[str]] = defaultdict(list)
    defined = re.compile(
        r"^\s*(?:pub(?:\([^)]*\))? )?(?:struct|enum|trait|union) (\w+)", re.MULTILINE
    )
    for path in code(repository, "crates", ending=".rs"):
        for name in defined.findall(path.read_text()):
            places[name].append(str(path.relative_to(repository)))
    assert {name: where for name, where in places.items() if len(where) > 1} == {}


def documented(tree: ast.AST, prefix: str = "") -> Iterator[tuple[str, str]]:
    """The public things of a module with their docstrings."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and not node.name.startswith("_"):
            name = f"{prefix}{node.name}"
            text = ast.get_docstring(node)
            if text:
                yield name, text
            if isinstance(node, ast.ClassDef):
                yield from documented(node, f"{name}.")


def test_python_docstrings_are_whole_sentences(repository: Path) -> None:
    telegrams: list[str] = []
    for path in code(repository, "src", ending=".py"):
        for name, text in documented(ast.parse(path.read_text())):
            first = text.split("\n\n")[0].replace("\n", " ")
            if not first.rstrip().endswith((".", ":", "?")) or FRAGMENTS.fullmatch(first.strip()):
                telegrams.append(f"{path.relative_to(repository)}: {name}: {first!r}")
    assert telegrams == []


def test_docstrings_leave_the_types_to_the_signature(repository: Path) -> None:
    typed: list[str] = []
    heading = re.compile(r"^\s*(Parameters|Returns|Attributes|Yields)\n\s*-+$", re.MULTILINE)
    for path in code(repository, "src", ending=".py"):
        for name, text in documented(ast.parse(path.read_text())):
            sections = heading.split(text)[2::2]
            typed += [
                f"{path.relative_to(repository)}: {name}: {line}"
                for section in sections
                for line in section.splitlines()
                if re.match(r"\w[\w, ]* : \S", line)
            ]
    assert typed == []


@pytest.mark.parametrize("item", ["fn", "struct", "enum", "trait", "const", "field"])
def test_rust_documents_in_whole_sentences(item: str, repository: Path) -> None:
    head = r"pub (?:const )?fn \w+" if item == "fn" else rf"pub {item} \w+"
    if item == "field":
        head = r"pub \w+: "
    pattern = re.compile(rf"((?:^[ ]*///.*\n)+)(?:^[ ]*#\[.*\n)*^[ ]*{head}", re.MULTILINE)
    telegrams: list[str] = []
    for path in code(repository, "crates", ending=".rs"):
        for comment in pattern.findall(path.read_text()):
            text = " ".join(
                line.strip().removeprefix("///").strip() for line in comment.splitlines()
            )
            first = re.split(r"\s\s|# Errors|# Panics", text)[0].strip()
            if first and (not first.endswith((".", ":")) or FRAGMENTS.fullmatch(first)):
                telegrams.append(f"{path.relative_to(repository)}: {first!r}")
    assert telegrams == []
