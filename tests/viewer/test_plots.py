"""Plots of runs and sweeps, and what trajectories become for pandas, xarray and notebooks."""

from __future__ import annotations

import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

import solver
from solver.runtime import OptionError
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES
from viewer import plots

PENDULUM = SCENES / "double_pendulum.toml"
CRANK = SCENES / "slider_crank.toml"
FIRST_BYTES = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}
SHORT = ("--stop", "0.05", "--step", "0.01")


def trajectory(**options):
    return solver.simulate(PENDULUM, stop_time=0.5, step_size=0.05, **options)


def curves(figure) -> dict[str, list[str]]:
    return {
        plot.get_ylabel(): [line.get_label() for line in plot.get_lines()] for plot in figure.axes
    }


def test_without_names_the_outputs_of_the_scene_are_chosen_else_energies_and_errors():
    usual = ["A.x", "energy.total", "energy.error", "constraint.position"]
    assert plots.chosen([*usual, "reach"]) == ["reach"]
    assert plots.chosen(usual) == usual[1:]
    assert plots.chosen(["A.x", "A.y"]) == ["A.x", "A.y"]


def test_inputs_are_not_taken_for_outputs_of_the_scene():
    model = solver.assemble(solver.load(SCENES / "slider_crank.toml"))
    cart = next(v for v in model.variables if v.causality == "output")
    drive = cart._replace(name="drive", causality="input")
    assert plots.chosen(["drive", "energy.error"], None, [drive]) == ["energy.error"]
    assert plots.chosen(["drive", "energy.error"], "dr*", [drive]) == ["drive"]


def test_nothing_is_imported_for_plots_by_runs_without_them():
    code = "import sys, holonom, build_fmu.commands.simulate, build_fmu.commands.sweep\n"
    code += f"holonom.simulate({str(PENDULUM)!r}, stop_time=0.1)\n"
    code += "assert not {'viewer.plots', 'matplotlib', 'xarray'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], cwd=SCENES.parent, check=True)


def test_patterns_choose_in_their_order_and_each_name_once():
    names = ["A.x", "A.y", "energy.total"]
    assert plots.chosen(names, ["energy.*", "A.x", "*"]) == ["energy.total", "A.x", "A.y"]


def test_a_pattern_that_matches_nothing_is_answered_with_the_nearest_name():
    with pytest.raises(OptionError, match=r"plot: 'A\.X' matches none of the 2 .*A\.x"):
        plots.chosen(["A.x", "A.y"], ["A.X"])


def test_a_figure_has_one_plot_for_each_unit_with_the_values_of_the_run():
    pytest.importorskip("matplotlib")
    found = trajectory()
    figure = found.plot(["A.x", "energy.total", "B.y"])
    assert curves(figure) == {"[m]": ["A.x", "B.y"], "[J]": ["energy.total"]}
    line = figure.axes[0].get_lines()[1]
    assert np.array_equal(line.get_xdata(), found.t)
    assert np.array_equal(line.get_ydata(), found["B.y"])
    assert figure.get_suptitle() == "double_pendulum"


def test_more_variables_than_one_tells_apart_are_refused():
    pytest.importorskip("matplotlib")
    with pytest.raises(OptionError, match=r"32 variables are more than the 24 .* name fewer"):
        trajectory().plot("*")


@pytest.mark.parametrize("form", plots.FORMATS)
def test_the_same_run_gives_the_same_file(capsys, tmp_path, form):
    pytest.importorskip("matplotlib")
    files = [tmp_path / f"{name}{form}" for name in "ab"]
    for file in files:
        arguments = ("--plot", file, "--plot-of", "energy.*", "--csv", tmp_path / "a.csv")
        code, _, err = run(capsys, "simulate", PENDULUM, *SHORT, *arguments)
        assert (code, err) == (0, f"{file}: plot\n")
    first, second = (file.read_bytes() for file in files)
    assert first == second
    assert first.startswith(FIRST_BYTES[form])


