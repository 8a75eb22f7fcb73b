"""Mechanisms that stand still, or almost, under a tolerance: steps do not fail, and nothing moves.

Where nothing moves, round-off of the energy is more than the kinetic energy: no change of the
velocities may be made of it.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_runs import Array, scene, steps_explicitly

PLANE = 'name = "rest"\ndimension = 2\ngravity = [0, -9.81]\n'
SPACE = 'name = "rest"\ngravity = [0, 0, -9.81]\n'
HANGING = """
[bodies]
arm = { position = [0, -0.3], orientation = 0.3, mass = 2, inertia = 0.2 }
[joints]
hinge = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
"""
DAMPED = """
[forces]
damper = { type = "torsion_damper", joint = "hinge", damping = 0.5 }
"""
CART_AND_POLE = """
[bodies]
cart = { position = [0, 0, 0], mass = 10, inertia = [0.1, 0.1, 0.1] }
pole = { position = [0, 0, -0.5], mass = 1, inertia = [0.1, 0.1, 0.1] }
[joints]
slider = { type = "prismatic", bodies = ["ground", "cart"], axis = [1, 0, 0] }
pin = { type = "revolute", bodies = ["cart", "pole"], position = [0, 0.3, 0], axis = [0, 1, 0] }
"""
TRUSS = """
[points]
A = { position = [1, 1], mass = 1 }
[joints]
a = { type = "distance", points = ["ground", "A"], at = [0, 0] }
b = { type = "distance", points = ["ground", "A"], at = [2, 0] }
"""
SPRINGS = """
[points]
A = { position = [0.3, 0], mass = 1e-3 }
[forces]
left = { type = "spring", points = ["ground", "A"], at = [0, 0], stiffness = 1e7, free_length = 0.2 }
right = { type = "spring", points = ["ground", "A"], at = [1, 0], stiffness = 1e7, free_length = 0.6 }
"""  # noqa: E501
BESIDE = """
[bodies]
arm = { position = [0, -0.3], orientation = 0.3, mass = 2, inertia = 0.2 }
leg = { position = [3, 0], mass = 2, inertia = 0.2 }
[joints]
hinge = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
other = { type = "revolute", bodies = ["ground", "leg"], position = [2, 0] }
"""


def held(links: int, excess: float = 0.0) -> str:
    """Level arm of links of 1 m and 1 kg whose joint torques balance its weight, but for a part."""
    before = ("ground", *(f"b{i}" for i in range(links)))
    text = SPACE + "[bodies]\n"
    for i in range(links):
        text += f"b{i} = {{ position = [{i + 0.5}, 0, 0], mass = 1, inertia = [0.01, 0.1, 0.1] }}\n"
    text += "[joints]\n"
    for i in range(links):
        text += f'j{i} = {{ type = "revolute", bodies = ["{before[i]}", "b{i}"], '
        text += f"position = [{i}, 0, 0], axis = [0, 1, 0] }}\n"
    text += "[forces]\n"
    for i in range(links):
        torque = -9.81 * (links - i) ** 2 / 2 * (1 + excess)
        text += f't{i} = {{ type = "joint_torque", joint = "j{i}", value = {torque!r} }}\n'
    return text


STANDING = {
    "hanging": PLANE + HANGING,
    "hanging, damped": PLANE + HANGING + DAMPED,
    "cart and pole": SPACE + CART_AND_POLE,
    "truss": PLANE + TRUSS,
    "springs": 'name = "rest"\ndimension = 2\n' + SPRINGS,
    **{f"arm of {links}, held": held(links) for links in (1, 3, 6)},
    "beside one that swings": PLANE + BESIDE,
}
SETTINGS = [(order, tolerance) for order in (0, 4, 8) for tolerance in (1e-2, 1e-6, 1e-10)]
OF_EQUILIBRIUM = ("bricard", "chain", "double_pendulum", "four_bar", "heavy_top", "pendulum")
ROUND_OFF = 5e-12
"""Of places over the size, and of energies over the reference energy, which at rest is a thousandth
of weights and springs: these are summed to a few times 1e-16 of them."""


@cache
def model_of(text: str) -> solver.Model:
    """Model of a scene's text."""
    return solver.assemble(solver.loads(text))


def run(text: str, names: list[str], every: float, stop: float, **settings: Any) -> Array:
    """Values (n, len(names)) every so many seconds."""
    found = solver.simulate(
        model_of(text), step_size=every, stop_time=stop, outputs=names, **settings
    )
    return found.table


