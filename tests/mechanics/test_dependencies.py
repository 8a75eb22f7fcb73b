"""What the model description says an unknown depends on is what it depends on, no less.

Known variables are moved a little, and what answers must be listed: at the start, and at a
communication point. An input that is listed nowhere acts through accelerations alone: on
velocities by the first power of the step, on positions by the second.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import solver
from solver.mechanics.dependencies import AT_THE_START, KnownVariables
from solver.runtime import AssemblyError, Integrator, Model, OptionError
from tests.fmu_instance import SCENES

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
SENSING = TWO.replace("SENSED", "0.1*A.x")
BLIND = TWO.replace(" + SENSED", "")
NAMES = [
    "spring_pendulum", "four_bar", "stewart", "double_wishbone", "screw_jack", "flyball_governor",
    "bifilar", "snakeboard", "car_axis", "heavy_top",
]  # fmt: skip
SOURCES = ["two", "sensing", *NAMES]


@cache
def model_of(name: str) -> Model:
    text = {"two": BLIND, "sensing": SENSING}.get(name)
    return solver.assemble(solver.loads(text) if text else solver.load(SCENES / f"{name}.toml"))


@cache
def known_of(name: str) -> dict[int, KnownVariables]:
    found = model_of(name).dependencies
    assert found is not None
    return found


def names(model: Model, indices) -> set[str]:
    return {model.variables[i].name for i in indices}


def directly(name: str, output: str) -> set[str]:
    model = model_of(name)
    return names(model, known_of(name)[model.index(output)].directly)


def at_the_start(name: str, output: str) -> set[str]:
    model = model_of(name)
    found = names(model, known_of(name)[model.index(output)].at_the_start)
    return found - set(AT_THE_START)


# ------------------------------------------------------------------------ what is written there


def test_an_output_of_one_mechanism_does_not_depend_on_the_inputs_of_another():
    for output in ("A.x", "A.vx", "C.x", "spring.force", "weight"):
        assert directly("two", output) == set()
    assert directly("two", "rod.force") == {"push"}
    assert directly("two", "E.y") == directly("two", "hanger.force") == {"lift"}
    assert directly("two", "sum") == {"pull"}
    assert directly("two", "energy.total") == {"push", "lift", "pull"}


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


def moved_value(variable, value):
    """Another value of a variable, within its limits."""
    for other in (value + 1e-3 * (1.0 + abs(value)), value - 1e-3 * (1.0 + abs(value))):
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
@pytest.mark.parametrize("name", SOURCES)
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
    others = {"formulation": "conserving-al-beta", "algorithm": "simultaneous", "order": 4.0,
              "multiplier_update": "paper", "start": "equilibrium",
              "energy": "tolerance"}  # fmt: skip
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


def with_two_values(name: str, index: int, h: float) -> tuple[np.ndarray, np.ndarray]:
    """Values after a step of length h, 0 for none, with one new value of an input and another.

    Both are new, as any jump makes the solver forget the line that it draws through multipliers.
    """
    integrator = on_the_way(name)
    variable, t, saved = model_of(name).variables[index], integrator.time, integrator.save()
    (value,) = integrator.get([index])
    first = moved_value(variable, value)
    found = []
    for other in (first, 0.5 * (first + value)):
        integrator.restore(saved)
        integrator.set([index], [other])
        if h:
            integrator.advance(t, h)
        found.append(values(integrator, name))
    return found[0], found[1]


DRIVEN = [
    "two", "sensing", "spring_pendulum", "four_bar", "stewart", "double_wishbone", "screw_jack",
    "bifilar",
]  # fmt: skip
"""Those with inputs."""


def inputs_of(name: str) -> list[int]:
    found = [i for i, v in enumerate(model_of(name).variables) if v.causality == "input"]
    assert found
    return found


@pytest.mark.parametrize("name", DRIVEN)
def test_what_answers_to_an_input_at_once_is_listed(name):
    for index in inputs_of(name):
        before, after = with_two_values(name, index, 0.0)
        for unknown, answer in zip(unknowns(name), answers(before, after), strict=True):
            listed = index in known_of(name)[unknown].directly
            assert listed or not answer, model_of(name).variables[unknown].name


LAST_STEP = ("solver.", "energy.error", "energy.balance", "constraint.")
"""Outputs that tell of the last step, or of round-off."""


@pytest.mark.parametrize("name", DRIVEN)
def test_what_is_not_listed_follows_an_input_only_as_time_passes(name):
    """The change of a state vanishes with the step, at least in proportion to it."""
    variables = model_of(name).variables
    for index in inputs_of(name):
        long, short = (np.abs(np.subtract(*with_two_values(name, index, h))) for h in (1e-3, 1e-4))
        for unknown, slow, fast in zip(unknowns(name), long, short, strict=True):
            listed = index in known_of(name)[unknown].directly
            if not listed and not variables[unknown].name.startswith(LAST_STEP):
                assert fast <= 0.2 * slow + 1e-11, (variables[unknown].name, slow, fast)


def test_what_is_listed_answers_to_a_step_however_short():
    """Reactions follow a force at once, and a driven mechanism the place that is prescribed."""
    pairs = [("two", "push", "rod.force"), ("two", "lift", "E.y"), ("two", "lift", "hanger.force")]
    for name, source, output in pairs:
        model = model_of(name)
        place = unknowns(name).index(model.index(output))
        for h in (1e-3, 1e-4):
            before, after = with_two_values(name, model.index(source), h)
            assert abs(after[place] - before[place]) > 1e-5
