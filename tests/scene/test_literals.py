"""Numbers with a unit behind them: "500 mm" is 0.5 to the last bit, and "500 kg" is no length."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import holonom
import solver
from solver.scene import AngleDriver, Rigid, SceneError, SceneWarning, Stop, loads
from solver.scene.fields import ByShape, Kind, ListOf, Quantity, Table, fields_of
from solver.scene.scene import TABLES, Scene
from solver.scene.units import base_unit, literal, misfit

WITH_UNITS = """
name = "press"
dimension = 2
gravity = [0, "-9810 mm/s2"]
[parameters]
length = "500 mm"
mass = { value = "250 g", min = "1 g", max = "2 kg" }
speed = { value = "30 rpm", unit = "rad/s" }
[inputs]
push = { start = "2 kN", max = "5 kN", interpolation = "smooth" }
[profiles]
lobe = { x = ["0 deg", "90 deg", "180 deg"], y = [0, "5 mm", "1 cm"] }
[expressions]
arm = "250 mm"
[points]
O = { position = ["20 cm", 0], fixed = true }
W = { position = ["3 m", 0], mass = "0.1 t", velocity = ["36 km/h", 0] }
[bodies.rod]
position = ["20 cm", 0]
orientation = "30 deg"
mass = "mass"
inertia = "100 kg.cm2"
center_of_mass = ["1 mm", "-2 um"]
points = { tip = ["500 mm", 0] }
[bodies.disc]
position = ["2 m", "-1 mm"]
angular_velocity = "30 rpm"
shape = { type = "disc", radius = "10 cm", density = "8 g/cm2" }
[joints.pin]
type = "revolute"
bodies = ["ground", "rod"]
position = ["20 cm", 0]
friction = { radius = "5 mm", coefficient = "10 %", preload = "1 N.cm" }
[joints.axle]
type = "revolute"
bodies = ["ground", "disc"]
position = ["2 m", "-1 mm"]
[forces]
load = { type = "force", point = "rod.tip", value = ["0.1 kN", "0.001*push - lobe(t) - arm"] }
pad = { type = "spring", points = ["O", "rod.tip"], stiffness = "1 N/mm", free_length = "length" }
oil = { type = "torsion_damper", joint = "pin", damping = "0.5 N.m/rpm" }
twist = { type = "joint_torque", joint = "pin", value = "5 N.mm" }
[contacts]
stop = { type = "stop", joint = "pin", max = "120 deg", min = "-0.5 rev" }
[drivers]
motor = { type = "angle", joint = "axle", value = "speed*t" }
[outputs]
turn = { value = "rod.angle", unit = "rad", display_unit = "deg" }
[solver]
step_size = "1 ms"
[experiment]
stop_time = "50 ms"
step_size = "0.01 s"
"""
IN_SI = {
    '"-9810 mm/s2"': "-9.81", '"500 mm"': "0.5", '"250 g"': "0.25", '"1 g"': "0.001",
    '"2 kg"': "2.0", '"30 rpm"': repr(math.pi), '"2 kN"': "2000.0", '"5 kN"': "5000.0",
    '"0 deg"': "0.0", '"90 deg"': repr(math.pi / 2.0), '"180 deg"': repr(math.pi),
    '"5 mm"': "0.005", '"1 cm"': "0.01", '"250 mm"': "0.25", '"20 cm"': "0.2", '"3 m"': "3.0",
    '"0.1 t"': "100.0", '"36 km/h"': "10.0", '"30 deg"': "0.5235987755982989",
    '"100 kg.cm2"': "0.01", '"1 mm"': "0.001", '"-2 um"': "-2e-06", '"2 m"': "2.0",
    '"-1 mm"': "-0.001", '"10 cm"': "0.1", '"8 g/cm2"': "80.0",
    '"10 %"': "0.1", '"1 N.cm"': "0.01", '"0.1 kN"': "100.0", '"1 N/mm"': "1000.0",
    '"0.5 N.m/rpm"': "4.77464829275686", '"5 N.mm"': "0.005", '"120 deg"': "2.0943951023931957",
    '"-0.5 rev"': repr(-math.pi), '"1 ms"': "0.001", '"50 ms"': "0.05", '"0.01 s"': "0.01",
}  # fmt: skip
"""Each literal of the scene and the double next to it; angles from tables of pi."""


def plain() -> str:
    text = WITH_UNITS
    for written, in_si in IN_SI.items():
        text = text.replace(written, in_si)
    return text


def mistakes(text: str) -> list[str]:
    with pytest.raises(SceneError) as caught:
        loads(text)
    return [f"{x.location}: {x.message}; {x.help}" for x in caught.value.problems]


def test_a_scene_with_units_is_that_in_si():
    with_units, in_si = loads(WITH_UNITS), loads(plain())
    assert '"' in plain()
    for table in {*TABLES} - {"parameters", "inputs", "expressions"}:
        assert getattr(with_units, table) == getattr(in_si, table), table
    assert with_units.gravity == in_si.gravity
    assert with_units.values() == in_si.values()
    assert with_units.parameters["mass"].min == 0.001


def test_a_run_with_units_has_the_bits_of_that_in_si():
    one, two = (holonom.simulate(loads(text)).table for text in (WITH_UNITS, plain()))
    assert one.tobytes() == two.tobytes()


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_an_fmu_of_a_scene_with_units_has_the_bits_of_that_in_si(native, tmp_path):
    runs = []
    for name, text in (("units", WITH_UNITS), ("plain", plain())):
        path = holonom.build(loads(text), tmp_path / f"{name}.fmu", native=native)
        runs.append(holonom.run_fmu(path, settings={"length": 0.4}).values)
    assert runs[0].tobytes() == runs[1].tobytes()
    again = holonom.run_fmu(path, settings={"length": "400 mm"}).values
    assert np.array_equal(again, runs[1])


@given(st.decimals(-(10**6), 10**6, places=9))
def test_a_literal_is_the_double_next_to_its_exact_value(number):
    for unit, factor in (("mm", Fraction(1, 1000)), ("in", Fraction(254, 10000)), ("h", 3600)):
        found = literal(f"{number:f} {unit}")
        assert found is not None
        assert found.value == float(Fraction(number) * factor)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("180deg", math.pi), ("3000 rpm", 100.0 * math.pi), ("1 rev/min", 0.1047197551196597746),
        ("5 bar", 5e5), ("1.5 kN/m", 1500.0), ("1e3 N/mm", 1e6), ("2 kN.m", 2000.0),
        ("2 kN*m", 2000.0), ("2 kN m", 2000.0), ("9.81 m/s^2", 9.81), ("9.81 m/s**2", 9.81),
        ("3 N/(m.s)", 3.0), ("6 mm3", 6e-9), ("50 1/s", 50.0), ("+.5 m", 0.5),
        ("-2.E-1 km", -200.0),
        ("1 psi", 6894.757293168362), ("1 lbf", 4.4482216152605), ("1 kgf", 9.80665),
        ("60 L/min", 1e-3), ("5 µm", 5e-6), ("1 mrad", 1e-3), ("36 km/h", 10.0), ("1 MPa", 1e6),
    ],
)  # fmt: skip
def test_units_and_their_products(text, value):
    found = literal(text)
    assert found is not None
    assert found.value == value


@pytest.mark.parametrize(
    "text",
    [
        "500",
        "mm",
        "2*500 mm",
        "1 if t < 1 else 0",
        "1 or t",
        "3 foo",
        "1e5",
        "500 mm + 1",
        "5 m s/",
    ],
)
def test_what_is_no_literal(text):
    assert literal(text) is None


def kinds() -> list[Kind]:
    """Kinds of all fields, and of what stands in their lists and tables."""
    found: dict[int, Kind] = {}
    parts = [Scene, *(part for table in TABLES.values() for part in table.types)]
    pending = [field.kind for part in parts for field in fields_of(part).values()]
    while pending:
        kind = pending.pop()
        if id(kind) not in found:
            found[id(kind)] = kind
            inner = [getattr(kind, name, None) for name in ("item", "number", "vector", "vectors")]
            pending += [x for x in (*inner, getattr(kind, "table", None)) if x is not None]
            within = kind.parts if isinstance(kind, Table) else ()
            pending += [field.kind for part in within for field in fields_of(part).values()]
            pending += kind.beside.values()
    return [*found.values()]


def test_every_declared_unit_can_be_converted_to_but_one():
    """That of a compliant contact's stiffness depends on the exponent."""
    numbers = [x for x in kinds() if isinstance(x, (Quantity, ListOf, ByShape, Table))]
    declared = {kind.unit for kind in numbers} - {""}
    assert {"m", "kg", "rad or m", "kg.m2", "N.m.s/rad"} <= declared
    alone = {each for unit in declared for each in unit.split(" or ")}
    assert {unit for unit in alone if base_unit(unit) is None} == {"N/m^exponent"}


