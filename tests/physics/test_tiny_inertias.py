"""An inertia below 1e-12 of mass times size squared counts as 0, and is told of."""

from __future__ import annotations

import math
import warnings

import numpy as np
import pytest
from scipy.special import ellipk, ellipkinc

import solver
from build_fmu import build
from solver import SceneError, SceneWarning
from tests.support.fmus.fmu_instance import instance

CART_AND_POLE = """
name = "tiny"
gravity = [0, 0, -9.81]
[parameters]
J = INERTIA
[bodies]
cart = { position = [0, 0, 0], mass = 10, inertia = ["J", "J", "J"] }
pole = { position = [0.3, 0, -0.4], mass = 1, inertia = [J_OF_POLE] }
[joints]
slider = { type = "prismatic", bodies = ["ground", "cart"], axis = [1, 0, 0] }
pin = { type = "revolute", bodies = ["cart", "pole"], position = [0, 0, 0], axis = [0, 1, 0] }
"""
PENDULUM = """
name = "tiny"
dimension = 2
gravity = [0, -9.81]
[parameters]
J = INERTIA
[bodies]
pole = { position = [0.3, -0.4], mass = 1, inertia = "J" }
[joints]
pin = { type = "revolute", bodies = ["ground", "pole"], position = [0, 0] }
"""


def cart_and_pole(inertia: float, *, constant: bool = False) -> str:
    """Text of the scene; the inertias are a parameter, or numbers."""
    text = CART_AND_POLE.replace("INERTIA", repr(inertia)).replace("J_OF_POLE", '"J", "J", "J"')
    return text.replace('"J"', repr(inertia)) if constant else text


def quietly(text: str) -> solver.Scene:
    """Scene of a text, whose warnings nobody wants."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SceneWarning)
        return solver.loads(text)


def swing(scene: solver.Scene) -> np.ndarray:
    """Angles and places of half a second."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        run = solver.simulate(scene, stop_time=0.5, step_size=0.05, tolerance=1e-10)
    return np.column_stack([run["pin.angle"], run["pole.x"]])


@pytest.mark.parametrize("constant", [False, True])
@pytest.mark.parametrize("inertia", [1e-300, 1e-20, 1e-15, 2.4e-13])
def test_a_tiny_inertia_runs_as_none_and_is_told_of(inertia, constant):
    # Of the pole 2.4e-13 < 1e-12 * 1 kg * (0.5 m)^2; of the cart, which has all its places at its
    # centre of mass, with the distance of the pole, 0.5 m: 2.5e-12.
    with pytest.warns(SceneWarning) as told:
        scene = solver.loads(cart_and_pole(inertia, constant=constant))
    locations = [problem.location for problem in scene.warnings if "unused" not in problem.message]
    assert {"bodies.cart.inertia", "bodies.pole.inertia"} <= {*locations}
    sentence = next(str(each.message) for each in told if "pole" in str(each.message))
    assert f"{inertia:.6g} kg.m2 counts as 0: it is below 1e-12 of the mass 1 kg" in sentence
    assert "squared size 0.5 m" in sentence
    none = swing(quietly(cart_and_pole(0.0, constant=constant)))
    assert np.ptp(none[:, 0]) > 0.5
    assert np.array_equal(swing(scene), none)


@pytest.mark.parametrize("inertia", [2.6e-12, 1e-9, 0.1])
def test_other_inertias_are_as_given_and_not_told_of(inertia):
    scene = solver.loads(cart_and_pole(inertia))
    assert scene.warnings == ()
    without = solver.loads(cart_and_pole(inertia), overrides={"J": 2 * inertia})
    assert not np.array_equal(swing(scene), swing(without))


