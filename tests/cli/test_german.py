"""With `--lang de` whatever is refused is said in German."""

# What is refused stands in rows, whatever their length.
# ruff: noqa: E501

import io
import re
import string
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.cli.conftest import Outcome

import kugelpendel as kp
from kugelpendel.cli import main
from kugelpendel.cli.output import files
from kugelpendel.cli.output.stage import Unfinished
from kugelpendel.errors import Language
from kugelpendel.errors._sentences import read

ROOMS = ("file_", "quantity_", "out_", "derive_", "option_", "follow_")
"""Kinds that only the command line says."""

SWEEP = {
    "pendulum": {"length": '"1 m"'},
    "launch": {"kind": '"ellipse"', "a": '["5 cm", "10 cm"]', "b": '"1 cm"'},
    "sweep": {"motion": '"averaged"', "quantities": '["azimuth"]', "times": '["10 min"]'},
}
BOB = {"bob.radius": "0.1", "bob.density": "8000"}

Given = dict[str, str | None] | bytes | list[str]

FILES: dict[str, tuple[dict[str, str | None] | bytes, str]] = {
    "file_no_toml": (b"[pendulum]\nlength = 67 m\n", "sweep.toml ist kein gültiges TOML: "),
    "file_comma": (b"[pendulum]\nlength = 0,2\n", 'sweep.toml, Zeile 2: length = 0,2 hat ein Dezimalkomma außerhalb von Anführungszeichen; schreiben Sie length = "0,2", '),
    "file_empty": (b"# nothing\n", "sweep.toml ist leer. Eine Jobdatei sieht so aus:\n\n[pendulum]\n"),
    "file_large": (b"#" * 2_000_000, "ist größer als 1024 KiB"),
    "file_encoding": (b"# Panth\xe9on\n", "steht an der Stelle 7 das Byte 0xe9"),
    "file_table": ({"launsh.a": "1"}, "sweep.toml, Zeile 11: [launsh] gibt es nicht (gemeint ist vielleicht launch); eine Jobdatei hat die Tabellen [pendulum], "),
    "file_no_table": (b"pendulum = 3\n", "Zeile 1: pendulum = 3 müsste eine Tabelle sein"),
    "file_table_missing": (b"[pendulum]\nlength = 1\n", "Die Tabelle [launch] fehlt; eine Jobdatei hat [pendulum], [launch], [sweep]."),
    "file_key": ({"launch.theta": "1"}, '[launch] theta gibt es bei kind = "ellipse" nicht; möglich sind kind, a, b, azimuth.'),
    "file_key_missing": ({"sweep.quantities": None}, '[sweep] quantities fehlt; schreiben Sie quantities = ["azimuth", "b"].'),
    "file_twice": ({"drag.linear": "0", "drag.quality": "9"}, "[drag] sagt dasselbe mehrmals: linear, quality; "),
    "file_word": ({"sweep.motion": '"reel"'}, 'Zeile 8: [sweep] motion = "reel" gibt es nicht (gemeint ist vielleicht real); möglich sind "exact", "averaged", "real".'),
    "file_word_missing": ({"launch.kind": None}, '[launch] kind fehlt; schreiben Sie eines von "ellipse", '),
    "file_truth": ({"sweep.second_order": "1"}, "[sweep] second_order = 1: Schreiben Sie true oder false."),
    "file_plain": ({"drag.quality": '"9"'}, '[drag] quality = "9" ist keine bloße Zahl; schreiben Sie quality = '),
    "file_components": ({"launch.kind": '"state"', "launch.a": None, "launch.b": None, "launch.position": "[0, 0]", "launch.velocity": "[0, 0, 0]"}, "[launch] position = [0, 0] hat keine drei Komponenten; "),
    "file_beyond_pole": ({"site.latitude": '"95 deg"'}, '[site] latitude = "95 deg" liegt jenseits eines Pols; '),
    "file_thread_alone": ({"drag.thread_diameter": '"1 mm"'}, "[drag] thread_diameter geht nur zusammen mit from_bob = true."),
    "file_no_bob": ({"drag.from_bob": "true"}, "[drag] from_bob = true braucht eine Tabelle [bob]"),
    "file_quadratic_twice": ({"drag.from_bob": "true", "drag.quadratic": "1e-3", **BOB}, "[drag] quadratic geht nicht zusammen mit from_bob = true, "),
    "quantity_no_number": ({"launch.b": "true"}, '[launch] b = true ist keine Zahl; gebraucht wird eine Länge, etwa "3 cm", oder eine bloße Zahl in m.'),
    "quantity_not_finite": ({"launch.b": "nan"}, "[launch] b = nan ist keine endliche Zahl; "),
    "quantity_turn": ({"launch.azimuth": '"361 deg"'}, '[launch] azimuth = "361 deg" ist mehr als eine volle Umdrehung; '),
    "quantity_turn_bare": ({"launch.azimuth": "45"}, 'sind Grad gemeint, schreiben Sie "45 deg".'),
    "quantity_long": ({"launch.b": f'"{"1" * 500} m"'}, "ist zu lang für eine Größe; "),
    "quantity_no_unit": ({"launch.b": '"1"'}, 'Zeile 6: [launch] b = "1" hat keine Einheit; gebraucht wird eine Länge, '),
    "quantity_marks": ({"launch.b": '"1.2.3 m"'}, '[launch] b = "1.2.3 m" hat mehr als einen Punkt oder ein Komma in der Zahl; '),
    "quantity_no_start": ({"launch.b": '"wide"'}, '[launch] b = "wide" beginnt nicht mit einer Zahl; '),
    "quantity_thousands": ({"launch.b": '"1,234 m"'}, 'kann 1.234 oder 1234 heißen; schreiben Sie "1.234 m" oder "1234 m".'),
    "quantity_unit_unknown": ({"launch.b": '"3 furlog"'}, '[launch] b = "3 furlog": Die Einheit "furlog" ist nicht bekannt; '),
    "quantity_unit_gon": ({"launch.azimuth": '"45 Grad"'}, 'Die Einheit "Grad" heißt für die einen Grad, für die anderen Gon; '),
    "quantity_unit_grain": ({"pendulum.mass": '"5 gr"'}, 'Die Einheit "gr" heißt für manche Gramm, ist aber das Gran von 64,8 mg; '),
    "quantity_unit_prefix": ({"launch.azimuth": '"45 mdeg"'}, 'Die Einheit "mdeg" wäre millidegree, was niemand meint; gebraucht wird ein Winkel, '),
    "quantity_other": ({"sweep.times": '["3 kg"]'}, 'Zeile 10: [sweep] times = "3 kg" misst etwas anderes; gebraucht wird eine Zeit, etwa "10 min", oder eine bloße Zahl in s.'),
    "quantity_other_rate": ({"suspension.anisotropy": '"1 Hz"'}, "Hz sagt nicht, ob Umdrehungen oder Radiant gemeint sind; gebraucht wird eine Winkelgeschwindigkeit, "),
    "quantity_parts": ({"pendulum.length": '"12 ft 13 in"'}, "weniger als eine von ihr ausmacht, etwa 12 ft 6 in; "),
    "quantity_side": ({"site.latitude": '"2 E"'}, '[site] latitude = "2 E" ist keine geographische Breite; '),
    "quantity_sign": ({"site.latitude": '"-33 S"'}, 'hat sowohl ein Vorzeichen als auch S; schreiben Sie eines davon: '),
    "sweep_words": ({"sweep.quantities": "3"}, '[sweep] quantities = 3 ist keine Liste von Wörtern; schreiben Sie quantities = ["azimuth", "b"].'),
    "sweep_times": ({"sweep.times": '{ from = "1 h", to = "6 h" }'}, '[sweep] times = {…}; schreiben Sie eine Liste oder { from = "1 h", to = "6 h", count = 6 }.'),
    "sweep_whole": ({"sweep.count": "2.5"}, "[sweep] count muss eine ganze Zahl ab 1 sein, ist aber 2.5."),
    "sweep_no_law": ({"launch.b": '{ from = "1 cm" }'}, 'Zeile 6: [launch] b hat from, was nicht sagt, wie es sich ändert; schreiben Sie eine Liste, einen Bereich wie { from = "3 cm", to = "3 cm", count = 20 } '),
    "sweep_range_key": ({"launch.b": '{ from = 0, to = "1 cm", cuont = 5 }'}, "[launch] b hat einen Schlüssel cuont, den es nicht gibt (gemeint ist vielleicht count); "),
    "sweep_range_whole": ({"launch.b": '{ from = 0, to = "1 cm", count = 0 }'}, "[launch] b hat count = 0; schreiben Sie eine ganze Zahl ab 2."),
    "sweep_scale": ({"launch.b": '{ from = 0, to = "1 cm", scale = "ln" }'}, '[launch] b hat scale = "ln"; '),
    "sweep_plain": ({"drag.quality": '["9"]'}, '[drag] quality hat "9", was keine bloße Zahl ist.'),
    "sweep_mixed_units": ({"launch.b": '["1 cm", 2]'}, '[launch] b hat "1 cm" mit einer Einheit und 2 ohne; '),
    "sweep_normal": ({"launch.b": '{ normal = "1 cm" }'}, '[launch] b hat normal = "1 cm"; schreiben Sie Mittelwert und Standardabweichung, '),
    "sweep_uniform": ({"launch.b": '{ uniform = ["1 cm"] }'}, "[launch] b hat uniform = ['1 cm']; schreiben Sie den kleinsten und den größten Wert, "),
    "sweep_no_quantity": ({"sweep.quantities": '["precesion"]'}, "Zeile 9: [sweep] Eine Durchmusterung kann 'precesion' nicht ablesen; sie liest frequency, "),
    "sweep_not_of_motion": ({"sweep.quantities": '["period"]'}, '[sweep] "period" lässt sich an der Bewegung "averaged" nicht ablesen, aber an diesen: "exact".'),
    "sweep_no_times": ({"sweep.times": None}, '[sweep] "azimuth" braucht Zeiten; schreiben Sie etwa times = ["6 h"].'),
    "sweep_no_ground": ({"sweep.quantities": '["stalls"]'}, '"stalls" braucht einen Boden, der sich dreht; '),
    "sweep_time_before": ({"sweep.times": '["-1 h"]'}, "Zeile 10: [sweep] Eine Durchmusterung liest nach dem Start ab, aber eine ihrer Zeiten ist -3600 s."),
    "sweep_times_order": ({"sweep.times": '["2 h", "1 h"]'}, "Zeile 10: [sweep] Die Zeiten einer Durchmusterung müssen von einer zur nächsten wachsen, aber auf 7200 s folgt 3600 s; "),
    "sweep_mean_rate": ({"sweep.times": "[0, 1]", "sweep.quantities": '["mean_rate"]'}, '"mean_rate" ist die Rate vom Start bis zu einer späteren Zeit, aber eine der Zeiten ist 0 s; '),
}  # fmt: skip
"""Of each kind what is in the file, and a part of what is said."""

