"""The variable table: a scene's names are those that the mechanism answers to."""

from pathlib import Path

import pytest

import solver
from solver.mechanics.parts import collect
from solver.mechanics.variables import meanings, measured
from solver.scene.names import quantities

SCENES = sorted((Path(__file__).parents[1] / "scenes").glob("*.toml"))


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_every_quantity_an_output_may_use_has_a_meaning(path):
    scene = solver.load(path)
    kinds = {name: type(force).__name__.lower() for name, force in scene.forces.items()}
    allowed = set(
        quantities(scene.dimension, scene.points, scene.bodies, scene.joints, kinds),
    )
    known = {name for name in meanings(scene, collect(scene)) if "." in name}
    assert allowed == known


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_measurements_are_named_in_the_kernels_order(path):
    scene = solver.load(path)
    mechanism = solver.Integrator(solver.assemble(scene))
    names = [name for name, _, _ in measured(collect(scene))]
    mechanism.engine.measure()
    first = next(iter(scene.points[name] for name in scene.points if not scene.points[name].fixed))
    position = [mechanism[name] for name in names[: scene.dimension]]
    expected = [x if isinstance(x, float) else None for x in first.position]
    assert all(e is None or p == e for p, e in zip(position, expected, strict=True))
    assert mechanism["solver.status"] == 0.0
    assert mechanism["energy.total"] == mechanism["energy.kinetic"] + mechanism["energy.potential"]


def test_two_names_of_a_model_never_agree():
    for path in SCENES:
        names = [variable.name for variable in solver.assemble(solver.load(path)).variables]
        assert len(names) == len(set(names)), path.stem
