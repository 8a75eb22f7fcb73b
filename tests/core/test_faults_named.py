"""A step that fails names the part that it fails at, where this can be known."""

from __future__ import annotations

import pytest

import solver
from solver.runtime import AssemblyError, StepError

PLANE = 'name = "fault"\ndimension = 2\n[inputs]\nu = { start = 1.0 }\n'
TWO = f"""{PLANE}[points]
A = {{ position = [0, 0], mass = 1 }}
B = {{ position = [1, 0], mass = 1 }}
[bodies]
rod = {{ position = [0, 3], mass = 1, inertia = 0.1 }}
[forces]
tie = {{ type = "spring", points = ["A", "B"], stiffness = "10 - 300*t", free_length = 1 }}
"""
HARD = TWO.replace(" - 300*t", " + 0*t")
FORCE = 'push = { type = "force", point = "B", value = ["sqrt(u)", 0] }\n'
TORQUE = 'twist = { type = "torque", body = "rod", value = "log(u)" }\n'
IN_SPACE = """
name = "fault"
[inputs]
u = { start = 1.0 }
[bodies]
first = { position = [0, 0, 0], mass = 1, inertia = [1, 1, 1] }
second = { position = [0, 0, 2], mass = 1, inertia = [1, 1, 1] }
[forces]
twist = { type = "torque", body = "second", value = ["sqrt(u)", 0, 0] }
"""
LARGE = 'push = { type = "force", point = "B", value = ["u**100", 0] }\n'
LOOP = f"""{PLANE}[points]
A = {{ position = [0, 0], fixed = true }}
B = {{ position = [0.5, 0.4], mass = 1 }}
[joints]
near = {{ type = "distance", points = ["A", "B"] }}
[drivers]
pull = {{ type = "distance", points = ["B", "ground"], at = [1, 0], value = "sqrt(0.41) + VALUE" }}
"""


def failure(text: str, value: float, **settings: float) -> str:
    """What a step says that fails with this value of the input u, after one without it.

    A spring is softer with time, and pushes after a thirtieth of a second.
    """
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)
    for name, setting in settings.items():
        run[f"solver.{name}"] = setting
    run.initialise()
    run.advance(0.0, 0.01)
    run["u"] = value
    with pytest.raises(StepError) as caught:
        run.advance(0.01, 0.1)
    return str(caught.value)


@pytest.mark.parametrize("tolerance", [0.0, 1e-6])
@pytest.mark.parametrize(
    ("text", "value", "words"),
    [
        (HARD + FORCE, -1.0, "a force is not a finite number, on point 'B': "),
        (HARD + TORQUE, -1.0, "a torque is not a finite number, on body 'rod': "),
        (IN_SPACE, -1.0, "a torque is not a finite number, on body 'second': "),
        (TWO, 1.0, "'tie': a stiffness, free length or damping became negative"),
        (HARD + LARGE, 1e2, "near point 'B': a number grew beyond all bounds"),
    ],
)
def test_what_is_not_finite_is_named_with_its_part(text, value, words, tolerance):
    assert words in failure(text, value, tolerance=tolerance)


def test_a_load_that_throws_light_links_about_is_named_with_its_ratio():
    """A load of 1e8 kg falls until its links of 1 kg come into line, within 0.1 s."""
    links = "".join(
        f"b{k} = {{ position = [{0.1 + 0.2 * k}, {-0.1 * (k % 2)}], mass = 1, inertia = 0.01 }}\n"
        for k in range(3)
    )
    pins = "".join(
        f'j{k} = {{ type = "revolute", bodies = ["{f"b{k - 1}" if k else "ground"}", "b{k}"], '
        f"position = [{0.2 * k}, {-0.1 * (k % 2)}] }}\n"
        for k in range(3)
    )
    text = (
        'name = "chain"\ndimension = 2\ngravity = [0, -9.81]\n'
        "[points]\nload = { position = [0.6, -0.1], mass = 1e8 }\n"
        f"[bodies]\n{links}[joints]\n{pins}"
        'hook = { type = "revolute", points = ["b2", "load"], at = [0.6, -0.1] }\n'
        "[solver]\nstep_size = 0.05\n"  # of 10 ms, some of such loads are carried
    )
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)
    with pytest.raises(StepError, match=r"; 'load' has 1e\+08 times the mass of 'b[0-2]', which"):
        run.advance(0.0, 1.0)


def test_a_driver_that_asks_for_what_cannot_be_is_named_with_what_it_pulls_against():
    text = LOOP.replace("VALUE", "0.3*t")
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)
    run["solver.step_size"] = 0.01
    with pytest.raises(StepError, match=r"near (joint 'near'|driver 'pull'): "):
        run.advance(0.0, 10.0)


def test_a_body_that_turns_too_fast_is_named():
    text = IN_SPACE.replace("[0, 0, 2], ", "[0, 0, 2], angular_velocity = [0, 0, 1e6], ")
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)
    run["solver.step_size"] = 0.01
    with pytest.raises(StepError, match="near body 'second': a body turns by more than"):
        run.advance(0.0, 0.1)


ROD = """
name = "rod"
dimension = 2
[points]
A = { position = [0, 0], fixed = true }
B = { position = [1, 0], mass = 1, velocity = [SPEED, 0] }
[joints]
rod = { type = "distance", points = ["A", "B"] }
"""


@pytest.mark.parametrize("speed", [9.6e-20, 1e-14])
def test_velocities_of_round_off_contradict_nothing(speed):
    model = solver.assemble(solver.loads(ROD.replace("SPEED", repr(speed))))
    assert solver.simulate(model, stop_time=0.1, step_size=0.1)["B.x"][-1] == pytest.approx(1.0)


def test_velocities_that_contradict_a_rod_are_refused_as_before():
    with pytest.raises((solver.SceneError, AssemblyError), match="contradict it: along it"):
        solver.assemble(solver.loads(ROD.replace("SPEED", "1e-9")))