def test_no_unit_hides_in_the_text_of_a_field():
    texts = [kind.text for kind in kinds() if kind.text and not kind.unit]
    words = {text.split(" ")[0].rstrip(",:") for text in texts} - {"in"}  # which is no inch here
    assert not {word for word in words if base_unit(word)}


@pytest.mark.parametrize(
    ("before", "after", "report"),
    [
        (
            '"500 mm", 0]', '"500 kg", 0]',
            'bodies.rod.points.tip[0]: is 500 kg, and must be in m; write for instance "500 mm"',
        ),
        (
            'orientation = "30 deg"', 'orientation = "30 mm"',
            'bodies.rod.orientation: is 30 mm, and must be in rad; write for instance "30 deg"',
        ),
        (
            'angular_velocity = "30 rpm"', 'angular_velocity = "10 Hz"',
            "bodies.disc.angular_velocity: is 10 Hz, and must be in rad/s; "
            'write for instance "3000 rpm"',
        ),
        (
            '"10 %"', '"10 N"',
            "joints.pin.friction.coefficient: is 10 N, and must be a number without a unit; "
            "leave the unit out",
        ),
        (
            'preload = "1 N.cm"', 'preload = "1 N"',
            'joints.pin.friction.preload: is 1 N, and must be in N.m; write for instance "2 kN.m"',
        ),
        (
            'max = "120 deg"', 'max = "120 mm"',
            'contacts.stop.max: is 120 mm, and must be in rad; write for instance "30 deg"',
        ),
        (
            'density = "8 g/cm2"', 'density = "8 g/cm3"',
            "bodies.disc.shape.density: is 8 g/cm3, and must be in kg/m2; "
            'write for instance "2 kg/m2"',
        ),
        (
            'unit = "rad/s" }', 'unit = "m/s" }',
            'parameters.speed.value: is 30 rpm, and must be in m/s; write for instance "36 km/h"',
        ),
        (
            'min = "1 g"', 'min = "1 mm"',
            'parameters.mass.min: is 1 mm, and must be in kg; write for instance "250 g"',
        ),
        (
            'max = "5 kN"', 'max = "5 kN.m"',
            'inputs.push.max: is 5 kN.m, and must be in N; write for instance "2 kN"',
        ),
        (
            '"90 deg", "180 deg"', '"90 deg", "180 mm"',
            "profiles.lobe.x[2]: is 180 mm, and '0 deg' in the same list measures something else; "
            "write both in one unit",
        ),
        (
            'display_unit = "deg"', 'display_unit = "mm"',
            "outputs.turn.display_unit: is mm, and must be in rad; the unit of turn is rad",
        ),
        (
            'display_unit = "deg"', 'display_unit = "degC"',
            "outputs.turn.display_unit: 'degC' counts from another zero than SI, so that no factor "
            "converts it; give a temperature in K, value + 273.15; a difference of 1 degC is 1 K",
        ),
        (
            'display_unit = "deg"', 'display_unit = "degrees"',
            "outputs.turn.display_unit: there is no unit 'degrees'; did you mean 'deg'?",
        ),
        (
            '"0.1 kN"', '"0.1 kN + 2"',
            "forces.load.value[0]: not an expression, column 5 of '0.1 kN + 2'; a unit stands "
            'behind a single number alone, as in "2 kN"; for kN in a formula write 1000',
        ),
        (
            '"1 ms"', '"1 mm"',
            'solver.step_size: is 1 mm, and must be in s; write for instance "5 ms"',
        ),
    ],
)  # fmt: skip
def test_a_literal_of_another_quantity_is_told_with_a_remedy(before, after, report):
    assert before in WITH_UNITS
    assert mistakes(WITH_UNITS.replace(before, after)) == [report]


