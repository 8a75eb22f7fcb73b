"""What the model description says an unknown depends on is what it depends on.

Known variables are moved a little. At the start what answers must be listed, no less. At a
communication point, before the next step, what is listed answers, and nothing else does.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import solver
from solver.mechanics.dependencies import AT_THE_START, KnownVariables
from solver.runtime import AssemblyError, Integrator, Model, OptionError
from tests.support.fmus.fmu_instance import SCENES, instance, text_fmu
from tests.support.fmus.native_fmus import native_fmu
from tests.support.mechanisms.scene_files import ALL

TWO = """
name = "two_mechanisms"
dimension = 2
gravity = [0, -9.81]
[parameters]
reach = 0.8
heavy = { value = 2.0, min = 0.1 }
stiff = { value = 40.0, variability = "tunable" }
period = "6.28*sqrt(heavy/stiff)"
[inputs]
push = { start = 0.3 }
lift = { start = 0.0 }
pull = { start = 0.2 }
[points]
O = { position = [0, 0], fixed = true }
P = { position = [3, 1], fixed = true }
A = { position = ["reach", 0], mass = 1.0 }
C = { position = [3, 0], mass = "heavy" }
D = { position = [5, 0] }
E = { position = [5, -1], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
hanger = { type = "distance", points = ["D", "E"] }
[forces]
spring = { type = "spring", points = ["C", "P"], stiffness = "stiff", free_length = 0.5 }
wind = { type = "force", point = "A", value = ["push", 0] }
gust = { type = "force", point = "C", value = ["pull + SENSED", 0] }
[drivers]
hook = { type = "position", point = "D", value = ["5", "lift"] }
[outputs]
sum = { value = "A.x + 2*pull" }
weight = { value = "9.81*heavy" }
"""
LAWS = """
name = "laws"
dimension = 2
gravity = [0, -9.81]
[inputs]
stiff = { start = 40.0, min = 0.0 }
rest = { start = 0.5 }
loss = { start = 0.3, min = 0.0 }
push = { start = 0.2 }
twist = { start = 0.1 }
place = { start = 0.0 }
speed = { start = 0.2 }
turned = { start = 0.0 }
slide = { start = 0.0 }
shift = { start = 0.2 }
belt = { start = 0.3 }
shown = { start = 1.0 }
ramped = { start = 0.0, interpolation = "ramp" }
smoothed = { start = 0.0, interpolation = "smooth" }
[points]
O = { position = [0, 0], fixed = true }
P = { position = [3, 1], fixed = true }
A = { position = [0.8, 0], mass = 1.0 }
C = { position = [3, 0], mass = 2.0 }
D = { position = [5, 0] }
E = { position = [5, -1], mass = 1.0 }
F = { position = [7, 0] }
G = { position = [7.6, -0.8], mass = 1.0 }
S = { position = [9, 0.1], velocity = [0.5, 0], mass = 1.0 }
V = { position = [15, 0], velocity = [1, 0], mass = 1.0 }
[bodies]
arm = { position = [11, 0], mass = 1.0, inertia = 0.2, points = { tip = [0.5, 0] } }
crank = { position = [13, 0], mass = 1.0, inertia = 0.2 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
hanger = { type = "distance", points = ["D", "E"] }
crane = { type = "distance", points = ["F", "G"] }
hinge = { type = "revolute", bodies = ["ground", "arm"], position = [11, 0] }
pivot = { type = "revolute", bodies = ["ground", "crank"], position = [13, 0] }
[constraints]
runner = { velocity = "V.vx*sin(slide) - V.vy*cos(slide)" }
[forces]
spring = { type = "spring", points = ["C", "P"], stiffness = "stiff", free_length = "rest" }
second = { type = "spring", points = ["E", "P"], stiffness = 3.0, free_length = "1 + 0.1*smoothed" }
shock = { type = "damper", points = ["A", "C"], damping = "loss" }
wind = { type = "force", point = "A", value = ["push", "ramped"] }
motor = { type = "joint_torque", joint = "hinge", value = "twist - 0.1*hinge.angular_velocity" }
[drivers]
hook = { type = "position", point = "D", value = ["5 + 0.1*shift*t", "place + smoothed"] }
boom = { type = "position", point = "F", value = ["7", "0.1*sin(shift*t) + ramped"] }
turn = { type = "angle", joint = "pivot", value = "0.1*sin(speed*t) + 0.1*turned + 0.1*smoothed" }
[contacts.floor]
type = "plane"
point = "S"
axis = [0, 1]
radius = 0.1
friction = 0.2
surface_velocity = ["belt", 0]
[outputs]
sum = { value = "A.x + 2*shown*A.vx" }
late = { value = "A.x + ramped + smoothed" }
power = { value = "twist*arm.angular_velocity" }
pull = { value = "2*spring.force" }
swung = { value = "G.ax + boom.power" }
run = { value = "V.ax" }
turns = { value = "arm.angular_acceleration + hinge.angular_acceleration" }
cranked = { value = "pivot.angular_acceleration" }
given = { value = "wind.power" }
[sensors]
imu = { type = "imu", body = "arm", at = [11.5, 0.2] }
seen = { type = "relative", points = ["A", "arm"], axes = "arm" }
[solver]
step_size = 0.01
"""
"""Inputs in every place: laws of springs, dampers, energies, loads, drivers, a belt, outputs."""
SENSING = TWO.replace("SENSED", "0.1*A.x")
BLIND = TWO.replace(" + SENSED", "")
NAMES = [
    "spring_pendulum", "four_bar", "stewart", "double_wishbone", "screw_jack", "flyball_governor",
    "bifilar", "snakeboard", "car_axis", "heavy_top",
]  # fmt: skip
SOURCES = ["two", "sensing", *NAMES]


@cache
def model_of(name: str) -> Model:
    text = {"two": BLIND, "sensing": SENSING, "laws": LAWS}.get(name)
    return solver.assemble(solver.loads(text) if text else solver.load(SCENES / f"{name}.toml"))


@cache
def known_of(name: str) -> dict[int, KnownVariables]:
    found = model_of(name).dependencies
    assert found is not None
    return found


def names(model: Model, indices) -> set[str]:
    return {model.variables[i].name for i in indices}


def at_the_start(name: str, output: str) -> set[str]:
    model = model_of(name)
    found = names(model, known_of(name)[model.index(output)].at_the_start)
    return found - set(AT_THE_START)


# ------------------------------------------------------------------------ what is written there


def test_at_the_start_a_mechanism_depends_on_all_that_it_is_made_of_and_on_nothing_else():
    assert at_the_start("two", "A.x") == {"reach", "push"}
    assert at_the_start("two", "C.x") == {"heavy", "stiff", "pull"}
    assert at_the_start("two", "E.vy") == {"lift"}
    assert at_the_start("two", "period") == {"heavy", "stiff"}
    assert at_the_start("two", "weight") == {"heavy"}


def test_a_sensor_brings_in_what_its_own_mechanism_depends_on():
    assert at_the_start("sensing", "C.x") == {"heavy", "stiff", "pull", "reach", "push"}
    assert at_the_start("sensing", "A.x") == {"reach", "push"}


def test_calculated_parameters_depend_on_no_setting():
    model = model_of("two")
    known = known_of("two")[model.index("period")]
    assert known.directly == ()
    assert names(model, known.at_the_start) == {"heavy", "stiff"}


# --------------------------------------------------------------------------------- perturbation


def unknowns(name: str) -> list[int]:
    return list(known_of(name))


def answers(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Whether values differ by more than what rounding leaves of an iteration."""
    return np.abs(after - before) > 1e-8 * (1.0 + np.abs(before))


def moved_value(variable, value, by=1e-3):
    """Another value of a variable, within its limits."""
    for other in (value + by * (1.0 + abs(value)), value - by * (1.0 + abs(value))):
        above = variable.minimum is None or other >= variable.minimum
        if above and (variable.maximum is None or other <= variable.maximum):
            return other
    return value


def start_values(name: str, changes=()) -> np.ndarray | None:
    integrator = Integrator(model_of(name))
    try:
        for index, value in changes:
            integrator.set([index], [value])
        integrator.initialise()
    except (AssemblyError, OptionError):
        return None  # drawn so that this one cannot move alone
    return np.array(integrator.get(unknowns(name)), dtype=float)


@pytest.mark.parametrize("settings", [{}, {"assemble": True}, {"start": "equilibrium"}], ids=str)
@pytest.mark.parametrize("name", [*SOURCES, "laws"])
def test_what_answers_at_the_start_is_listed(name, settings):
    model = model_of(name)
    fixed = [(model.index(f"solver.{key}"), value) for key, value in settings.items()]
    before = start_values(name, fixed)
    if before is None:
        pytest.skip("it has no equilibrium")
    tried = 0
    for index, variable in enumerate(model.variables):
        if variable.kind not in ("parameter", "input"):
            continue
        after = start_values(name, [*fixed, (index, moved_value(variable, variable.start))])
        if after is None:
            continue
        tried += 1
        for unknown, answer in zip(unknowns(name), answers(before, after), strict=True):
            listed = index in known_of(name)[unknown].at_the_start
            assert listed or not answer, (variable.name, model.variables[unknown].name)
    assert tried or name == "heavy_top"


@pytest.mark.parametrize("name", SOURCES)
def test_what_answers_to_a_setting_at_the_start_is_listed(name):
    model, before = model_of(name), start_values(name)
    others = {"order": 4.0, "start": "equilibrium", "method": "fastest"}
    for index, variable in enumerate(model.variables):
        if variable.kind != "option":
            continue
        value = variable.start
        key = variable.name.removeprefix("solver.")
        other = others.get(key) or (not value if isinstance(value, bool) else 2.0 * value or 1e-3)
        after = start_values(name, [(index, min(other, 1e-3) if "tolerance" in key else other)])
        if after is None:
            continue
        for unknown, answer in zip(unknowns(name), answers(before, after), strict=True):
            listed = index in known_of(name)[unknown].at_the_start
            assert listed or not answer, (variable.name, model.variables[unknown].name)


def on_the_way(name: str) -> Integrator:
    integrator = Integrator(model_of(name))
    integrator.initialise()
    h = model_of(name).experiment.step_size
    for k in range(5):
        integrator.advance(k * h, h)
    return integrator


def values(integrator: Integrator, name: str) -> np.ndarray:
    return np.array(integrator.get(unknowns(name)), dtype=float)


def moved_by(name: str, index: int, h: float = 0.0) -> set[int]:
    """Unknowns that answer to an input at some of several communication points.

    What is compared are the values before and after it is set or, where h > 0, those after steps
    of this length with one value and with the other.
    """
    integrator, found = on_the_way(name), set()
    variable = model_of(name).variables[index]
    for _ in range(POINTS):
        saved, t = integrator.save(), integrator.time
        (value,) = integrator.get([index])
        pair = []
        for given in (value, moved_value(variable, value, FAR)):
            integrator.restore(saved)
            integrator.set([index], [given])
            if h:
                integrator.advance(t, h)
            pair.append(values(integrator, name))
        found |= {u for u, x in zip(unknowns(name), answers(*pair), strict=True) if x}
        integrator.restore(saved)
        integrator.advance(t, model_of(name).experiment.step_size)
    return found


POINTS = 3
"""Places of a mechanism at which an input is moved: in one of them a slope may be 0."""
FAR = 1e-2
"""How far an input goes: residuals are the largest of many, which a small one does not show."""
DRIVEN = ["two", "sensing", "laws", *(path.stem for path in ALL if solver.load(path).inputs)]
"""Those with inputs, all scenes among them."""


def inputs_of(name: str) -> list[int]:
    found = [i for i, v in enumerate(model_of(name).variables) if v.causality == "input"]
    assert found
    return found


@pytest.mark.parametrize("name", DRIVEN)
def test_what_is_listed_answers_to_an_input_at_once_and_nothing_else_does(name):
    model = model_of(name)
    for index in inputs_of(name):
        listed = {u for u, known in known_of(name).items() if index in known.directly}
        assert names(model, moved_by(name, index)) == names(model, listed), index


def test_reactions_and_driven_places_follow_in_the_next_step_however_short():
    pairs = [("push", "rod.force"), ("lift", "E.y"), ("pull", "C.vx")]
    model = model_of("two")
    for source, output in pairs:
        assert model.index(output) in moved_by("two", model.index(source), 1e-3)


@pytest.mark.parametrize("fmi", [0, 2, 3])
def test_an_fmu_lists_what_its_outputs_do(fmi):
    """Get, set and get at a communication point, as an importer does: value for value."""
    model = model_of("laws")
    path = native_fmu(model, fmi) if fmi else text_fmu(LAWS)
    with instance(path) as fmu:
        outputs = {v.name: v.valueReference for v in fmu.description.modelVariables
                   if v.causality == "output"}  # fmt: skip
        listed = {
            x.variable.name: {d.name for d in x.dependencies} for x in fmu.description.outputs
        }
        h = model.experiment.step_size
        fmu.initialise()
        fmu.run(0.0, h, 5)
        saved = fmu.fmu.getFMUState()
        for index in inputs_of("laws"):
            variable = model.variables[index]
            before = np.array(fmu.fmu.getReal([*outputs.values()]))
            fmu.set(**{variable.name: moved_value(variable, fmu.get(variable.name), FAR)})
            after = np.array(fmu.fmu.getReal([*outputs.values()]))
            found = {x for x, y in zip(outputs, answers(before, after), strict=True) if y}
            assert found == {name for name, known in listed.items() if variable.name in known}
            fmu.fmu.setFMUState(saved)
