"""Settings of the solver have one meaning: in the scene, in the model, and in the FMU."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path

import pytest

import solver
from solver import options
from solver.runtime.model_writing import stored
from solver.scene import SceneError, SolverSettings
from solver.scene.fields import fields_of
from tests.support.kernel.twins import PENDULUM


def test_what_the_scene_file_leaves_out_is_the_default():
    assert solver.loads(PENDULUM).solver == SolverSettings()
    assert dataclasses.asdict(SolverSettings()) == options.DEFAULTS


NUMBERS = [x for x in options.OPTIONS.values() if not (x.words or x.is_switch or x.allowed)]


@pytest.mark.parametrize("option", NUMBERS, ids=lambda option: option.name)
def test_scene_and_run_time_refuse_what_is_beyond_the_limits(option):
    step = 1.0 if option.whole else math.ulp(option.high)
    smallest = option.least or option.low
    holds = fields_of(SolverSettings)[option.name].kind.rule.holds
    for value in (option.high, smallest):
        assert holds(value)
        assert stored(option, value) == value
    between = [math.nextafter(option.least, 0.0)] if option.least else []
    for value in (option.high + step, -1.0, math.nan, *between):
        assert not holds(value)
        with pytest.raises(solver.OptionError, match=f"^solver.{option.name}: must be"):
            stored(option, value)
    assert holds(0.0) == (option.low == 0.0)


@pytest.mark.parametrize("value", [3, 10, True, "2"])
def test_an_order_is_one_of_four_or_chosen(value):
    with pytest.raises(solver.OptionError, match=r"^solver\.order: must be 2, 4, 6 or 8"):
        stored(options.OPTIONS["order"], value)


BRICARD = Path(__file__).parents[2] / "scenes" / "bricard.toml"


def _run_of(model: solver.Model, **settings: float) -> tuple[solver.Integrator, float]:
    """Bricard's linkage after 1 s, with settings made after the assembly; and Newton iterations."""
    run = solver.Integrator(model)
    for name, value in settings.items():
        run[f"solver.{name}"] = value
    iterations = 0.0
    for i in range(10):
        run.advance(0.1 * i, 0.1)
        iterations += run.state.head["newton_iterations"]
    return run, iterations


def test_a_tolerance_chooses_the_order_wherever_it_is_set():
    """In the scene, in the FMU and in Python; it costs at most two fifths more after assembly."""
    scene = solver.load(BRICARD)
    plain = solver.assemble(scene)
    of_scene = dataclasses.replace(scene.solver, tolerance=1e-7)
    asked, wanted = _run_of(solver.assemble(dataclasses.replace(scene, solver=of_scene)))
    later, needed = _run_of(plain, tolerance=1e-7)
    _, of_order_2 = _run_of(plain, tolerance=1e-7, order=2)
    assert later["solver.order_in_use"] == asked["solver.order_in_use"] > 2.0
    assert needed < 1.4 * wanted
    assert of_order_2 > 3.0 * needed
    simulated = solver.simulate(plain, stop_time=1.0, step_size=0.1, tolerance=1e-7)
    assert simulated["solver.order_in_use"][-1] == asked["solver.order_in_use"]


def test_only_longest_step_limits_the_steps_of_a_tolerance():
    model = solver.assemble(solver.load(BRICARD))
    free, iterations = _run_of(model, tolerance=1e-3)
    assert _run_of(model, tolerance=1e-3, step_size=1e-4)[1] == iterations
    limited, _ = _run_of(model, tolerance=1e-3, longest_step=1e-3)
    assert limited["solver.substeps"] >= 100.0 > free["solver.substeps"]


@pytest.mark.parametrize(
    ("steps", "chosen"), [("step_size = 0.01", 2.0), ("tolerance = 1e-9", 8.0)]
)
def test_order_0_is_left_to_the_tolerance_and_is_2_without_one(steps, chosen):
    def last(order: str, **given: float) -> float:
        text = f"{PENDULUM}[solver]\n{steps}\n{order}\n"
        model = solver.assemble(solver.loads(text))
        outputs = ["solver.order_in_use"]
        run = solver.simulate(
            model, stop_time=1.0, step_size=1.0, outputs=outputs, parameters=given
        )
        return run["solver.order_in_use"][-1]

    assert last("order = 0") == last("") == chosen
    assert last("order = 8", **{"solver.order": 0.0}) == chosen


def test_a_scene_made_by_hand_with_a_setting_out_of_range_is_reported_too():
    scene = solver.loads(PENDULUM)
    wrong = dataclasses.replace(scene.solver, penalty=1e20)
    with pytest.raises(SceneError) as caught:
        solver.assemble(dataclasses.replace(scene, solver=wrong))
    (problem,) = caught.value.problems
    assert problem.location == "solver.penalty"
    assert "1e+14" in problem.message