@pytest.mark.parametrize("command", ["simulate", "sweep"])
@pytest.mark.parametrize(
    ("arguments", "code", "sentence"),
    [
        (("--plot", "a.gif"), 2, "--plot a.gif: the name must end in one of .png, .svg, .pdf"),
        (("--plot", "plot"), 2, "--plot plot: the name must end in one of .png, .svg, .pdf"),
        (("--plot-of", "A.x"), 2, "--plot-of chooses what --plot FILE shows; give that too"),
        (
            ("--plot", "a.png"),
            4,
            "the package matplotlib is missing; install it: pip install 'holonom[plot]'",
        ),
    ],
)
def test_what_cannot_be_plotted_is_refused_before_a_run(
    capsys, monkeypatch, tmp_path, command, arguments, code, sentence
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    grid = ("--grid", "mass=1,2") if command == "sweep" else ("--csv", "a.csv")
    assert run(capsys, command, PENDULUM, *grid, *arguments) == (code, "", f"holonom: {sentence}\n")
    assert list(tmp_path.iterdir()) == []


def test_a_wrong_name_ends_with_2_and_keeps_the_csv_file(capsys, tmp_path):
    pytest.importorskip("matplotlib")
    files = ("--plot", tmp_path / "a.png", "--csv", tmp_path / "a.csv")
    code, _, err = run(capsys, "simulate", PENDULUM, *SHORT, *files, "--plot-of", "A.X")
    assert code == 2
    assert "did you mean 'A.x'?" in err
    assert [path.name for path in tmp_path.iterdir()] == ["a.csv"]


# ------------------------------------------------------------------------------------ sweeps

UNITS = {"mass": "kg", "A.x": "m"}


def summary(*last):
    """Last, smallest and largest values."""
    return {"A.x": np.array([last, np.subtract(last, 1.0), np.add(last, 1.0)])}


def test_over_one_parameter_an_output_is_a_curve_in_the_order_of_the_values():
    pytest.importorskip("matplotlib")
    figure = plots.over_values({"mass": [3.0, 1.0, 2.0]}, summary(30.0, 10.0, np.nan), UNITS)
    (plot,) = figure.axes
    (line,) = plot.get_lines()
    assert list(line.get_xdata()) == [1.0, 2.0, 3.0]
    assert list(line.get_ydata()) == pytest.approx([10.0, np.nan, 30.0], nan_ok=True)
    assert (plot.get_xlabel(), plot.get_ylabel()) == ("mass [kg]", "A.x [m]")


def test_over_two_parameters_an_output_is_a_heat_map_with_gaps_at_failed_runs():
    pytest.importorskip("matplotlib")
    varied = {"mass": [1.0, 1.0, 2.0, 2.0], "length": [3.0, 4.0, 3.0, 4.0]}
    figure = plots.over_values(varied, summary(13.0, 14.0, np.nan, 24.0), UNITS)
    plot, bar = figure.axes
    cells = plot.collections[0].get_array()
    assert cells[:, 0].tolist() == [13.0, 14.0]
    assert bool(np.isnan(np.ma.filled(cells, np.nan)[0, 1]))
    assert cells[1, 1] == 24.0
    assert (plot.get_xlabel(), plot.get_ylabel(), bar.get_ylabel()) == (
        "mass [kg]",
        "length",
        "A.x [m] at the end",
    )
    assert (list(plot.get_xticks()), list(plot.get_yticks())) == ([1.0, 2.0], [3.0, 4.0])
    assert [text.get_text() for text in plot.texts] == ["hatched: failed"]


def test_ranges_with_log_have_a_logarithmic_axis_and_words_stand_side_by_side():
    pytest.importorskip("matplotlib")
    varied = {"mass": [1.0, 10.0, 100.0] * 2, "solver.start": ["a"] * 3 + ["b"] * 3}
    plot = plots.over_values(varied, summary(*range(6)), UNITS).axes[0]
    assert (plot.get_xscale(), plot.get_yscale()) == ("log", "linear")
    assert [label.get_text() for label in plot.get_yticklabels()] == ["a", "b"]


def test_cells_of_a_heat_map_on_a_logarithmic_axis_are_whole_and_of_one_size():
    """From 1e-3/sqrt 10 to sqrt 10; half way between 1e-3 and 0 there is no logarithm."""
    pytest.importorskip("matplotlib")
    values = [1e-3, 1e-2, 1e-1, 1.0]
    varied = {"mass": values * 2, "length": [1.0] * 4 + [2.0] * 4}
    plot = plots.over_values(varied, summary(*range(8)), UNITS).axes[0]
    mesh = np.asarray(plot.collections[0].get_coordinates())
    assert mesh[0, :, 0] == pytest.approx(10.0 ** np.arange(-3.5, 1.0))
    assert mesh[:, 0, 1] == pytest.approx([0.5, 1.5, 2.5])
    assert plot.get_xlim() == pytest.approx((10.0**-3.5, 10.0**0.5))


def test_a_heat_map_needs_a_full_grid():
    pytest.importorskip("matplotlib")
    varied = {"mass": [1.0, 2.0], "length": [3.0, 4.0]}
    with pytest.raises(OptionError, match="the runs are no full grid of mass and length"):
        plots.over_values(varied, summary(1.0, 2.0), UNITS)


def test_a_sweep_is_plotted(capsys, tmp_path):
    pytest.importorskip("matplotlib")
    files = ("-o", tmp_path / "a.csv", "--plot", tmp_path / "a.svg", "--plot-of", "A.x,B.*")
    grid = ("--grid", "mass=1,2", "--grid", "length=1,2")
    code, _, err = run(capsys, "sweep", PENDULUM, *SHORT, *grid, *files, "--engine", "serial")
    assert (code, err) == (0, f"{tmp_path / 'a.svg'}: plot\n")
    assert ElementTree.parse(tmp_path / "a.svg").getroot().tag.endswith("svg")


def test_a_sweep_plots_all_outputs_that_were_asked_for(capsys, tmp_path):
    pytest.importorskip("matplotlib")
    files = ("-o", tmp_path / "a.csv", "--plot", tmp_path / "a.svg")
    asked = ("--grid", "mass=1,2", "--output", "A.x,energy.error,constraint.velocity")
    assert run(capsys, "sweep", PENDULUM, *SHORT, *asked, *files, "--engine", "serial")[0] == 0
    drawn = (tmp_path / "a.svg").read_text(encoding="utf-8")
    assert [name in drawn for name in asked[-1].split(",")] == [True] * 3


def test_a_sweep_of_three_parameters_is_refused_before_it_runs(capsys, tmp_path):
    pytest.importorskip("matplotlib")
    grids = [x for name in ("mass", "length", "drive") for x in ("--grid", f"{name}=1,2")]
    files = ("-o", tmp_path / "a.csv", "--plot", tmp_path / "a.png")
    code, _, err = run(capsys, "sweep", PENDULUM, *grids, *files)
    assert code == 2
    assert "3 parameters are varied, mass, length, drive; a plot shows one" in err
    assert list(tmp_path.iterdir()) == []


# ------------------------------------------------------------------------------------ other forms


def test_a_data_set_has_units_and_descriptions():
    pytest.importorskip("xarray")
    found = trajectory(outputs=["A.x", "energy.total"])
    data = found.to_xarray()
    assert data["A.x"].attrs["units"] == "m"
    assert data["energy.total"].attrs["long_name"] == next(
        v.description for v in found.model.variables if v.name == "energy.total"
    )
    assert data["time"].attrs == {"units": "s"}
    assert data.attrs["title"] == "double_pendulum"
    assert np.array_equal(data["A.x"], found["A.x"])
    assert np.array_equal(data["time"], found.t)


@pytest.mark.parametrize(
    ("form", "package", "extra"),
    [
        ("to_pandas", "pandas", "pandas"),
        ("to_xarray", "xarray", "xarray"),
        ("plot", "matplotlib", "plot"),
    ],
)
def test_a_form_whose_package_is_missing_names_the_extra(monkeypatch, form, package, extra):
    found = trajectory()
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ModuleNotFoundError, match=rf"{package} is missing.*'holonom\[{extra}\]'"):
        getattr(found, form)()


def test_a_notebook_shows_facts_and_a_curve_without_any_package(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    found = trajectory()
    table = ElementTree.fromstring(found._repr_html_())
    facts = {row[0].text: row[1] for row in table.iter("tr")}
    assert facts["rows"].text == "11"
    assert facts["duration"].text == "0.5 s"
    assert facts["largest energy error"].text == f"{abs(found['energy.error']).max():.2e}"
    assert facts["largest residual"].text == f"{abs(found['constraint.position']).max():.2e}"
    (line,) = table.iter("polyline")
    assert len(line.get("points").split()) == 11


@pytest.mark.parametrize(
    ("values", "points"),
    [([2.0, 2.0], 2), ([np.nan, np.nan], 0), ([np.inf, 1.0], 1), ([0.0] * 5000, plots.POINTS)],
    ids=["constant", "unknown", "one point", "long"],
)
def test_every_run_has_a_curve_of_few_points(values, points):
    t = np.arange(float(len(values)))
    names = solver.Trajectory(t, ("a<b",), np.array([values]).T)
    (line,) = ElementTree.fromstring(names._repr_html_()).iter("polyline")
    assert len(line.get("points").split()) == points
