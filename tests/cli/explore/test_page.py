"""The page as it is built: its size, what it asks for, and that its physics is the core's."""

import gzip
import re
from pathlib import Path

import pytest
from tests.cli.explore.browsing import NotThere, built

LARGEST = 550_000
LARGEST_CORE = 200_000

PHYSICS = {
    "a frequency of small swings": r"sqrt\([^()]*(?:gravity|\bg\b)[^()]*/",
    "a ratio with the length": r"sqrt\([^()]*/[^()]*length",
    "a speed by gravity": r"sqrt\([^()]*gravity",
    "Olsson's (25)": r"\b0\.375\b|\b3\s*/\s*8\b",
    "the Earth's rotation": r"7\.29\d*e-0?5|86_?164|23\.934",
    "standard gravity in a formula": r"9\.8\d*\s*[*/]|[*/]\s*9\.8",
    "a trace of the motion": r"Math\.(?:atan2|acos)\([^()]*velocity",
    "a decay": r"Math\.(?:exp|LN2)\b",
}
"""What a page that computed motions by itself would have to write."""


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    try:
        return built()
    except NotThere as error:
        pytest.skip(str(error))


def packed(body: bytes) -> int:
    return len(gzip.compress(body, 9, mtime=0))


def test_the_page_is_small(files: dict[str, bytes]) -> None:
    # "/" is index.html once more, and the derivation is a page of its own, to which this one links.
    sizes = {
        path: packed(body)
        for path, body in files.items()
        if path != "/" and not path.startswith("/derivation.")
    }
    assert sum(sizes.values()) <= LARGEST, sizes
    (core,) = (size for path, size in sizes.items() if path.endswith(".wasm"))
    assert core <= LARGEST_CORE


def test_the_core_needs_nothing_from_the_page(files: dict[str, bytes]) -> None:
    (core,) = (body for path, body in files.items() if path.endswith(".wasm"))
    assert core.startswith(b"\0asm\1\0\0\0")
    sections, place = [], 8
    while place < len(core):
        kind, size, shift, place = core[place], 0, 0, place + 1
        while True:
            byte, place = core[place], place + 1
            size |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                break
        sections.append(kind)
        place += size
    imports = 2
    assert imports not in sections
    assert place == len(core)


def test_the_page_links_to_the_derivation(files: dict[str, bytes]) -> None:
    for language in ("de", "en"):
        page = files[f"/derivation.{language}.html"]
        assert b'id="eq-25"' in page


def test_the_page_computes_no_physics(repository: Path) -> None:
    sources = [
        path
        for ending in ("*.ts", "*.tsx")
        for path in (repository / "explorer" / "src").rglob(ending)
    ]
    assert len(sources) > 10
    found = [
        f"{path.relative_to(repository)}: {what}: {match[0]}"
        for path in sources
        for what, pattern in PHYSICS.items()
        if (match := re.search(pattern, without_comments(path.read_text())))
    ]
    assert found == []


def without_comments(text: str) -> str:
    """Source without what stands in comments; strings that look like one do not matter here."""
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)


@pytest.mark.parametrize(
    ("line", "is_physics"),
    [
        ("const omega = Math.sqrt(gravity / length);", True),
        ("const omega = Math.sqrt(given.pendulum.gravity / l);", True),
        ("const speed = Math.sqrt(given.gravity * length);", True),
        ("const rate = 0.375 * a * b;", True),
        ("const rate = (3 / 8) * a * b;", True),
        ("const earth = 7.292e-5 * Math.sin(latitude);", True),
        ("a *= Math.exp(-time / decay);", True),
        ("const distance = Math.sqrt(x * x + y * y);", False),
        ("const shown = summary.frequency;", False),
        ("const earth = 9.81;", False),
    ],
)
def test_physics_would_be_found(line: str, is_physics: bool) -> None:
    assert any(re.search(pattern, line) for pattern in PHYSICS.values()) is is_physics
