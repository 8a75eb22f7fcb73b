"""What a model knows of its contacts: variables, dependencies, counts, and rules on numbers."""

from __future__ import annotations

import pytest

import solver
from solver.mechanics.assembly import unchecked_model
from solver.mechanics.mobility import survey
from solver.runtime import AssemblyError, Integrator

TOUCHING = """
name = "touching"
dimension = 2
gravity = [0, -9.81]
[parameters]
e = 0.5
mu = { value = 0.3, variability = "tunable" }
static = 0.4
radius = 0.2
low = -0.1
[inputs]
push = {}
belt = {}
[points]
A = { position = [0, 0.2], mass = 2.0 }
B = { position = [1, 0.2], mass = 1.0 }
O = { position = [0, 5], fixed = true }
[bodies]
arm = { position = [3, 5], mass = 1.0, inertia = 0.1 }
[joints]
hinge = { type = "revolute", bodies = ["ground", "arm"], position = [3, 5] }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1], radius = "radius", restitution = "e", friction = "mu", static_friction = "static", surface_velocity = ["belt", 0] }
pair = { type = "sphere", points = ["A", "B"], radii = [0.5, 0.5] }
ring = { type = "clearance", points = ["B", "O"], radius = 9.0 }
limit = { type = "stop", joint = "hinge", min = "low", max = 0.2 }
[forces]
wind = { type = "force", point = "A", value = ["push", 0] }
"""  # noqa: E501

MODEL = unchecked_model(solver.loads(TOUCHING))[1]
FREE = """
name = "free"
[points]
A = { position = [0, 0, 0], mass = 1.0 }
"""


def variables(part):
    return {v.name.partition(".")[2]: v for v in MODEL.variables if v.name.startswith(f"{part}.")}


def test_a_contact_has_its_quantities_with_units():
    units = {name: v.unit for name, v in variables("floor").items()}
    assert units == {
        "gap": "m", "force": "N", "mode": "1", "impacts": "1", "impulse": "N.s", "friction": "N",
        "slip": "m/s",
    }  # fmt: skip
    assert not variables("pair").keys() & {"friction", "slip"}


def test_a_stop_of_an_angle_has_a_torque():
    units = {name: v.unit for name, v in variables("limit").items()}
    assert units == {
        "gap": "rad", "force": "N.m", "mode": "1", "impacts": "1", "impulse": "N.m.s",
    }  # fmt: skip


def test_losses_events_and_settings_of_contacts_are_variables_only_where_something_touches():
    of_contacts = {
        *(f"energy.{word}" for word in ("damping", "friction", "impact")),
        *(f"solver.{word}" for word in ("events", "stepped", "rest_speed", "rest_time")),
        *(f"solver.{word}" for word in ("max_events", "contact_mode", "impact_law")),
    }
    touching = {v.name for v in MODEL.variables}
    free = {v.name for v in solver.assemble(solver.loads(FREE)).variables}
    assert of_contacts <= touching
    assert not of_contacts & free


def depends(name):
    index = next(k for k, v in enumerate(MODEL.variables) if v.name == name)
    known = MODEL.dependencies[index]
    return (
        {MODEL.variables[k].name for k in known.directly},
        {MODEL.variables[k].name for k in known.at_the_start},
    )


def test_what_a_contact_is_made_of_acts_on_it_at_the_start():
    assert {"e", "mu", "static", "radius", "push", "belt"} <= depends("floor.force")[1]
    assert "low" in depends("limit.gap")[1]
    assert not depends("limit.gap")[1] & {"push", "radius"}
    assert depends("solver.events")[1] == set()


def test_contacts_join_what_they_touch_to_one_island():
    assert MODEL.sizes["n_islands"] == 2  # and the arm


def test_rows_of_contacts_take_no_freedom():
    found = survey(MODEL)
    assert (found.rows, found.redundant_rows) == (3, 0)  # two of the hinge, one of the arm's axis
    assert found.mobility == found.mobility_by_count == found.degrees_of_freedom == 5
    assert found.velocity_freedom == 5


@pytest.mark.parametrize(
    ("parameter", "value", "sentence"),
    [
        ("radius", 0.3, "contact 'floor': it is drawn in penetration: its gap is -0.1 m"),
        ("radius", -0.1, "contact 'floor': radius must be >= 0 m, got -0.1"),
        ("e", 1.5, "contact 'floor': 1 - restitution must be >= 0, got -0.5"),
        ("e", -0.5, "contact 'floor': restitution must be from 0 to 1, got -0.5"),
        ("mu", -0.1, "contact 'floor': friction must be >= 0, got -0.1"),
        ("static", 0.2, "contact 'floor': static_friction - friction must be >= 0, got -0.09"),
        ("low", 0.1, "contact 'limit': it is drawn in penetration at min: its gap is -0.1 rad"),
        ("low", 0.3, "contact 'limit': max - min must be > 0, got -0.09"),
    ],
)
def test_numbers_of_contacts_are_checked_again_when_a_parameter_changes(parameter, value, sentence):
    integrator = Integrator(MODEL)
    integrator[parameter] = value
    with pytest.raises(AssemblyError) as caught:
        integrator.initialise()
    assert any(line.startswith(sentence) for line in str(caught.value).splitlines())