ARGUMENTS: dict[str, tuple[list[str], str]] = {
    "sweep_workers": (["sweep", "../sweep.toml", "--workers", "two"], "--workers ist 'two'; schreiben Sie eine ganze Zahl von 1 bis 4096, "),
    "file_is_folder": (["sweep", "."], ". ist ein Ordner; nennen Sie eine Jobdatei, etwa ./job.toml."),
    "file_missing": (["sweep", "../jbo.toml"], "../jbo.toml gibt es nicht; in jenem Ordner sind sweep.toml."),
    "file_unread": (["sweep", "a\0b"], "lässt sich nicht lesen: "),
    "out_below_file": (["fit", "a.csv", "--out", "../sweep.toml/out"], "sweep.toml ist eine Datei; nehmen Sie mit --out einen anderen."),
    "out_folder_in_the_way": (["fit", "a.csv", "--out", "../taken"], "../taken/fit.json ist ein Ordner; "),
    "out_foreign": (["fit", "a.csv", "--out", "../mine"], "In ../mine liegt schon fit.json: nicht von einem früheren Lauf, oder seither geändert; "),
    "out_is_folder": (["derive", "3", "--format", "md", "--out", "."], ". lässt sich nicht schreiben: Es ist ein Ordner; nehmen Sie mit --out eine andere Datei."),
    "out_file_unwritable": (["derive", "3", "--out", "no/a.md"], "no/a.md lässt sich nicht schreiben: No such file or directory; "),
    "derive_equation": (["derive", "7"], "Die Herleitung hat keine Gleichung '7'; in der Nähe sind (6), (6b), (6c), (8)."),
    "derive_format": (["derive", "--format", "pdf"], "Das Format 'pdf' gibt es nicht; wählen Sie eines von html, md, latex, text."),
    "derive_format_untold": (["derive", "--out", "a.doc"], "Der Name a.doc sagt nicht, welches Format gemeint ist; lassen Sie ihn auf .html, "),
    "derive_two": (["derive", "--check", "--misprints"], "--check und --misprints sind zwei Befehle; geben Sie einen davon."),
    "derive_json": (["derive", "--json"], "--json druckt, was --check oder --misprints findet; ergänzen Sie eines davon, "),
    "derive_check": (["derive", "--check", "--out", "a.txt"], "schreibt eine Seite nur als HTML; lassen Sie --out weg."),
    "derive_misprints": (["derive", "3", "--misprints"], "eine Liste in das Terminal; lassen Sie EQUATION weg."),
    "derive_handout": (["derive", "3", "--handout"], "eine Datei, die auf .html endet; lassen Sie EQUATION weg."),
    "option_needed": (["fit", "--plan", "--rate", "30"], '--plan braucht --length; schreiben Sie etwa --length "3 m".'),
    "option_positive": (["fit", "a.csv", "--length", "-1"], '--length ist -1 m; schreiben Sie einen positiven Wert, etwa "3 cm".'),
    "option_number": (["fit", "a.csv", "--swings", "two"], "--swings ist 'two'; schreiben Sie eine Zahl über 3."),
    "option_share": (["fit", "a.csv", "--tilt", "101 %"], "--tilt ist '101 %'; schreiben Sie Prozent von 0 bis unter 100, etwa 10."),
    "option_columns": (["fit", "a.csv", "--columns", "time"], "--columns ist 'time'; schreiben Sie es wie time=t,x=cx,y=cy "),
    "option_no_track": (["fit"], "Welche Spur? Schreiben Sie kugelpendel fit DATEI, "),
    "option_plan_of_track": (["fit", "a.csv", "--plan"], "--plan ist für die Zeit, ehe es eine Spur gibt; "),
    "follow_foreign": (["fit", "a.csv", "--follow", "--out", "../foreign"], "In ../foreign liegt schon swings.csv, das kein --follow dieser Datei gemacht hat; "),
    "follow_unread": (["fit", "a.csv", "--follow", "--out", "../unread"], "../unread/follow.json lässt sich nicht lesen: "),
    "follow_other": (["fit", "a.csv", "--follow", "--out", "../other"], "In ../other sind die Schwingungen von b.csv; nehmen Sie mit --out einen anderen Ordner."),
    "option_no_name": (["fit", ""], "Ein leerer Name nennt weder Datei noch Ordner; "),
    "option_no_user": (["derive", "--out", "~nobody-of-that-name/a.md"], "~nobody-of-that-name/a.md: Es gibt niemanden, der so heißt; "),
    "option_several_files": (["sweep", "a.toml", "--out", "-"], "--out -: Mehrere Dateien passen nicht in die Standardausgabe; "),
}  # fmt: skip
"""Of each kind what is called, and a part of what is said."""

