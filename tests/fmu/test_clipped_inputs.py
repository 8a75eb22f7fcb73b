"""A value of an input beyond its limits is refused, or clipped where the scene says so."""

from __future__ import annotations

import math

import fmpy
import numpy as np
import pytest

import solver
from build_fmu.run import run_fmu
from tests.support.fmus.fmu_instance import instance, text_fmu

SCENE = """
name = "clipped"
dimension = 2
[inputs]
push = {{ start = 0.0, unit = "N", min = -5, max = 5{limit} }}
lift = {{ start = 0.0, min = -5, max = 2, interpolation = "ramp", limit = "clip" }}
[points]
A = {{ position = [0, 0], mass = 1.0 }}
[forces]
wind = {{ type = "force", point = "A", value = ["push", "lift"] }}
[experiment]
stop_time = 1.0
step_size = 0.1
"""
REFUSED, CLIPPED = SCENE.format(limit=""), SCENE.format(limit=', limit = "clip"')
SIGNAL = [6.0, 5.04, 1.0, -7.0, -5.0, 4.0]


def started(text: str, said: list[str]) -> solver.Integrator:
    return solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)


def run(integrator: solver.Integrator, signal: list[float]) -> bytes:
    integrator.initialise(0.0)
    for k, value in enumerate(signal):
        integrator["push"] = value
        integrator["lift"] = value
        integrator.advance(0.1 * k, 0.1)
    return integrator.save()


@pytest.mark.parametrize(("value", "limit"), [(5.04, ">= 5|<= 5"), (-6.0, ">= -5")])
def test_a_value_beyond_a_limit_is_refused_with_the_remedy(value, limit):
    integrator = started(REFUSED, [])
    with pytest.raises(solver.OptionError, match=f'push: must be ({limit}) N.*limit = "clip"'):
        integrator["push"] = value
    assert integrator["push"] == 0.0


def test_a_clipped_input_moves_as_one_that_stays_within_its_limits():
    said: list[str] = []
    beyond = started(CLIPPED, said)
    within = [min(max(x, -5.0), 5.0) for x in SIGNAL]
    assert run(beyond, SIGNAL) == run(started(CLIPPED, []), within)
    beyond["push"] = 1e300
    assert beyond["push"] == 5.0


def test_each_clipped_input_is_named_once_in_a_run():
    said: list[str] = []
    integrator = started(CLIPPED, said)
    run(integrator, SIGNAL)
    assert [text.split(":")[0] for text in said] == ["push", "lift"]
    assert said[0] == "push: 6.0 N is beyond 5 N, and is clipped to this limit (reported once)"
    integrator.reset()
    run(integrator, SIGNAL)
    assert len(said) == 4


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, "5"])
def test_what_is_no_finite_number_is_not_clipped(value):
    with pytest.raises(solver.OptionError, match="must be a finite number"):
        started(CLIPPED, [])["push"] = value


def test_an_fmu_clips_says_so_once_and_comes_to_its_end():
    times = np.linspace(0.0, 1.0, 11)
    signal = 7.0 * np.sin(6.0 * times)
    fmu = text_fmu(CLIPPED)
    beyond = run_fmu(fmu, inputs={"time": times, "push": signal})
    within = run_fmu(fmu, inputs={"time": times, "push": np.clip(signal, -5.0, 5.0)})
    assert beyond.finished
    assert not beyond.reason
    assert len(beyond.messages) == 1
    assert "push: " in beyond.messages[0]
    # fmpy takes inputs from straight lines, at times that are off the rows by their last digit.
    for name in ("A.x", "A.vx"):
        assert beyond.values[name] == pytest.approx(within.values[name], rel=1e-12, abs=1e-12)
    assert not within.messages


def test_an_fmu_refuses_where_nothing_is_clipped_and_names_the_remedy():
    refused = run_fmu(text_fmu(REFUSED), inputs={"time": [0.0, 1.0], "push": [0.0, 10.0]})
    assert not refused.finished
    assert 'limit = "clip"' in refused.reason


def test_the_description_has_limits_of_inputs_that_are_refused_alone():
    for text, limits in ((REFUSED, ("-5.0", "5.0")), (CLIPPED, (None, None))):
        variables = fmpy.read_model_description(str(text_fmu(text))).modelVariables
        push = next(v for v in variables if v.name == "push")
        assert (push.min, push.max) == limits


def test_a_scene_that_clips_to_nothing_is_refused():
    text = CLIPPED.replace("min = -5, max = 5, ", "")
    with pytest.raises(solver.SceneError, match="nothing to clip to without min or max"):
        solver.loads(text)
    with pytest.raises(solver.SceneError, match=r"inputs\.push\.limit"):
        solver.loads(CLIPPED.replace('"clip"', '"cut"', 1))


def test_a_reset_of_an_fmu_clips_and_says_so_again():
    with instance(text_fmu(CLIPPED)) as fmu:
        for _ in range(2):
            fmu.log.clear()
            fmu.initialise()
            fmu.set(push=9.0)
            fmu.set(push=8.0)
            assert fmu.get("push") == 5.0
            assert sum("clipped" in text for _, _, text in fmu.log) == 1
            fmu.fmu.reset()
