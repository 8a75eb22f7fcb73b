"""The variable table: a scene's names are those that the mechanism answers to."""

import pytest

import solver
from solver.mechanics.build_mechanism import build_mechanism
from solver.mechanics.outputs import named
from solver.mechanics.sensors import Sensors
from solver.scene import Distance
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.mechanisms.scene_files import ALL
from tests.support.mechanisms.scene_quantities import quantities_of


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_every_quantity_an_output_may_use_has_a_meaning(path):
    scene = solver.load(path)
    asked = frozenset(quantities_of(path.read_text(encoding="utf-8")))
    known = [quantity.name for quantity in named(Sensors(build_mechanism(scene), asked))]
    assert set(known) == asked
    assert len(known) == len(set(known))


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_positions_are_those_of_the_scene_until_it_moves(path):
    scene = solver.load(path)
    mechanism = solver.Integrator(solver.assemble(scene))
    kernel_of(mechanism).measure()
    for name, part in (*scene.points.items(), *scene.bodies.items()):
        position = getattr(part, "position", ())
        for axis, value in zip("xyz", position, strict=False):
            known = any(variable.name == f"{name}.{axis}" for variable in mechanism.model.variables)
            if known and isinstance(value, float):
                assert mechanism[f"{name}.{axis}"] == pytest.approx(value, abs=1e-15)
    assert mechanism["solver.status"] == 0.0
    total = mechanism["energy.kinetic"] + mechanism["energy.potential"]
    assert mechanism["energy.total"] == total


def test_two_names_of_a_model_never_agree():
    for path in ALL:
        names = [variable.name for variable in solver.assemble(solver.load(path)).variables]
        assert len(names) == len(set(names)), path.stem


def test_the_sign_of_every_force_along_a_line_and_torque_about_an_axis_is_described():
    """Components have the sign of their axis; one number alone must say what makes it positive."""
    for path in ALL:
        scene = solver.load(path)
        elements = {*scene.forces, *scene.drivers}
        elements |= {name for name, x in scene.joints.items() if isinstance(x, Distance)}
        for variable in solver.assemble(scene).variables:
            name, _, quantity = variable.name.rpartition(".")
            if name in elements and quantity in ("force", "torque"):
                assert "positive" in variable.description, variable.name