THERE = {
    "mine/fit.json": "{}",
    "foreign/swings.csv": "",
    "unread/follow.json": "{",
    "other/follow.json": '{"file": "b.csv"}',
}
"""What is in the way of some."""


@pytest.fixture
def write(tmp_path: Path) -> Callable[[dict[str, str | None] | bytes], Path]:
    """Write the usual sweep with some entries changed, or a file of these bytes."""

    def write(given: dict[str, str | None] | bytes) -> Path:
        path = tmp_path / "sweep.toml"
        if isinstance(given, bytes):
            path.write_bytes(given)
            return path
        tables: dict[str, dict[str, str | None]] = {name: {**SWEEP[name]} for name in SWEEP}
        for name, value in given.items():
            table, _, key = name.partition(".")
            tables.setdefault(table, {})[key] = value
        lines = [
            f"[{name}]\n" + "".join(f"{k} = {v}\n" for k, v in table.items() if v is not None)
            for name, table in tables.items()
        ]
        path.write_text("".join(lines), encoding="utf-8")
        return path

    return write


def pattern(kind: str, language: Language) -> str:
    """What is said of a kind, with anything in its holes."""
    entry = read(language)["kinds"][kind]
    parts = string.Formatter().parse(entry.get("file", entry["python"]))
    return "".join(re.escape(said) + ("" if hole is None else ".*") for said, hole, _, _ in parts)


