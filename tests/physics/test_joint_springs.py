"""Springs and dampers that are fields of joints mean what the forces of the same numbers mean."""

from __future__ import annotations

import numpy as np
import pytest

import holonom
import solver

SCENE = """
name = "joint_springs"
dimension = {dimension}
gravity = {gravity}
[parameters]
k = {{ value = 20, variability = "tunable" }}
[bodies]
arm = {{ mass = 2, inertia = {inertia}, position = {place}{turn} }}
[joints]
hinge = {{ type = "{type}", bodies = ["ground", "arm"], position = {origin}{axis}{fields} }}
{forces}
[solver]
step_size = 0.01
{settings}
"""


def scene(dimension: int, type: str, fields: str = "", forces: str = "", **more: str):
    """An arm, whose centre is 0.3 m from the origin, where the joint is."""
    plane = dimension == 2
    along = "[1, 0]" if plane else "[1, 0, 0]"
    axis = f", axis = {along}" if type != "revolute" else ("" if plane else ", axis = [0, 0, 1]")
    turning = type != "prismatic"
    rate = ", angular_velocity = 3, velocity = [0, 0.9]"
    if not plane:
        rate = ", angular_velocity = [0, 0, 3], velocity = [0, 0.9, 0]"
    if turning and type != "revolute":
        rate = ", angular_velocity = [3, 0, 0]"
    slide = ", velocity = [0.5, 0]" if plane else ", velocity = [0.5, 0, 0]"
    numbers = {
        "dimension": dimension,
        "gravity": "[0, -9.81]" if plane else "[0, -9.81, 0]",
        "inertia": "0.1" if plane else "[0.1, 0.2, 0.3]",
        "place": ("[0.3, 0]" if plane else "[0.3, 0, 0]"),
        "turn": rate if turning else slide,
        "type": type,
        "origin": "[0, 0]" if plane else "[0, 0, 0]",
        "axis": axis + (", pitch = 0.4" if type == "screw" else ""),
        "fields": f", {fields}" if fields else "",
        "forces": forces,
        "settings": "",
    }
    text = SCENE.format(**{**numbers, **more})
    return solver.loads(text if "k" in fields + forces else text.replace("[parameters]", "", 1)
                        .replace('k = { value = 20, variability = "tunable" }', ""))  # fmt: skip


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("more", ["", "order = 4", "tolerance = 1e-8"])
def test_a_hinge_with_stiffness_and_damping_has_a_torsion_spring_and_damper(dimension, more):
    fields = 'stiffness = "k", damping = 0.3, free_angle = "0.2 + 0.1*t"'
    forces = """[forces]
s = { type = "torsion_spring", joint = "hinge", stiffness = "k", free_angle = "0.2 + 0.1*t" }
d = { type = "torsion_damper", joint = "hinge", damping = 0.3 }"""
    one = holonom.simulate(scene(dimension, "revolute", fields, settings=more), stop_time=1.0)
    two = holonom.simulate(scene(dimension, "revolute", "", forces, settings=more), stop_time=1.0)
    for name in ("hinge.angle", "hinge.angular_velocity", "energy.total", "energy.dissipated"):
        assert (one[name] == two[name]).all(), name
    assert (one["hinge.spring"] == two["s.torque"]).all()
    assert (one["hinge.damper"] == two["d.torque"]).all()


@pytest.mark.parametrize(
    ("dimension", "type", "of"),
    [
        (2, "prismatic", ""),
        (3, "prismatic", ""),
        (3, "cylindrical", ', of = "displacement"'),
    ],
)
def test_a_slide_with_stiffness_swings_as_the_closed_form_says(dimension, type, of):
    # m s'' = -k (s - s0) - c s' from s = 0, s' = v: a damped oscillator.
    k, c, free, m, v = 50.0, 0.8, 0.05, 2.0, 0.5
    fields = f"stiffness = {k}, damping = {c}, free_displacement = {free}{of}"
    turn = ", velocity = [0.5, 0]" if dimension == 2 else ", velocity = [0.5, 0, 0]"
    found = scene(dimension, type, fields, turn=turn, settings="order = 6")
    run = holonom.simulate(found, stop_time=2.0)
    w, a = np.sqrt(k / m - (c / 2 / m) ** 2), c / 2 / m
    t = run.t
    phase = -free * np.cos(w * t) + (v - a * free) / w * np.sin(w * t)
    exact = free + np.exp(-a * t) * phase
    assert run["hinge.displacement"] == pytest.approx(exact, abs=1e-10)
    assert run["hinge.spring"] == pytest.approx(k * (exact - free), abs=1e-8)
    assert run["hinge.damper"] == pytest.approx(c * run["hinge.velocity"], abs=1e-12)
    assert np.abs(run["energy.balance"]).max() < 1e-12


@pytest.mark.parametrize("of", ["angle", "displacement"])
def test_a_screw_with_a_spring_swings_with_the_inertia_of_both(of):
    # s = p/(2 pi) theta: (I + m p^2/(2 pi)^2) theta'' = -K theta, K = k or k p^2/(2 pi)^2.
    lead, k = 0.4 / (2 * np.pi), 30.0
    turn = f", angular_velocity = [3, 0, 0], velocity = [{3 * lead}, 0, 0]"
    fields = f'stiffness = {k}, of = "{of}"'
    found = scene(3, "screw", fields, settings="order = 6", turn=turn)
    run = holonom.simulate(found, stop_time=1.0)
    stiffness = k if of == "angle" else k * lead**2
    w = np.sqrt(stiffness / (0.1 + 2 * lead**2))
    exact = 3 / w * np.sin(w * run.t)
    assert run["hinge.angle"] == pytest.approx(exact, abs=1e-9)
    along = exact if of == "angle" else lead * exact
    assert run["hinge.spring"] == pytest.approx(k * along, abs=1e-8)


@pytest.mark.parametrize(
    ("type", "of", "units"),
    [
        ("revolute", "", ["N.m", "N.m"]),
        ("prismatic", "", ["N", "N"]),
        ("cylindrical", ', of = "angle"', ["N.m", "N.m"]),
        ("screw", ', of = "displacement"', ["N", "N"]),
    ],
)
def test_spring_and_damper_of_a_joint_have_the_unit_of_what_they_act_on(type, of, units):
    turn = "" if type == "screw" else None
    more = {} if turn is None else {"turn": turn}
    model = solver.assemble(scene(3, type, f"stiffness = 1, damping = 1{of}", **more))
    found = {v.name: v.unit for v in model.variables}
    assert [found["hinge.spring"], found["hinge.damper"]] == units
    twist = "torsion_" if units == ["N.m", "N.m"] else ""
    assert model.forces == {"hinge.spring": f"{twist}spring", "hinge.damper": f"{twist}damper"}


def test_a_joint_without_these_fields_offers_no_spring():
    model = solver.assemble(scene(2, "revolute", "stiffness = 1"))
    names = {v.name for v in model.variables}
    assert "hinge.spring" in names
    assert "hinge.damper" not in names