@pytest.mark.parametrize(
    ("force", "wrong", "wanted"),
    [
        ('type = "torque", body = "a", value = "5 N.mm"', "N.mm", "N.m"),
        ('type = "actuator", joint = "pin", value = "5 N.mm"', "N.mm", "N.m"),
        ('type = "actuator", points = ["a", "ground"], at = [1, 2], value = "5 kN"', "kN", "N"),
    ],
    ids=["torque", "about", "along"],
)
def test_a_load_is_in_the_unit_of_what_it_does(force, wrong, wanted):
    text = f"""
name = "loads"
dimension = 2
[bodies]
a = {{ position = [0, 0], mass = 1, inertia = 1 }}
[joints]
pin = {{ type = "revolute", bodies = ["ground", "a"], position = [0.1, 0] }}
[forces]
f = {{ {force} }}
"""
    assert loads(text).forces["f"]
    other = {"N.m": "N", "N": "N.m"}[wanted]
    (found,) = mistakes(text.replace(f"5 {wrong}", f"5 {other}"))
    assert found.startswith(f"forces.f.value: is 5 {other}, and must be in {wanted};")


def test_a_stiffness_whose_unit_depends_on_the_exponent_has_none():
    text = """
name = "ball"
dimension = 2
[points]
A = { position = [0, 1], mass = 1 }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1], law = "hertz", stiffness = "1 N/mm" }
"""
    (found,) = mistakes(text)
    assert "must be a plain number in N/m^exponent" in found


