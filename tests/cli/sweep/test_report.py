"""What a sweep says in the end: counts, distributions, bad cases, and what moves a result."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

from kugelpendel.cli.sweep.as_json import as_json
from kugelpendel.cli.sweep.figures import figures
from kugelpendel.cli.sweep.report import report
from kugelpendel.sweeps import Listed, Spaced, Sweep, Uniform, sweep

HOUR = 3600.0


@pytest.fixture(autouse=True)
def _wide(monkeypatch: pytest.MonkeyPatch) -> None:
    """Room for every table in one piece."""
    monkeypatch.setenv("COLUMNS", "220")


GROUND = {
    "pendulum": {"length": 20.0},
    "launch": {"kind": "ellipse", "a": 0.8, "b": 0.0},
    "site": {"latitude": 0.9},
}


def given(**tables):
    return {**GROUND, **tables}


def test_a_sample_is_told_by_its_quantiles(tmp_path: Path) -> None:
    spec = Sweep(
        given(launch={"kind": "ellipse", "a": Uniform(0.5, 1.0), "b": Uniform(-0.01, 0.01)}),
        "sample", "averaged", ["azimuth", "b"], [6 * HOUR], 500, 3,
    )  # fmt: skip
    found = sweep(spec, tmp_path)
    said = report(spec, found)
    lines = said.splitlines()
    assert lines[0].split()[:2] == ["cases", "500"]
    told = "averaged motions, a random sample, over amplitude a, width b at the launch"
    assert told in " ".join(said.split())
    row = next(line for line in lines if "azimuth after 6.00 h" in line)
    cells = row.strip().removeprefix("azimuth after 6.00 h").split()
    values = np.degrees(found["azimuth"].values[:, 0])
    expected = [values.min(), *np.quantile(values, [0.05, 0.25, 0.5, 0.75, 0.95]), values.max()]
    assert (cells[0], cells[-1]) == ("°", "500")
    numbers = [float(cell.replace("−", "-")) for cell in cells[1:-1]]
    np.testing.assert_allclose(numbers, expected, rtol=1e-3)
    assert set(figures(spec, found)) == {"azimuth", "b"}


@pytest.mark.parametrize(
    ("spec", "said"),
    [
        (("sample", "exact", ["period"], (), 500), "Quantiles are those of one case in 5."),
        (("sobol", "exact", ["period"], (), 128), "Quantiles are those of one case in 8."),
        (("grid", "exact", ["period"]), "those of one level in 3 of the first number."),
    ],
)
def test_of_very_many_cases_evenly_spread_ones_are_sorted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, spec: tuple, said: str
) -> None:
    monkeypatch.setattr("kugelpendel.sweeps._reductions.MOST_SORTED", 100)
    monkeypatch.setattr("kugelpendel.cli.sweep.report.MOST_SORTED", 100)
    count = 16 if spec[0] == "grid" else None
    launch = {"kind": "ellipse", "a": Spaced(0.5, 1.0, count), "b": Spaced(0.0, 0.1, count)}
    swept = Sweep({"pendulum": {"length": 20.0}, "launch": launch}, *spec)
    found = sweep(swept, tmp_path)
    assert said in " ".join(report(swept, found).split())
    values = found["period"].values
    values = values[::3].ravel() if spec[0] == "grid" else values[:: -(-values.size // 100)]
    (told,) = json.loads(as_json(swept, found))["results"]
    assert told["quantiles"]["0.5"] == np.median(values) != np.median(found["period"].values)


def test_bad_cases_are_counted_and_the_first_are_named_with_their_sentences(tmp_path: Path) -> None:
    lengths = tuple([20.0] * 40 + [-3.0] * 5 + [20.0] * 5)
    spec = Sweep(
        given(pendulum={"length": Listed(lengths)}), "grid", "averaged", ["azimuth"], [HOUR]
    )
    said = report(spec, sweep(spec, tmp_path))
    lines = said.splitlines()
    assert any(line.split()[:2] == ["good", "45"] for line in lines)
    assert any(line.split()[:2] == ["refused", "5"] for line in lines)
    assert "case 40 (length = −3 m): The pendulum's length must be" in " ".join(said.split())
    assert "case 44" in said


def test_cases_that_end_say_why(tmp_path: Path) -> None:
    launch = {"kind": "angles", "theta": Spaced(0.1, 2.0, 4), "phi_rate": 0.1}
    spec = Sweep(
        {"pendulum": {"length": 1.0}, "launch": launch}, "grid", "real", ["largest_b"], [20.0]
    )
    said = " ".join(report(spec, sweep(spec, tmp_path)).split())
    assert "ended early 1 case 3 (angle of the launch θ = 114.592°): " in said
    assert "slack" in said


def test_where_a_plane_stalls_is_a_share_and_the_portrait_stands_beside_it(tmp_path: Path) -> None:
    spec = Sweep(
        given(suspension={"anisotropy": Spaced(1e-6, 1e-3, 4, log=True), "axis": 0.7}),
        "grid", "averaged", ["stalls", "clamp_stalls", "final_direction"],
    )  # fmt: skip
    found = sweep(spec, tmp_path)
    said = " ".join(report(spec, found).split())
    share = 100 * float(found["stalls"].mean())
    assert f"stalls in {share:.3g} % of 4 cases: the plane, with all that acts, turns" in said
    assert "the portrait of the clamp says agree in 4 of 4 cases." in said
    assert set(figures(spec, found)) == {"stalls", "clamp_stalls", "final_direction"}


def test_a_sobol_design_says_what_moves_a_result(tmp_path: Path) -> None:
    tables = given(
        launch={"kind": "ellipse", "a": Uniform(0.79, 0.81), "b": 0.0},
        suspension={"anisotropy": Uniform(0.0, 4e-6), "axis": Uniform(0.0, math.pi)},
    )
    spec = Sweep(tables, "sobol", "averaged", ["azimuth"], [3 * HOUR], 1024, 1)
    found = sweep(spec, tmp_path)
    said = " ".join(report(spec, found).split())
    assert "1 024 base points of a Sobol design" in said
    assert "the clamp's unevenness together with its direction: align the axis." in said
    assert "direction of the clamp χ × unevenness of the clamp δ" in said
    drawn = figures(spec, found)
    assert set(drawn) == {"azimuth", "azimuth-causes"}


def test_blocks_with_a_bad_case_are_said_to_be_left_out(tmp_path: Path) -> None:
    tables = given(
        launch={"kind": "ellipse", "a": Uniform(-0.02, 1.0), "b": 0.0},
        suspension={"anisotropy": Uniform(0.0, 2e-5), "axis": 0.7},
    )
    spec = Sweep(tables, "sobol", "averaged", ["azimuth"], [3 * HOUR], 128, 1)
    said = " ".join(report(spec, sweep(spec, tmp_path)).split())
    assert " blocks of 6 cases have a case without an answer and are left out; " in said


def test_what_was_only_reduced_is_told_from_that(tmp_path: Path) -> None:
    launch = {"kind": "ellipse", "a": Uniform(0.5, 1.0), "b": 0.01}
    spec = Sweep(
        given(launch=launch), "sample", "averaged", ["azimuth"], [HOUR, 2 * HOUR], 400, 3,
        keep=["moments", "quantiles", "histograms"],
    )  # fmt: skip
    found = sweep(spec, tmp_path)
    said = report(spec, found)
    row = next(line for line in said.splitlines() if "azimuth after 2.00 h" in line)
    middle = float(np.degrees(found["azimuth_quantile"].sel(quantile=0.5).values[1]))
    assert f"{middle:.2f}".replace("-", "−") in row
    assert set(figures(spec, found)) == {"azimuth-1", "azimuth-2"}


@pytest.mark.parametrize("levels", [1, 3])
def test_figures_of_a_grid(levels: int, tmp_path: Path) -> None:
    tables = given(
        launch={"kind": "ellipse", "a": Spaced(0.4, 0.8, 5), "b": Listed(tuple(range(levels)))},
    )
    spec = Sweep(tables, "grid", "averaged", ["azimuth"], [HOUR])
    drawn = figures(spec, sweep(spec, tmp_path))
    assert set(drawn) == {"azimuth"}
    axes = drawn["azimuth"].axes[0]
    assert axes.get_xlabel() == "amplitude a, cm"
    assert (axes.get_ylabel() == "azimuth, °") == (levels == 1)


def test_a_german_report_is_german_to_the_last_word(tmp_path: Path) -> None:
    spec = Sweep(
        given(pendulum={"length": Listed((20.0, -3.0))}), "grid", "averaged", ["azimuth"], [HOUR]
    )
    said = " ".join(report(spec, sweep(spec, tmp_path), "de").split())
    assert "Fall 1 (Länge = −3 m): Die Länge des Pendels muss" in said
    english = {"case", "cases", "good", "refused", "result", "length", "must", "after", "over"}
    assert english.isdisjoint(said.lower().replace(",", " ").split())


def test_a_german_figure_is_german(tmp_path: Path) -> None:
    spec = Sweep(
        given(suspension={"anisotropy": Spaced(1e-6, 1e-3, 4, log=True), "axis": 0.7}),
        "grid", "averaged", ["azimuth"], [HOUR],
    )  # fmt: skip
    figure = figures(spec, sweep(spec, tmp_path), "de")["azimuth"]
    assert "Ungleichheit der Klemme δ" in figure.axes[0].get_xlabel()
    assert "Azimut" in figure.axes[0].get_ylabel()