def test_a_pendulum_of_tiny_inertia_is_one_of_a_point_mass():
    """Of 0.5 m, from rest at atan(3/4): by the integral of its energy, after t(angle)."""
    with pytest.warns(SceneWarning):
        scene = solver.loads(PENDULUM.replace("INERTIA", "1e-20"))
    with pytest.warns(RuntimeWarning, match=r"body 'pole': inertia of 1e-20 kg\.m2 counts as 0"):
        run = solver.simulate(scene, stop_time=0.3, step_size=0.05, tolerance=1e-10)
    angle = math.atan2(3.0, 4.0) + run["pin.angle"][-1]  # from straight down
    k = math.sin(math.atan2(3.0, 4.0) / 2.0)
    phase = math.asin(math.sin(angle / 2.0) / k)
    t = (ellipk(k * k) - ellipkinc(phase, k * k)) / math.sqrt(9.81 / 0.5)
    assert t == pytest.approx(0.3, abs=1e-7)


@pytest.mark.parametrize("text", [cart_and_pole(0.1), PENDULUM.replace("INERTIA", "0.1")])
def test_a_parameter_of_an_fmu_that_makes_it_tiny_is_told_of_in_its_log(text, tmp_path):
    """Likewise from tiny to 0.1: the value of the run decides."""
    found = {}
    for default, given in ((0.1, 0.1), (0.1, 1e-20), (1e-20, 1e-20), (1e-20, 0.1)):
        scene = quietly(text.replace("J = 0.1", f"J = {default!r}"))
        with instance(build(scene, tmp_path / f"{default}.fmu")) as fmu:
            fmu.initialise(J=given)
            fmu.run(0.0, 0.1, 3)
            found.setdefault(given, []).append([fmu.get("pole.x"), fmu.get("pin.angle")])
            told = [words for *_, words in fmu.log if "counts as 0" in words]
        assert len(told) == (len(scene.bodies) if given < 0.1 else 0)
    for one, other in found.values():
        assert one == pytest.approx(other, rel=1e-11)


def test_an_inertia_that_a_parameter_makes_flat_or_thick_is_the_one_set():
    """Of a plate or of a ball, whichever the scene has by default."""
    text = """
name = "set"
[parameters]
Jz = 2.0
[bodies.b]
position = [0, 0, 0]
mass = 1
inertia = [1, 1, "Jz"]
points = { tip = [1, 0, 0] }
[forces]
turn = { type = "torque", body = "b", value = [0, 0, 3] }
"""
    for default, given in ((2.0, 1.5), (1.5, 2.0)):
        scene = solver.loads(text, overrides={"Jz": default})
        run = solver.Integrator(solver.assemble(scene))
        run["Jz"] = given
        run.initialise()
        run.advance(0.0, 0.5)
        assert run["b.wz"] == pytest.approx(3.0 * 0.5 / given, rel=1e-6)


def test_bodies_far_from_others_are_not_small_against_the_way_to_them():
    """A satellite with a wheel at its centre of mass, a million kilometres from a planet."""
    text = """
name = "far"
[points]
planet = { position = [1e9, 0, 0], mass = 1e24 }
[bodies]
satellite = { position = [0, 0, 0], mass = 100, inertia = [5, 5, 5] }
wheel = { position = [0, 0, 0], mass = 1, inertia = [0.001, 0.001, 0.002] }
[joints]
axle = { type = "spherical", bodies = ["satellite", "wheel"], position = [0, 0, 0] }
[forces]
pull = { type = "gravitation", points = ["planet", "satellite"] }
"""
    scene = solver.loads(text)
    assert not any("inertia" in problem.location for problem in scene.warnings)
    solver.assemble(scene)


def test_a_lone_body_has_no_size_to_compare_with():
    text = 'name = "one"\n[bodies]\nb = { position = [0, 0, 1], mass = 1, inertia = [J, J, J] }\n'
    assert solver.loads(text.replace("J", "1e-20")).warnings == ()
    solver.assemble(solver.loads(text.replace("J", "1e-20")))
    with pytest.raises(SceneError, match=r"inertia must be > 0 kg\.m2, got 0"):
        solver.assemble(solver.loads(text.replace("J", "0")))
