"""Figures of sweeps: what stands at the axes, what is hatched, and what is refused."""

# matplotlib's stubs know less of what has been drawn than matplotlib does.
# pyright: reportAttributeAccessIssue=false, reportArgumentType=false, reportCallIssue=false
# pyright: reportIndexIssue=false, reportOptionalMemberAccess=false, reportOptionalSubscript=false
import math

import numpy as np
import pytest
import xarray as xr
from matplotlib.collections import QuadMesh
from matplotlib.quiver import Quiver

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.sweeps._sensitivity import Sensitivity, Share

CLAMP, SIZE, AZIMUTH = "suspension.anisotropy", "launch.a", "launch.azimuth"


def grid(third: int = 1) -> xr.Dataset:
    delta = np.geomspace(1e-6, 1e-3, 9)
    a = np.linspace(0.02, 0.4, 11)
    azimuth = np.linspace(0.0, math.pi / 2, third)
    d, size, start = np.meshgrid(delta, a, azimuth, indexing="ij")
    after = np.stack([-1.0 - d * 1e3 + size, -2.0 - d * 2e3 + size], axis=-1)
    after[0, 0, 0] = math.nan
    dims = (CLAMP, SIZE, AZIMUTH)
    noted = {"units": "rad"}
    return xr.Dataset(
        {
            "azimuth": ((*dims, "time"), after, noted),
            "stalls": (dims, (d > 1e-4 * (1 + start)).astype(float), {"units": "1"}),
            "clamp_stalls": (dims, (d > 0.9e-4 * (1 + start)).astype(float), {"units": "1"}),
            "final_direction": (
                dims, np.where(d > 1e-4, (4 * size + start) % math.pi, math.nan), noted,
            ),
            "quarter_turn": (dims, np.where(d > 1e-4, math.inf, 2e4 + 1e5 * size), {"units": "s"}),
        },
        coords={
            CLAMP: (CLAMP, delta, {"units": "rad/s"}),
            SIZE: (SIZE, a, {"units": "m"}),
            AZIMUTH: (AZIMUTH, azimuth, noted),
            "time": ("time", np.array([3600.0, 6 * 3600.0]), {"units": "s"}),
        },
    )  # fmt: skip


def legend(figure) -> list[str]:
    return [text.get_text() for one in figure.legends for text in one.get_texts()]


def meshes(axes) -> list[QuadMesh]:
    return [drawn for drawn in axes.collections if isinstance(drawn, QuadMesh)]


def test_a_map_has_units_contours_and_the_last_time() -> None:
    figure = plot.sweeps.values_map(grid(), "azimuth")
    axes, bar = figure.axes
    assert axes.get_xlabel() == "unevenness of the clamp δ, rad/s"
    assert axes.get_ylabel() == "amplitude a, cm"
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "linear")
    assert bar.get_ylabel() == "azimuth, °"
    assert figure.get_suptitle() == "Azimuth after 6.00 h"
    (mesh,) = meshes(axes)
    seen = np.degrees(grid()["azimuth"].values[:, :, 0, 1].T)
    np.testing.assert_allclose(mesh.get_array().filled(math.nan), seen)
    assert any(type(drawn).__name__ == "QuadContourSet" for drawn in axes.collections)
    assert legend(figure) == ["no answer"]
    # Cells reach as far beyond the outer values as between them, in the logarithm here.
    assert axes.get_xlim() == pytest.approx((1e-6 / 10**0.1875, 1e-3 * 10**0.1875))


def test_another_time_and_cells_without_an_end() -> None:
    figure = plot.sweeps.values_map(grid(), "azimuth", 3600.0, "Mine")
    assert figure.get_suptitle() == "Mine"
    (mesh,) = meshes(figure.axes[0])
    assert mesh.get_array()[0, 1] == pytest.approx(np.degrees(-1.0 - 10**-2.625 + 0.02))
    infinite = plot.sweeps.values_map(grid(), "quarter_turn")
    (mesh,) = meshes(infinite.axes[0])
    assert mesh.get_array().mask.sum() == (grid()["stalls"].values == 1).sum()
    assert infinite.axes[1].get_ylabel() == "quarter turn, h"


def test_a_third_number_goes_from_panel_to_panel() -> None:
    figure = plot.sweeps.values_map(grid(9), "azimuth")
    titles = [axes.get_title() for axes in figure.axes[:-1]]
    assert titles[0] == "azimuth of the launch = 0°"
    assert titles[-1] == "azimuth of the launch = 90°"
    assert len(titles) == 6
    assert figure.axes[0].get_xlabel() == ""
    assert figure.axes[3].get_xlabel() == "unevenness of the clamp δ, rad/s"


def test_of_very_many_levels_evenly_spread_ones_are_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kugelpendel.plot.sweeps._plane._CELLS", 4)
    (mesh,) = meshes(plot.sweeps.values_map(grid(), "azimuth").axes[0])
    seen = np.degrees(grid()["azimuth"].values[::3, ::3, 0, 1].T)
    np.testing.assert_allclose(mesh.get_array().filled(math.nan), seen)


def test_regions_have_tint_hatch_and_the_border_of_the_portrait() -> None:
    figure = plot.sweeps.regions(grid(3), "stalls", "clamp_stalls", "Where it stalls")
    assert legend(figure) == ["the plane goes round", "it stalls", "border by the portrait"]
    for axes in figure.axes:
        hatches = [one.get_hatch() for one in axes.collections]
        assert "///" in hatches
        (border,) = (one for one in axes.collections if type(one).__name__ == "QuadContourSet")
        (path,) = border.get_paths()
        assert len(path.vertices) > 4
    bad = grid()
    bad["stalls"][2, 3] = math.nan
    assert "no answer" in legend(plot.sweeps.regions(bad, "stalls"))


