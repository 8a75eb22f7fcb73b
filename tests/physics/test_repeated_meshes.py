"""A mesh repeats a run to the last bit, and results are smooth in the numbers that are changed."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import solver
from solver.mesh import MESH_ENDS, Mesh
from solver.runtime import OptionError, Status, StepError

SCENES = Path(__file__).parents[2] / "scenes"

SPRING = """
name = "spring"
dimension = 2
[parameters]
stiffness = { value = 50.0, min = 1.0 }
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1.3, 0], mass = 2.0 }
[forces]
s = { type = "spring", points = ["O", "A"], stiffness = "stiffness", free_length = 1.0 }
"""

PENDULUM = """
name = "pendulum"
dimension = 2
gravity = [0, "-g"]
[parameters]
g = { value = 9.81 }
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.6, -0.8], mass = 2.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
"""

BALL = """
name = "ball"
dimension = 2
gravity = [0, "-g"]
[parameters]
g = { value = 9.81 }
height = { value = 1.0 }
[points]
A = { position = [0, "height"], velocity = [1, 0], mass = 2.0 }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1], restitution = 0.8 }
"""

SLIDING = """
name = "sliding"
dimension = 2
gravity = [0, -10]
[parameters]
friction = { value = 0.25 }
[points]
A = { position = [0, 0], velocity = [2, 0], mass = 1.5 }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1], friction = "friction" }
"""

AT = {"stop_time": 1.0, "step_size": 0.25}


@cache
def model(text):
    return solver.assemble(solver.loads(text))


def last(text, name, values, **options):
    run = solver.simulate(model(text), parameters=values, outputs=[name], **{**AT, **options})
    return float(run[name][-1])


def slope(text, name, parameter, value, d, **options):
    """Central difference."""
    high, low = (last(text, name, {parameter: value + x}, **options) for x in (d, -d))
    return (high - low) / (2 * d)


def recorded(text, **options):
    return solver.simulate(model(text), record_mesh=True, **{**AT, **options}).mesh


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("double_pendulum", {"tolerance": 1e-6}),
        ("double_pendulum", {"tolerance": 1e-6, "method": "fastest"}),
        ("double_pendulum", {"tolerance": 1e-6, "order": 4.0}),
        ("car_axis", {"tolerance": 1e-4}),
        ("bouncing_ball", {"tolerance": 1e-6, "stop_time": 3.0}),
        ("bouncing_ball", {"internal_step": 0.01, "stop_time": 3.0}),
        ("belt_and_block", {"tolerance": 1e-4, "stop_time": 2.0}),
        ("falling_chain", {"tolerance": 1e-6, "stop_time": 0.5}),
        ("die_in_a_bowl", {"tolerance": 1e-4, "stop_time": 0.5}),
        ("snakeboard", {"internal_step": 0.01}),
    ],
)
def test_the_same_numbers_give_the_same_bits(name, options):
    """Of motion, forces and energies; `solver.*` tells what the repeated run itself did."""
    scene = solver.assemble(solver.load(SCENES / f"{name}.toml"))
    options = {"stop_time": 1.0, **options}
    first = solver.simulate(scene, record_mesh=True, **options)
    again = solver.simulate(scene, mesh=first.mesh, stop_time=options["stop_time"])
    for variable in first:
        if not variable.startswith("solver."):
            assert np.array_equal(first[variable], again[variable]), variable


@pytest.mark.parametrize(
    ("name", "parameter", "events"),
    [
        ("gear_pair_with_backlash", "load", 10),
        ("geneva_drive", "speed", 5),
        ("slider_crank_with_clearance", "speed", 50),
    ],
)
def test_a_run_with_many_events_goes_where_one_with_its_own_steps_goes(name, parameter, events):
    """Both err by the tolerance, relative to the size: impacts enlarge it."""
    scene = solver.assemble(solver.load(SCENES / f"{name}.toml"))
    value = next(v.start for v in scene.variables if v.name == parameter)
    places = [v.name for v in scene.variables if v.name.endswith((".x", ".y")) and v.unit == "m"]
    options = {"stop_time": 0.3, "outputs": places}
    mesh = solver.simulate(scene, record_mesh=True, tolerance=1e-6, **options).mesh
    assert np.count_nonzero(mesh["end"] == MESH_ENDS.index("event")) >= events
    changed = {"parameters": {parameter: value * (1 + 1e-6)}, **options}
    found = solver.simulate(scene, mesh=mesh, **changed).table
    own = solver.simulate(scene, tolerance=1e-6, **changed).table
    assert np.abs(found - own).max() < 1e-5 * np.abs(own).max()


def test_recording_does_not_change_a_run():
    options = {**AT, "tolerance": 1e-6}
    plain = solver.simulate(model(BALL), **options)
    assert plain == solver.simulate(model(BALL), record_mesh=True, **options)
    assert plain.mesh is None


def slope_of_a_spring():
    """x(t) = x0 cos(sqrt(k/m) t), by k."""
    k, mass, at, t = 50.0, 2.0, 0.3, AT["stop_time"]
    return -at * math.sin(math.sqrt(k / mass) * t) * t / (2 * math.sqrt(k * mass))


def test_differences_converge_to_the_slope_of_a_spring_with_the_square_of_the_change():
    """Its third derivative is 2e-5: differences err by 3.3e-6 d^2, and by 1e-15/d of round-off."""
    mesh = recorded(SPRING, tolerance=1e-8)
    left = {
        d: slope(SPRING, "A.x", "stiffness", 50.0, d, mesh=mesh) - slope_of_a_spring()
        for d in (2.0, 1.0, 0.5, 1e-3)
    }
    assert left[2.0] / left[1.0] == pytest.approx(4.0, rel=0.02)
    assert left[1.0] / left[0.5] == pytest.approx(4.0, rel=0.02)
    assert abs(left[1e-3]) < 1e-9  # of a run at a tolerance of 1e-8


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8])
def test_a_repeated_run_is_smooth_where_runs_with_their_own_steps_jitter(tolerance):
    """Of a polynomial through 41 results no more is left than round-off."""
    options = {"stop_time": 5.0, "step_size": 5.0}
    mesh = recorded(PENDULUM, tolerance=tolerance, **options)
    places = 9.81 + np.linspace(-0.02, 0.02, 41)

    def jitter(**settings):
        values = [last(PENDULUM, "A.x", {"g": g}, **options, **settings) for g in places]
        smooth = np.polynomial.Chebyshev.fit(places, values, 6)
        return np.abs(smooth(places) - values).max()

    assert jitter(mesh=mesh) < 1e-12
    assert jitter(tolerance=tolerance) > 1e2 * jitter(mesh=mesh)


def slope_of_a_ball():
    """Height after one bounce at t1 = sqrt(2 h/g), by g, from y = v s - g s^2/2, v = e g t1."""
    g, e, t = 9.81, 0.8, AT["stop_time"]
    t1 = math.sqrt(2 / g)
    s, t1_g = t - t1, -t1 / (2 * g)
    v, v_g = e * g * t1, e * (t1 + g * t1_g)
    return v_g * s - v * t1_g - s * s / 2 + g * s * t1_g


@pytest.mark.parametrize("options", [{"tolerance": 1e-6}, {"internal_step": 0.01}])
@pytest.mark.parametrize("step", [0.25, 1.0])
def test_steps_end_at_the_impact_of_the_new_numbers(options, step):
    """A ball falls in parabolas, which steps follow exactly; its third derivative by g is 3e-3."""
    mesh = recorded(BALL, step_size=step, **options)
    assert np.count_nonzero(mesh["end"] == MESH_ENDS.index("event")) == 1
    left = [
        slope(BALL, "A.y", "g", 9.81, d, mesh=mesh, step_size=step) - slope_of_a_ball()
        for d in (0.1, 0.05, 1e-3)
    ]
    assert left[0] / left[1] == pytest.approx(4.0, rel=1e-2)
    assert abs(left[2]) < 1e-9


@pytest.mark.parametrize("options", [{"tolerance": 1e-6}, {"internal_step": 0.01}])
def test_steps_end_where_a_slip_stops_now(options):
    """It stops at v^2/(2 mu g): -v^2/(2 mu^2 g) by mu."""
    mesh = recorded(SLIDING, **options)
    found = slope(SLIDING, "A.x", "friction", 0.25, 1e-4, mesh=mesh)
    # Of d^2/6 of the third derivative, 6 v^2/(2 mu^4 g), 3e-7 is left.
    assert found == pytest.approx(-(2.0**2) / (2 * 0.25**2 * 10), abs=1e-6)


@pytest.mark.parametrize(
    ("text", "values"),
    [(BALL, {"height": 6.0}), (BALL, {"height": 0.1})],
    ids=["none", "more"],
)
def test_other_events_are_refused(text, values):
    mesh = recorded(text, tolerance=1e-6)
    with pytest.raises(StepError, match="contacts or frictions change in another order") as caught:
        solver.simulate(model(text), parameters=values, mesh=mesh, **AT)
    assert caught.value.status == Status.MESH_EVENTS


def test_steps_that_cannot_be_taken_as_they_were_are_refused():
    mesh = recorded(PENDULUM, tolerance=1e-6)
    order = mesh.steps.copy()
    order[:, Mesh.columns.index("order")] = 2.0
    with pytest.raises(StepError, match="cannot be taken as in the run whose mesh") as caught:
        solver.simulate(model(PENDULUM), mesh=replace(mesh, steps=order), **AT)
    assert caught.value.status == Status.MESH_METHODS


def test_stepped_contacts_are_refused():
    mesh = recorded(BALL, contact_mode="stepped")
    with pytest.raises(StepError, match="change at the ends of half steps") as caught:
        solver.simulate(model(BALL), mesh=mesh, **AT)
    assert caught.value.status == Status.MESH_STEPPED


def test_a_file_has_the_whole_mesh(tmp_path):
    mesh = recorded(BALL, tolerance=1e-6)
    read = Mesh.load(mesh.save(tmp_path / "ball.mesh"))
    assert np.array_equal(read.steps, mesh.steps)
    first = solver.simulate(model(BALL), mesh=mesh, **AT)
    assert first == solver.simulate(model(BALL), mesh=read, **AT)
    said = f"<Mesh: {len(mesh.steps)} steps, 1 events, 0 switches, to 1 s>"
    assert repr(read) == repr(mesh) == said


def test_a_damaged_file_is_refused(tmp_path):
    path = tmp_path / "none.npz"
    path.write_bytes(b"text")
    with pytest.raises(OptionError, match="is no mesh of a run; record it again"):
        Mesh.load(path)
    mesh = recorded(BALL, tolerance=1e-6)
    for column, value in (("length", -1.0), ("function", 7.0), ("taken", 0.5), ("value", math.nan)):
        steps = mesh.steps.copy()
        steps[2, Mesh.columns.index(column)] = value
        with pytest.raises(OptionError, match="record it again"):
            Mesh.load(replace(mesh, steps=steps).save(path))


def test_a_mesh_is_refused_where_it_does_not_fit():
    mesh = recorded(BALL, tolerance=1e-6)
    for wrong, options, sentence in (
        (PENDULUM, AT, "a mechanism with other parts"),
        (BALL, {**AT, "step_size": 0.5}, "has 5 communication points up to 1 s, this run has 3"),
        (BALL, {**AT, "tolerance": 1e-4}, "has the settings of its run; leave tolerance out"),
        (BALL, {**AT, "record_mesh": True}, "leave record_mesh out"),
    ):
        with pytest.raises(OptionError, match=sentence):
            solver.simulate(model(wrong), mesh=mesh, **options)
    with pytest.raises(OptionError, match="the paper's method takes equal steps"):
        solver.simulate(model(PENDULUM), record_mesh=True, formulation="conserving-penalty", **AT)