def is_said(outcome: Any, kind: str, part: str) -> None:
    """A refusal in German, and in no other language."""
    assert outcome.code == 2, outcome
    assert outcome.out == ""
    assert part in outcome.err
    assert re.search(pattern(kind, "de"), outcome.err), outcome.err
    assert not re.search(pattern(kind, "en"), outcome.err), outcome.err


@pytest.mark.parametrize("kind", FILES)
def test_of_a_file(call: Any, write: Any, kind: str) -> None:
    given, part = FILES[kind]
    is_said(call("sweep", write(given), "--lang", "de"), kind, part)
    assert list(Path.cwd().iterdir()) == []


@pytest.mark.parametrize("kind", ARGUMENTS)
def test_of_what_is_called(call: Any, write: Any, kind: str) -> None:
    write({})
    Path("../taken/fit.json").mkdir(parents=True)
    for name, content in THERE.items():
        Path("..", name).parent.mkdir()
        Path("..", name).write_text(content)
    arguments, part = ARGUMENTS[kind]
    is_said(call(*arguments, "--lang", "de"), kind, part)
    assert list(Path.cwd().iterdir()) == []


class _Broken(io.RawIOBase):
    def readinto(self, _: Any) -> int:
        raise OSError(5, "Input/output error")

    def readable(self) -> bool:
        return True


