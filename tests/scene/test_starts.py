"""What the start of a run fixes, what belongs to the state, and starts that cannot be."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from tests.support.fmus.fmu_instance import SCENES

MOVED = """
name = "moved"
dimension = 2
gravity = [0, -9.81]
[points]
P = { position = [0, 0] }
A = { position = [1, 0], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["P", "A"] }
[drivers]
hand = { type = "position", point = "P", value = ["5*sin(3*t)", 0] }
"""
"""The size of this mechanism depends on when it is looked at."""


def advanced(run: solver.Integrator, steps: int) -> solver.Integrator:
    for _ in range(steps):
        run.advance(run.time, 0.01)
    return run


def test_a_restored_run_goes_on_bit_for_bit_though_its_points_have_moved():
    model = solver.assemble(solver.loads(MOVED))
    whole = advanced(solver.Integrator(model), 21)
    fresh = solver.Integrator(model)
    fresh.restore(whole.save())
    assert advanced(fresh, 20).save() == advanced(whole, 20).save()


def test_a_bead_alone_slides_on_its_line():
    text = """
name = "bead"
gravity = [0, 0, -9.81]
[points]
A = { position = [0, 0, 0], mass = 1.0 }
[joints]
wire = { type = "point_on_line", point = "A", axis = [3, 0, -4] }
"""
    run = solver.simulate(solver.loads(text), stop_time=1.0, step_size=0.1)
    # down the wire with g 4/5
    assert run["A.z"][-1] == pytest.approx(-0.5 * 9.81 * 0.8 * 0.8, abs=1e-12)
    assert np.max(run["energy.error"]) < 1e-13


def test_velocity_rows_take_part_in_the_jump_of_a_ramp():
    text = """
name = "towed"
dimension = 2
[inputs]
u = { interpolation = "ramp" }
[points]
B = { position = [0, 0] }
A = { position = [0, 1], mass = 1.0 }
[drivers]
tug = { type = "position", point = "B", value = ["u", 0] }
[constraints]
alike = { velocity = "A.vx - B.vx" }
[outputs]
seen = { value = "u", unit = "m" }
"""
    run = solver.Integrator(solver.assemble(solver.loads(text)))
    run.initialise()
    for i in range(3):
        run["u"] = 0.1 * (i + 1)
        run.advance(run.time, 0.1)
        assert run["B.vx"] == pytest.approx(1.0, abs=1e-9)
        assert run["A.vx"] == pytest.approx(1.0, abs=1e-9)
        assert run["seen"] == run["u"]  # though rates of signals look at other times


def test_a_value_without_energy_is_refused_and_leaves_the_ledger_as_it_was():
    text = """
name = "well"
dimension = 2
[parameters]
p = { value = 2.0, variability = "tunable" }
[points]
A = { position = [1, 0], mass = 1.0 }
[forces]
well = { type = "potential", value = "log(p)*A.x" }
"""
    run = solver.Integrator(solver.assemble(solver.loads(text)))
    run.advance(0.0, 0.1)
    with pytest.raises(solver.OptionError, match="finite energy"):
        run["p"] = -1.0
    assert run["p"] == 2.0
    run.advance(run.time, 0.1)
    assert run["energy.error"] < 1e-13


@pytest.mark.parametrize(
    ("spring", "said"),
    [
        ("stiffness = 10.0, free_length = 0.5", "coincide"),
        ("stiffness = 10.0, free_length = 0.0", None),
    ],
)
def test_the_search_for_an_equilibrium_says_what_stopped_it(spring, said):
    text = f"""
name = "hung"
gravity = [0, 0, -9.81]
[points]
A = {{ position = [0, 0, 0], mass = 1.0 }}
[forces]
spring = {{ type = "spring", points = ["ground", "A"], at = [0, 0, 0], {spring} }}
[solver]
start = "equilibrium"
"""
    if said:
        with pytest.raises(solver.SceneError, match=said):
            solver.assemble(solver.loads(text))
        return
    run = solver.Integrator(solver.assemble(solver.loads(text)))
    assert run["A.z"] == pytest.approx(-0.981, abs=1e-10)


def test_no_equilibrium_is_sought_of_loads_that_read_the_motion():
    text = """
name = "servo"
dimension = 2
gravity = [0, -9.81]
[bodies]
arm = { position = [0.4, 0], mass = 1.0, inertia = 0.01 }
[joints]
h = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[forces]
s = { type = "joint_torque", joint = "h", value = "-20*h.angle" }
[solver]
start = "equilibrium"
"""
    with pytest.raises(solver.SceneError, match=r"because force .s. reads the motion; write it as"):
        solver.assemble(solver.loads(text))


def test_a_velocity_that_is_given_stays_and_all_others_follow():
    wishbone = (SCENES / "double_wishbone.toml").read_text(encoding="utf-8")
    car = "[bodies.car]\nposition = [0, 0, 0.5]\n"
    assert car in wishbone
    given = wishbone.replace(car, f"{car}velocity = [0, 0, -0.1]\n")
    run = solver.Integrator(solver.assemble(solver.loads(given)))
    run.initialise()
    # Given velocities weigh 1e8 times, thrice: 1e-24 of what the others would have them give way.
    assert run["car.vz"] == pytest.approx(-0.1, abs=1e-12)
    assert run["constraint.velocity"] < 1e-12
