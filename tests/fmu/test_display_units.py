"""Units in which importers show values: those that a scene names, and usual ones of SI units."""

import math

import fmpy
import pytest
from fmpy.validation import validate_fmu

import holonom
from solver.runtime import Model
from solver.scene import loads
from tests.support.fmus.fmu_instance import root_of

SCENE = """
name = "shown"
dimension = 2
[parameters]
length = "500 mm"
start = { value = "30 deg", unit = "rad" }
stiffness = { value = 2000.0, unit = "N/m", display_unit = "kN/m" }
share = "5 %"
half = { value = "0.5*length", unit = "m", display_unit = "cm" }
[inputs]
supply = { start = "5 bar", max = "10 bar" }
[points]
O = { position = [0, 0], fixed = true }
[bodies.arm]
position = [0, 0]
orientation = "start"
mass = "250 g"
inertia = 0.01
points = { tip = ["length", "half*share"] }
[joints]
pin = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[forces]
s = { type = "spring", points = ["O", "arm.tip"], stiffness = "stiffness" }
f = { type = "force", point = "arm.tip", value = [0, "1e-5*supply"] }
[outputs]
turn = { value = "arm.angle", unit = "rad", display_unit = "deg" }
pace = { value = "arm.angular_velocity", unit = "rad/s", display_unit = "rpm" }
[experiment]
stop_time = 0.05
step_size = 0.01
"""
SHOWN = {
    "length": "mm", "start": "deg", "stiffness": "kN/m", "share": "%", "half": "cm",
    "supply": "bar", "turn": "deg", "pace": "rpm", "arm.angle": None, "arm.x": None,
}  # fmt: skip
KINDS = [{"native": False}, {"native": True}, {"native": True, "fmi": 3}]


@pytest.fixture(scope="module", params=KINDS, ids=["python", "native", "native_3"])
def fmu(request, tmp_path_factory):
    return holonom.build(
        loads(SCENE), tmp_path_factory.mktemp("shown") / "shown.fmu", **request.param
    )


def test_it_is_valid(fmu):
    assert validate_fmu(str(fmu)) == []


def test_fmpy_reads_the_display_unit_of_each_variable(fmu):
    description = fmpy.read_model_description(str(fmu))
    found = {v.name: v.displayUnit for v in description.modelVariables}
    assert {name: found[name] for name in SHOWN} == SHOWN


def test_fmpy_reads_what_a_value_is_in_its_display_unit(fmu):
    """The value is multiplied by the factor: 0.5 m are 500 mm."""
    description = fmpy.read_model_description(str(fmu))
    factors = {
        (unit.name, shown.name): shown.factor
        for unit in description.unitDefinitions
        for shown in unit.displayUnits
    }
    expected = {
        ("m", "mm"): 1000.0, ("m", "cm"): 100.0, ("rad", "deg"): 180.0 / math.pi,
        ("rad/s", "rpm"): 30.0 / math.pi, ("Pa", "bar"): 1e-5, ("N/m", "kN/m"): 1e-3,
        ("1", "%"): 100.0,
    }  # fmt: skip
    assert factors == pytest.approx(expected, rel=1e-15)
    length = next(v for v in description.modelVariables if v.name == "length")
    assert float(length.start or "nan") * factors["m", "mm"] == 500.0


def test_every_display_unit_is_defined_by_the_unit_of_its_variable(fmu):
    root = root_of(fmu)
    defined = {
        unit.get("name"): {x.get("name") for x in unit.findall("DisplayUnit")}
        for unit in root.iter("Unit")
    }
    values = [x for x in root.iter() if x.get("displayUnit")]
    assert len(values) == 8
    assert all(x.get("displayUnit") in defined[x.get("unit")] for x in values)


def test_angles_and_speeds_can_be_shown_in_degrees_and_turns_a_minute_without_a_word(tmp_path):
    text = SCENE.replace(', display_unit = "deg"', "").replace(', display_unit = "rpm"', "")
    path = holonom.build(loads(text.replace('"30 deg"', "0.5")), tmp_path, native=True)
    root = root_of(path)
    for unit, shown in (("rad", "deg"), ("rad/s", "rpm")):
        found = root.findall(f"UnitDefinitions/Unit[@name='{unit}']/DisplayUnit")
        assert [x.get("name") for x in found] == [shown]


def test_a_model_file_keeps_display_units():
    import solver

    model = solver.assemble(loads(SCENE))
    again = Model.from_bytes(model.file)
    assert [v.display_unit for v in again.variables] == [v.display_unit for v in model.variables]
