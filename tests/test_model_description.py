"""modelDescription.xml: numbers that come back, units that mean something, a complete structure."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
import zipfile

import fmpy
import pytest

import solver
from build_fmu.export import generation_date
from build_fmu.model_description import model_description
from build_fmu.units import BaseUnit, base_unit
from solver.runtime import Model
from tests.fmu_instance import SCENES, pendulum, scene_fmu

AWKWARD = [0.1 + 0.2, 1 / 3, 1e-300, 5e-324, 1.7976931348623157e308, 123456789.12345679, -0.0, 1e22]


def root_of(path):
    with zipfile.ZipFile(path) as archive:
        return ElementTree.fromstring(archive.read("modelDescription.xml"))


def described(model: Model):
    text = model_description(model, identifier="a", guid="{g}", date="d", tool="t")
    return ElementTree.fromstring(text)


def awkward_model() -> Model:
    parameters = "\n".join(f"p{i} = {value!r}" for i, value in enumerate(AWKWARD))
    text = f"""
    name = "a"
    description = 'a "quoted" <text> & more'
    dimension = 2
    [parameters]
    {parameters}
    limited = {{ value = 0.3, min = 0.1, max = 0.7, unit = "furlong" }}
    [points]
    O = {{ position = [0, 0], fixed = true }}
    A = {{ position = [1, 0], mass = 1 }}
    [joints]
    rod = {{ type = "distance", points = ["O", "A"] }}
    """
    return solver.assemble(solver.loads(text))


def test_start_values_come_back_as_the_same_doubles():
    root = described(awkward_model())
    for i, value in enumerate(AWKWARD):
        real = root.find(f"ModelVariables/ScalarVariable[@name='p{i}']/Real")
        assert repr(float(real.get("start"))) == repr(value)


def test_limits_units_and_texts_are_written():
    root = described(awkward_model())
    real = root.find("ModelVariables/ScalarVariable[@name='limited']/Real")
    assert real.attrib == {"unit": "furlong", "min": "0.1", "max": "0.7", "start": "0.3"}
    assert root.find("UnitDefinitions/Unit[@name='furlong']/BaseUnit") is None
    assert root.get("description") == 'a "quoted" <text> & more'


def test_value_references_are_the_indices_of_the_models_variables():
    model = solver.assemble(solver.load(SCENES / "four_bar.toml"))
    root = root_of(scene_fmu("four_bar"))
    written = [(v.get("name"), v.get("valueReference")) for v in root.find("ModelVariables")]
    assert written == [(v.name, str(i)) for i, v in enumerate(model.variables)]


def test_every_unit_of_the_scenes_has_base_units():
    root = root_of(scene_fmu("four_bar"))
    units = root.findall("UnitDefinitions/Unit")
    assert {"m", "m/s", "J", "N.m"} <= {unit.get("name") for unit in units}
    assert all(unit.find("BaseUnit") is not None for unit in units)


def test_all_outputs_are_real_and_stand_in_the_structure():
    description = fmpy.read_model_description(str(scene_fmu("double_pendulum")))
    outputs = [v for v in description.modelVariables if v.causality == "output"]
    assert {v.type for v in outputs} == {"Real"}
    assert [u.variable for u in description.outputs] == outputs
    assert {u.variable for u in description.initialUnknowns} >= set(outputs)


def test_capabilities_are_those_that_the_slave_has():
    simulation = fmpy.read_model_description(str(pendulum())).coSimulation
    assert simulation.needsExecutionTool
    assert simulation.canHandleVariableCommunicationStepSize
    assert simulation.canGetAndSetFMUstate
    assert simulation.canSerializeFMUstate
    assert not simulation.canInterpolateInputs
    assert not simulation.providesDirectionalDerivative


def test_the_guid_is_made_of_the_content():
    first, second = (fmpy.read_model_description(str(p)) for p in (pendulum(), pendulum(mass=2.0)))
    assert first.guid != second.guid
    assert re.fullmatch(r"\{[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\}", first.guid)


def test_the_date_is_fixed_or_that_of_the_source(monkeypatch):
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    assert generation_date() == "1980-01-01T00:00:00Z"
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    assert generation_date() == "2023-11-14T22:13:20Z"


def test_the_default_experiment_is_the_scenes():
    experiment = fmpy.read_model_description(str(scene_fmu("four_bar"))).defaultExperiment
    texts = (experiment.startTime, experiment.stopTime, experiment.stepSize)
    assert tuple(map(float, texts)) == (0.0, 10.0, 0.05)


@pytest.mark.parametrize(
    ("unit", "powers", "factor"),
    [
        ("m", {"m": 1}, 1.0),
        ("N.m", {"kg": 1, "m": 2, "s": -2}, 1.0),
        ("N*m", {"kg": 1, "m": 2, "s": -2}, 1.0),
        ("m/s2", {"m": 1, "s": -2}, 1.0),
        ("m/s^2", {"m": 1, "s": -2}, 1.0),
        ("kg m²/s", {"kg": 1, "m": 2, "s": -1}, 1.0),
        ("N.s/m", {"kg": 1, "s": -1}, 1.0),
        ("N.m/rad", {"kg": 1, "m": 2, "s": -2}, 1.0),
        ("N.m.s/rad", {"kg": 1, "m": 2, "s": -1}, 1.0),
        ("rad/s", {"rad": 1, "s": -1}, 1.0),
        ("Hz", {"s": -1}, 1.0),
        ("W", {"kg": 1, "m": 2, "s": -3}, 1.0),
        ("1", {}, 1.0),
        ("1/s", {"s": -1}, 1.0),
        ("m/m", {}, 1.0),
        ("mm", {"m": 1}, 1e-3),
        ("km/h", {"m": 1, "s": -1}, 1e3 / 3600),
        ("m**-2", {"m": -2}, 1.0),
    ],
)
def test_a_unit_is_a_product_of_powers_of_base_units(unit, powers, factor):
    base = base_unit(unit)
    assert base.powers == powers
    assert base.factor == pytest.approx(factor, rel=1e-15)


@pytest.mark.parametrize("unit", ["furlong", "N.", "m//s", "2m", "N m(", "", "m s⁻¹"])
def test_a_unit_that_is_not_known_has_no_base(unit):
    assert base_unit(unit) is None


def test_a_degree_is_a_part_of_a_radian():
    assert base_unit("deg") == BaseUnit({"rad": 1}, 3.141592653589793 / 180)
