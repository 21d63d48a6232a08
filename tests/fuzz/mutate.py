"""Job and design files, spoilt: what people mistype, paste, misunderstand or do on purpose."""

import random
import re
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]

NUMBERS = (
    "0", "-0.0", "-1", "1", "3", "1e-300", "1e-80", "1e-9", "0.5", "1e9", "1e18", "1e78", "1e300",
    "nan", "inf", "-inf", "1_000", "0x10", "1e400", "true", "false", '""', "[]", "[1, 2, 3]", "{}",
    "1979-05-27", "07:32:00", "1,5", '"1,5 m"', '"1.000,5 m"', '"half a metre"', '"m"', '"4{ deg"',
    '"45 Grad"', '"45 grad"', '"500 gr"', "'''x'''", '"\\u0000"', '"9 m m"', '"1e5 m/s^9"',
)  # fmt: skip
UNITS = (
    "m", "cm", "mm", "km", "ft", "in", "s", "ms", "min", "h", "d", "kg", "g", "lb", "deg", "rad",
    "°", "mrad", "m/s", "km/h", "m/s^2", "rad/s", "deg/h", "1/s", "1/m", "kg/m^3", "GPa", "parsec",
    "K", "eV", "", "%", "′", "″", "°N", "turn", "Mm", "µm", "nm", "[m]", "m**", "m^", "(",
)  # fmt: skip
LINES = (
    "[pendulum]", "[launch]", "[output]", "[site]", "[drag]", "[drive]", "[swing]", "[questions]",
    'kind = "state"', 'kind = "at_rest"', 'kind = "orbit"', "theta = 45", 'theta = "179.9 deg"',
    'length = "1 m"', "samples = 1", "samples = 0", 'step = "1 us"', 'format = "parquet"', "=",
    'format = "xlsx"', "position = [0, 0, 1]", "velocity = [1, 0, 0]", "# nothing", "\x00", "[[x]]",
    "figure = true", 'radius = "5 cm"', 'phase = "30 deg"', 'push = "1 m/s"', "quality = -3",
    "from_bob = true", 'half_life = "0 s"', 'gravity = "1 m/s^2"', "latitude = 91", "a.b.c = 1",
)  # fmt: skip


def bases(kind: str) -> list[str]:
    """The examples, made short: a mutated one is done in no time unless it asks for more."""
    folder = REPOSITORY / "examples"
    paths = sorted(folder.glob("*.toml")) if kind == "run" else sorted(folder.glob("design/*.toml"))
    return [_short(path.read_text(encoding="utf-8")) for path in paths]


def _short(text: str) -> str:
    text = re.sub(r"^duration = .*$", 'duration = "20 s"', text, flags=re.MULTILINE)
    text = re.sub(r"^step = .*$", 'step = "0.1 s"\nfigure = false', text, flags=re.MULTILINE)
    return "\n".join(line for line in text.splitlines() if not line.startswith("#")) + "\n"


def mutated(text: str, chance: random.Random) -> bytes:
    """The text with one to four things wrong; as bytes, since not all of it need be text."""
    for _ in range(chance.choice((1, 1, 1, 2, 2, 3, 4))):
        text = chance.choice(_MUTATIONS)(text, chance)
    data = text.encode("utf-8", errors="surrogatepass")
    if chance.random() < 0.02:
        at = chance.randrange(len(data) + 1)
        data = data[:at] + bytes(chance.randrange(256) for _ in range(3)) + data[at:]
    if chance.random() < 0.02:
        data = chance.choice(
            (b"\xef\xbb\xbf" + data, text.encode("utf-16", "surrogatepass"), data[: len(data) // 2])
        )
    return data


def _entries(text: str) -> list[re.Match[str]]:
    return list(re.finditer(r"^([\w.]+) = (.*?)( +#.*)?$", text, re.MULTILINE))


def _value(text: str, chance: random.Random) -> str:
    entry = chance.choice(_entries(text) or [None])
    if entry is None:
        return text
    return text[: entry.start(2)] + chance.choice(NUMBERS) + text[entry.end(2) :]


def _size(text: str, chance: random.Random) -> str:
    found = list(re.finditer(r"\d+\.?\d*(e[+-]?\d+)?", text))
    if not found:
        return text
    at = chance.choice(found)
    factor = chance.choice((-1.0, 0.0, 1e-3, 0.1, 0.9, 1.1, 2.0, 10.0, 1e3, 1e6))
    return text[: at.start()] + f"{float(at[0]) * factor:g}" + text[at.end() :]


def _unit(text: str, chance: random.Random) -> str:
    found = list(re.finditer(r'(?<=\d )[^"\d\s][^"\n]*(?=")', text))
    if not found:
        return text
    at = chance.choice(found)
    return text[: at.start()] + chance.choice(UNITS) + text[at.end() :]


def _without(text: str, chance: random.Random) -> str:
    lines = text.splitlines()
    if lines:
        del lines[chance.randrange(len(lines))]
    return "\n".join(lines) + "\n"


def _twice(text: str, chance: random.Random) -> str:
    lines = text.splitlines() or [""]
    lines.insert(chance.randrange(len(lines) + 1), chance.choice(lines))
    return "\n".join(lines) + "\n"


def _line(text: str, chance: random.Random) -> str:
    lines = text.splitlines()
    lines.insert(chance.randrange(len(lines) + 1), chance.choice(LINES))
    return "\n".join(lines) + "\n"


def _key(text: str, chance: random.Random) -> str:
    entries = _entries(text)
    if len(entries) < 2:
        return text
    one, other = chance.sample(entries, 2)
    return text[: one.start(1)] + other[1] + text[one.end(1) :]


def _letter(text: str, chance: random.Random) -> str:
    at = chance.randrange(len(text) + 1)
    sign = chance.choice("\"'[]{}=,.-+#\\°′−\u202e\ud800 \t\n0e")
    return text[:at] + sign + text[at + chance.choice((0, 1)) :]


def _blocks(text: str, chance: random.Random) -> str:
    blocks = re.split(r"(?m)^(?=\[)", text)
    chance.shuffle(blocks)
    return "".join(blocks[: chance.randrange(1, len(blocks) + 1)])


_MUTATIONS = (_value, _value, _size, _size, _size, _unit, _unit, _without, _twice, _line, _key,
              _letter, _blocks)  # fmt: skip