def test_a_literal_gives_a_parameter_its_units():
    scene = loads(WITH_UNITS)
    length, mass, speed = (scene.parameters[x] for x in ("length", "mass", "speed"))
    assert (length.unit, length.display_unit) == ("m", "mm")
    assert (mass.unit, mass.display_unit) == ("kg", "g")
    assert (speed.unit, speed.display_unit) == ("rad/s", "rpm")
    push, turn = scene.inputs["push"], scene.outputs["turn"]
    assert (push.unit, push.display_unit) == ("N", "kN")
    assert (turn.unit, turn.display_unit) == ("rad", "deg")
    assert scene.expressions["arm"].unit == "m"


def test_a_display_unit_may_be_given_for_a_number_in_si():
    text = WITH_UNITS.replace('"500 mm"\n', '{ value = 0.5, display_unit = "cm" }\n')
    length = loads(text).parameters["length"]
    assert (length.value, length.unit, length.display_unit) == (0.5, "m", "cm")


@pytest.mark.parametrize("value", ["400mm", "400 mm", "0.4", 0.4, "40 cm"])
def test_overrides_may_have_units(value):
    scene = loads(WITH_UNITS, overrides={"length": value, "points.W.mass": "5 kg"})
    assert scene.parameters["length"].value == 0.4
    assert scene.points["W"].mass == 5.0


@pytest.mark.parametrize("name", ["length", "parameters.length", "mass", "push"])
def test_a_plain_number_in_place_of_a_literal_keeps_the_units(name):
    scene, other = loads(WITH_UNITS), loads(WITH_UNITS, overrides={name: 1.5})
    word = name.rpartition(".")[2]
    for each in (scene, other):
        part = {**each.parameters, **each.inputs}[word]
        assert (part.unit, part.display_unit) == {
            "length": ("m", "mm"), "mass": ("kg", "g"), "push": ("N", "kN"),
        }[word]  # fmt: skip
    assert other.values()[word] == 1.5


@pytest.mark.parametrize("text", ['"500 mm"', '{ value = "500 mm" }'])
def test_an_override_measures_what_the_literal_in_its_place_does(text):
    scene = f"""
name = "o"
dimension = 2
[parameters]
length = {text}
[points]
A = {{ position = ["length", 0], mass = 1 }}
"""
    with pytest.raises(SceneError, match="is 70 kg, and must be in m"):
        loads(scene, overrides={"length": "70 kg"})
    found = loads(scene, overrides={"length": "70 cm"}).parameters["length"]
    assert (found.unit, found.display_unit) == ("m", "cm")


def test_a_parameter_in_a_unit_that_nothing_uses_is_told():
    with pytest.warns(SceneWarning, match="parameters.spare: nothing depends on it"):
        loads(WITH_UNITS.replace("[parameters]", '[parameters]\nspare = "3 mm"'))


def test_an_angle_with_a_unit_is_not_perhaps_in_degrees():
    """One in rad of more than a turn is, and the warning writes it in degrees."""
    text = WITH_UNITS.replace('"-0.5 rev"', '"-2 rev"')
    stop = loads(text).contacts["stop"]
    assert isinstance(stop, Stop)
    assert stop.min == pytest.approx(-4.0 * math.pi, rel=1e-15)
    with pytest.warns(SceneWarning, match='if these are degrees, write "-90 deg"'):
        loads(WITH_UNITS.replace('"-0.5 rev"', "-90"))


def test_a_closed_text_counts_from_a_driver_in_degrees():
    text = """
name = "arm"
dimension = 2
[bodies]
arm = { mass = 1, inertia = 1, position = ["0 mm", 0], orientation = "0 deg" }
[joints]
elbow = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[drivers]
motor = { type = "angle", joint = "elbow", value = "30 deg" }
[solver]
assemble = true
"""
    closed = loads(solver.close(loads(text)).text)
    arm, motor = closed.bodies["arm"], closed.drivers["motor"]
    assert isinstance(arm, Rigid)
    assert isinstance(motor, AngleDriver)
    assert arm.orientation == pytest.approx(math.pi / 6.0, rel=1e-12)
    assert motor.value == pytest.approx(0.0, abs=1e-12)


def test_a_unit_fits_its_quantity_alone():
    assert misfit("rpm", "rad/s") is None
    assert misfit("N.m", "N.m/rad") is None  # as in FMI, the radian does not survive in it
    assert misfit("Hz", "rad/s") is not None
    assert misfit("rad", "") is not None
    assert misfit("%", "") is None