@pytest.mark.parametrize(("order", "tolerance"), SETTINGS)
@pytest.mark.parametrize("name", STANDING)
def test_what_is_at_rest_in_equilibrium_stays(name: str, order: int, tolerance: float) -> None:
    part = next(p for p in ("A", "arm", "pole", "b0") if f"\n{p} = " in STANDING[name])
    names = [f"{part}.x", f"{part}.y", "energy.error"]
    if name == "beside one that swings":
        names[-1] = "arm.angle"
    found = run(STANDING[name], names, 0.05, 0.5, order=order, tolerance=tolerance)
    assert np.abs(found - found[0]).max() < ROUND_OFF


@pytest.mark.parametrize(("order", "tolerance"), [(0, 1e-2), (0, 1e-8), (8, 1e-4)])
@pytest.mark.parametrize("name", [*OF_EQUILIBRIUM, "rolling_disc", "watt"])
def test_scenes_stay_in_their_equilibrium(name: str, order: int, tolerance: float) -> None:
    model = solver.assemble(solver.load(scene(name)))
    integrator = solver.Integrator(model, log=lambda _: None)
    settings = {"start": "equilibrium", "order": float(order), "tolerance": tolerance}
    for key, value in settings.items():
        integrator[f"solver.{key}"] = value
    integrator.initialise()
    before = np.array(integrator.state.vectors["q"])
    for _ in range(6):
        integrator.advance(integrator.time, 0.05)
    moved = np.abs(np.array(integrator.state.vectors["q"]) - before).max()
    assert moved < 3e-10 * integrator.numbers[model.offsets["extent"]]  # sought to 1e-10 of it
    assert integrator.state.head["ledger_error"] < ROUND_OFF


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-10])
@pytest.mark.parametrize("torque", [1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize(("method", "part"), [("fastest", 2e-4), ("conserving", 5e-3)])
def test_a_tiny_load_drives_a_pole_from_its_balance(
    torque: float, tolerance: float, method: str, part: float
) -> None:
    """An upright pole falls as cosh w t; at first round-off of the energy is much of its motion.

    In communication steps of 0.05 s, which are the longest, pairs change w by (w h)^2/12, 3e-3 of
    it at most.
    """
    text = (
        PLANE
        + f"""[bodies]
pole = {{ position = [0, 0.5], mass = 1, inertia = 0.1 }}
[joints]
pin = {{ type = "revolute", bodies = ["ground", "pole"], position = [0, 0] }}
[forces]
f = {{ type = "joint_torque", joint = "pin", value = {torque} }}
"""
    )
    found = run(text, ["pole.x"], 0.05, 1.5, tolerance=tolerance, method=method)[:, 0]
    weight = 9.81 * 0.5
    growth = np.cosh(math.sqrt(weight / 0.35) * np.linspace(0.0, 1.5, len(found))) - 1.0
    exact = -0.5 * torque / weight * growth
    assert np.abs(found - exact).max() < min(3.0 * tolerance, part * np.abs(exact).max())


@pytest.mark.parametrize("excess", [1e-15, 1e-12, 1e-9, 1e-6])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-10])
def test_an_arm_that_is_almost_held_rises_slowly(excess: float, tolerance: float) -> None:
    found = run(held(1, excess), ["b0.z"], 0.05, 0.5, tolerance=tolerance)[:, 0]
    time = np.linspace(0.0, 0.5, len(found))
    exact = 0.25 * excess * 9.81 * 0.5 / 0.35 * time**2  # the next term is its square
    assert found == pytest.approx(exact, abs=min(tolerance, 1e-3 * excess) + 1e-16)
    run(held(3, excess), ["b0.z"], 0.05, 0.5, tolerance=tolerance)


@pytest.mark.parametrize("order", [0, 4, 8])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-10])
def test_a_damped_arm_swings_to_rest(order: int, tolerance: float) -> None:
    text = (PLANE + HANGING + DAMPED).replace("[0, -0.3]", "[0.3, 0]")
    found = run(text, ["arm.x", "energy.error"], 1.0, 40.0, order=order, tolerance=tolerance)
    assert np.abs(found[-1, 0]) < 3.0 * max(tolerance, 1e-9)  # exp(-0.66 t) of 0.3 m: 1e-12
    assert found[:, 1].max() < ROUND_OFF


def test_what_almost_rests_in_flight_takes_explicit_steps() -> None:
    """Its momenta leave it no velocity, and its steady spin no turn, that would change its energy.

    So round-off of the energy cannot be brought back, and need not be.
    """
    text = 'name = "a"\n[bodies]\nb = { position = [1, 2, 3], mass = 1, inertia = [1, 2, 3], '
    integrator = solver.Integrator(model_of(text + "angular_velocity = [1e-9, 0, 0] }\n"))
    integrator["solver.tolerance"], integrator["solver.method"] = 1e-6, "fastest"
    integrator.initialise()
    integrator.advance(0.0, 0.05)
    assert steps_explicitly(integrator)
    assert float(integrator["energy.error"]) < ROUND_OFF
