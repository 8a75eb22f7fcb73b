"""Ports of an FMU: what importers list, what they may read all the same, and bad patterns."""

from __future__ import annotations

import fmpy
import pytest
from fmpy.validation import validate_fmu

from build_fmu import build
from build_fmu.errors import UsageError
from build_fmu.testing import assert_conserves
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, instance

PORTS = {
    "fmu.outputs": ["B0.*", "crank0.angle"],
    "fmu.inputs": [],
    "fmu.parameters": ["solver.step_size"],
}
SEEN = {"B0.x", "B0.y", "B0.vx", "B0.vy", "crank0.angle", "solver.step_size"}
KINDS = [{}, {"native": True}, {"native": True, "fmi": 3}]


@pytest.mark.parametrize("kind", KINDS, ids=["python", "native", "fmi3"])
def test_only_the_chosen_variables_are_ports_and_the_rest_is_local(kind, tmp_path):
    fmu = build(SCENES / "four_bar.toml", tmp_path, parameters=PORTS, **kind)
    variables = fmpy.read_model_description(str(fmu)).modelVariables
    ports = {v.name for v in variables if v.causality not in ("local", "independent")}
    assert ports == SEEN
    assert validate_fmu(str(fmu)) == []
    assert "solver.order" not in fmu.with_suffix(".ssv").read_text(encoding="utf-8")
    assert_conserves(fmu)


@pytest.mark.parametrize("native", [False, True])
def test_a_local_variable_has_the_value_that_it_has_as_a_port(native, tmp_path):
    scene = SCENES / "four_bar.toml"
    few = build(scene, tmp_path / "few.fmu", parameters=PORTS, native=native)
    with instance(build(scene, tmp_path, native=native)) as all_, instance(few) as some:
        for fmu in (all_, some):
            fmu.initialise()
            fmu.run(0.0, 0.1, 3)
        for name in ("B2.vx", "energy.total", "solver.step_size", "drive"):
            assert some.get(name) == all_.get(name)


def test_a_pattern_that_matches_nothing_is_refused_with_what_there_is(tmp_path):
    with pytest.raises(UsageError, match=r"fmu.outputs: error: 'tup.\*' matches none of the 44"):
        build(SCENES / "four_bar.toml", tmp_path, parameters={"fmu.outputs": ["B0.x", "tup.*"]})


def test_the_command_line_chooses_outputs_and_says_how_many_ports_there_are(capsys, tmp_path):
    fmu = tmp_path / "a.fmu"
    code, _, err = run(
        capsys,
        "build",
        SCENES / "four_bar.toml",
        "-o",
        fmu,
        "--native",
        "--outputs",
        "B0.*, energy.error",
    )
    assert (code, err.split("; ")[0]) == (0, "four_bar: 5 outputs, 1 input, 12 parameters")
    code, out, _ = run(capsys, "info", fmu)
    assert "FMI 2.0, native, linux64" in out or "FMI 2.0, native" in out


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--fmi", "3"], "add --native"),
        (["--platforms", "linux64"], "add --native"),
        (["--native", "--platforms", "mars"], "platform 'mars': must be one of linux64"),
        (["--native", "--platforms", "linux64,linux-arm64"], "one folder for both"),
    ],
)
def test_packages_that_there_are_not_are_refused_with_a_remedy(capsys, tmp_path, options, told):
    code, _, err = run(
        capsys, "build", SCENES / "four_bar.toml", "-o", tmp_path / "a.fmu", *options
    )
    assert code == 2
    assert told in err