STDIN: dict[str, tuple[Any, str]] = {
    "file_stdin_closed": (None, "Die Standardeingabe ist geschlossen; "),
    "file_stdin_unread": (_Broken(), "lässt sich nicht lesen: Input/output error."),
}


@pytest.mark.parametrize("kind", STDIN)
def test_of_standard_input(call: Any, monkeypatch: pytest.MonkeyPatch, kind: str) -> None:
    raw, part = STDIN[kind]
    stdin = raw and io.TextIOWrapper(io.BufferedReader(raw))
    monkeypatch.setattr(sys, "stdin", stdin)
    is_said(call("sweep", "-", "--lang", "de"), kind, part)


FULL = OSError(28, "No space left on device")
MOVES: dict[str, tuple[str, Exception, str]] = {
    "out_unwritable": ("Stage", FULL, "lässt sich nicht beschreiben: No space left on device; nehmen Sie mit --out einen anderen."),
    "out_failed": ("_publish", FULL, "No space left on device; nichts ist halb geschrieben, "),
    "out_unfinished": ("_publish", Unfinished(FULL), "konnten nicht alle zurückgelegt werden. Sie sind alle in "),
}  # fmt: skip
"""Of each kind what fails and how, and a part of what is said."""


@pytest.mark.parametrize("kind", MOVES)
def test_of_a_folder_that_takes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    name, error, part = MOVES[kind]

    def fail(*_: object) -> None:
        raise error

    monkeypatch.setattr(files, name, fail)
    with pytest.raises(kp.InvalidInput) as raised, files.staged(tmp_path / "out", []):
        pass
    is_said(Outcome(2, "", raised.value.sentence("de", "file")), kind, part)


def test_of_standard_output(monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    class Full(io.StringIO):
        def write(self, _: str) -> int:
            raise FULL

    monkeypatch.setattr(sys, "stdout", Full())
    code = main(["derive", "--misprints", "--lang", "de"])
    part = "Die Standardausgabe nimmt nichts auf: No space left on device; "
    is_said(Outcome(code, "", capsys.readouterr().err), "out_stream", part)


def test_of_a_command_that_is_broken(call: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "kugelpendel.cli.derive.command", None)
    outcome = call("derive", "--lang", "de")
    part = "`kugelpendel derive` lässt sich nicht ausführen: import of kugelpendel.cli.derive"
    is_said(outcome, "option_cannot_run", part)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--lang", "fr", "--out", "-"], "several files do not fit"),
        (["--lang=de", "--out", "-"], "Mehrere Dateien passen nicht"),
        (["--out", "-", "--lang"], "several files do not fit"),
    ],
)
def test_the_language_of_arguments_that_are_refused(
    call: Any, arguments: list[str], said: str
) -> None:
    outcome = call("sweep", "a.toml", *arguments)
    assert outcome.code == 2
    assert said in outcome.err


def test_a_command_of_one_language_refuses_in_it(
    call: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "de_DE.UTF-8")
    assert "several files do not fit" in call("run", "a.toml", "--out", "-").err
    assert "Mehrere Dateien passen nicht" in call("sweep", "a.toml", "--out", "-").err


SAID = {*FILES, *ARGUMENTS, *STDIN, *MOVES, "out_stream", "option_cannot_run"}


def test_none_is_left_out() -> None:
    kinds = {kind for kind in read("de")["kinds"] if kind.startswith(ROOMS)}
    assert kinds == {kind for kind in SAID if kind.startswith(ROOMS)}