def test_basins_go_round_in_a_circle_and_have_strokes() -> None:
    figure = plot.sweeps.basins(grid())
    axes, bar = figure.axes
    (mesh,) = meshes(axes)
    ends = mesh.get_cmap()(np.array([0.0, 1.0]))[:, :3]
    assert np.abs(ends[0] - ends[1]).max() < 0.02
    assert mesh.get_clim() == (0, 180)
    strokes = [drawn for drawn in axes.collections if isinstance(drawn, Quiver)]
    seen = np.isfinite(grid()["final_direction"].values[..., 0].T)
    assert [stroke.N for stroke in strokes] == [seen.sum()] * 2
    angle = np.arctan2(strokes[0].V, strokes[0].U) % math.pi
    np.testing.assert_allclose(angle, grid()["final_direction"].values[..., 0].T[seen])
    assert bar.get_ylabel() == "final direction, ° counter-clockwise from east"
    assert legend(figure) == ["the plane goes round, or no answer"]


def test_a_curve_over_one_number() -> None:
    data = grid().isel({SIZE: [3], AZIMUTH: [0]})
    (axes,) = plot.sweeps.curve(data, "azimuth").axes
    x, y = axes.lines[0].get_data()
    np.testing.assert_allclose(x, np.geomspace(1e-6, 1e-3, 9))
    np.testing.assert_allclose(y, np.degrees(data["azimuth"].values[:, 0, 0, 1]))
    assert axes.get_ylabel() == "azimuth, °"


def test_of_very_many_cases_evenly_spread_ones_are_sorted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kugelpendel.sweeps._reductions.MOST_SORTED", 1000)
    values = np.random.default_rng(1).normal(-1.5, 0.1, 20_007)
    values[:7] = math.nan
    (axes,) = plot.sweeps.distribution(values, "azimuth", "rad").axes
    places = [line.get_xdata()[0] for line in axes.lines]
    sorted_ones = np.degrees(values[7::20])
    np.testing.assert_allclose(
        places, np.quantile(sorted_ones, [0.05, 0.5, 0.95], method="inverted_cdf"), rtol=1e-14
    )
    assert "7 of 20 007 cases have no answer" in [text.get_text() for text in axes.texts]


def test_a_distribution_has_its_quantiles_and_counts_what_is_left_out() -> None:
    random = np.random.default_rng(1)
    values = random.normal(-1.5, 0.1, 20_000)
    values[:7] = math.nan
    (axes,) = plot.sweeps.distribution(values, "azimuth", "rad").axes
    places = [line.get_xdata()[0] for line in axes.lines]
    np.testing.assert_allclose(
        places, np.degrees(np.nanquantile(values, [0.05, 0.5, 0.95])), rtol=1e-3
    )
    texts = [text.get_text() for text in axes.texts]
    assert texts[1].startswith("50 %: −86.0°")
    assert "7 of 20 000 cases have no answer" in texts
    # The bars of all but 2 in 10 000 cases.
    heights = axes.patches[0].get_data().values
    assert heights.sum() == pytest.approx(100.0, abs=0.05)


def test_counts_of_bins_make_the_same_distribution() -> None:
    values = np.repeat([0.1, 0.2, 0.3], [10, 60, 30])
    one = plot.sweeps.distribution(values, "b", "m").axes[0]
    other = plot.sweeps.distribution(
        np.array([0.3, 0.1, 0.2]), "b", "m", counts=np.array([30.0, 10.0, 60.0])
    ).axes[0]
    for first, second in zip(one.patches, other.patches, strict=True):
        np.testing.assert_allclose(first.get_data().values, second.get_data().values)
    assert [t.get_text() for t in one.texts] == [t.get_text() for t in other.texts]


def test_shares_are_drawn_with_their_intervals_the_largest_first() -> None:
    shares = {"launch.b": Share(0.1, 0.02), CLAMP: Share(0.7, 0.05)}
    pair = {("launch.b", CLAMP): Share(0.95, 0.03)}
    found = Sensitivity(("launch.b", CLAMP), shares, shares, pair, pair, 64, 0)
    figure = plot.sweeps.shares(found, "What moves it")
    (axes,) = figure.axes
    labels = [label.get_text() for label in axes.get_yticklabels()]
    assert labels == [
        "unevenness of the clamp δ",
        "width b at the launch",
        "width b at the launch × unevenness of the clamp δ",
    ]
    first = axes.containers[0]
    assert first.lines[0].get_xdata()[0] == pytest.approx(70.0)
    assert np.ptp(first.lines[2][0].get_segments()[0][:, 0]) == pytest.approx(10.0)
    assert legend(figure) == ["alone", "with all others: gone if it were held", "two together"]


def test_refused() -> None:
    one = grid().isel({SIZE: [0], AZIMUTH: [0]})
    with pytest.raises(kp.InvalidInput, match="a grid over two numbers at least"):
        plot.sweeps.values_map(one, "azimuth")
    with pytest.raises(kp.InvalidInput, match="a grid over one number"):
        plot.sweeps.curve(grid(), "azimuth")
    with pytest.raises(kp.InvalidInput, match='None of 3 cases has an answer for "b"'):
        plot.sweeps.distribution(np.full(3, math.nan), "b", "m")
