"""modelDescription.xml: numbers that come back, units that mean something, a complete structure."""

from __future__ import annotations

import ctypes
import re
import xml.etree.ElementTree as ElementTree

import fmpy
import pytest
from fmpy.fmi1 import FMICallException

import solver
from build_fmu import build
from build_fmu.export import generation_date
from build_fmu.model_description import model_description
from build_fmu.xml_parts import Element, document, element
from solver.runtime import Model
from solver.scene.units import BaseUnit, base_unit
from tests.support.fmus.fmu_instance import (
    SCENES,
    instance,
    pendulum,
    root_of,
    scene_fmu,
    text_fmu,
)
from tests.support.fmus.native_fmus import native_scene_fmu
from tests.support.mechanisms.scene_files import ALL

ERROR = 3
AWKWARD = [0.1 + 0.2, 1 / 3, 1e-300, 5e-324, 1.7976931348623157e308, 123456789.12345679, -0.0, 1e22]


def test_a_document_is_that_of_the_standard_library():
    """Elements, texts and attributes with each character that XML writes otherwise."""
    awkward = "a & b < c > d \"e\" 'f'\r\n\tg \u00e4"
    ours = element("r", element("x", a=awkward, b=1.5, c=True, d=None), element("y"))
    ours = Element("r", ours.attributes, [*ours.children, Element("t", text=awkward)])
    theirs = ElementTree.Element("r")
    ElementTree.SubElement(theirs, "x", {"a": awkward, "b": "1.5", "c": "true"})
    ElementTree.SubElement(theirs, "y")
    ElementTree.SubElement(theirs, "t").text = awkward
    ElementTree.indent(theirs)
    head, _, text = document(ours).decode().partition("\n")
    assert head == "<?xml version='1.0' encoding='UTF-8'?>"
    assert text == ElementTree.tostring(theirs, "unicode") + "\n"


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
    limited = {{ value = 0.3, min = 0.1, max = 0.7, unit = "kg/s" }}
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
    assert real.attrib == {
        "declaredType": "In.kg/s", "unit": "kg/s", "min": "0.1", "max": "0.7", "start": "0.3",
    }  # fmt: skip
    base = root.find("UnitDefinitions/Unit[@name='kg/s']/BaseUnit")
    assert base.attrib == {"kg": "1", "s": "-1"}
    assert root.get("description") == 'a "quoted" <text> & more'


def test_value_references_are_the_indices_of_the_models_variables():
    model = solver.assemble(solver.load(SCENES / "four_bar.toml"))
    root = root_of(scene_fmu("four_bar"))
    written = [(v.get("name"), v.get("valueReference")) for v in root.find("ModelVariables")]
    assert written == [(v.name, str(i)) for i, v in enumerate(model.variables)]


def test_value_references_of_fmi_3_are_places_in_the_list_from_1_and_0_for_the_time():
    """OMSimulator takes those of dependencies for places: from 0, it refused this scene."""
    root = root_of(native_scene_fmu("four_bar", 3))
    written = [v.get("valueReference") for v in root.find("ModelVariables")]
    assert written == [*map(str, range(1, len(written))), "0"]
    assert root.find("ModelVariables")[-1].get("name") == "time"
    depends = [set(x.get("dependencies").split()) for x in root.find("ModelStructure")]
    assert set.union(*depends) <= set(written) - {"0"}
    assert any("1" in each for each in depends)


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
        ("mN", {"kg": 1, "m": 1, "s": -2}, 1e-3),
        ("mN.m", {"kg": 1, "m": 2, "s": -2}, 1e-3),
        ("mN*m", {"kg": 1, "m": 2, "s": -2}, 1e-3),
        ("m.N", {"kg": 1, "m": 2, "s": -2}, 1.0),
        ("kN/m", {"kg": 1, "s": -2}, 1e3),
        ("N/mm", {"kg": 1, "s": -2}, 1e3),
        ("N/mm2", {"kg": 1, "m": -1, "s": -2}, 1e6),
        ("mrad/s", {"rad": 1, "s": -1}, 1e-3),
        ("mHz", {"s": -1}, 1e-3),
        ("hPa", {"kg": 1, "m": -1, "s": -2}, 100.0),
        ("um", {"m": 1}, 1e-6),
        ("\u00b5m", {"m": 1}, 1e-6),
        ("\u03bcm", {"m": 1}, 1e-6),
        ("1/mm3", {"m": -3}, 1e9),
        ("mg", {"kg": 1}, 1e-6),
        ("Mg", {"kg": 1}, 1e3),
        ("g.cm2", {"kg": 1, "m": 2}, 1e-7),
        ("daN", {"kg": 1, "m": 1, "s": -2}, 10.0),
        ("cd", {"cd": 1}, 1.0),
        ("min", {"s": 1}, 60.0),
        ("Pa", {"kg": 1, "m": -1, "s": -2}, 1.0),
        ("mmol", {"mol": 1}, 1e-3),
        ("kOhm", {"kg": 1, "m": 2, "s": -3, "A": -2}, 1e3),
        ("kW.h", {"kg": 1, "m": 2, "s": -2}, 3.6e6),
    ],
)
def test_a_unit_is_a_product_of_powers_of_base_units(unit, powers, factor):
    base = base_unit(unit)
    assert base.powers == powers
    assert base.factor == pytest.approx(factor, rel=1e-15)


@pytest.mark.parametrize(
    "unit", ["kkg", "mmm", "mdeg", "degC", "furlong", "N.", "m//s", "2m", "N m(", "", "m s⁻¹"]
)
def test_a_unit_that_is_not_known_has_no_base(unit):
    assert base_unit(unit) is None


def test_a_unit_is_written_as_fmi_does():
    """So that N*m and N.m are one unit, of one type: the torque of SI."""
    text = (
        'name = "x"\ndimension = 2\n[points]\nA = { position = [0, 0], mass = 1 }\n[parameters]\n'
    )
    text += 'a = { value = 1, unit = "N*m" }\nb = { value = 1, unit = "N.m" }\n'
    text += 'c = { value = 1, unit = "kg*m^2/s**2" }\nd = { value = 1, unit = "kg m²" }\n'
    text += '[outputs]\ne = { value = "a + b + c + d", unit = "N*m/rad" }\n'
    root = root_of(text_fmu(text))
    of_name = {v.get("name"): v[0] for v in root.iter("ScalarVariable")}
    expected = {"a": "N.m", "b": "N.m", "c": "kg.m2/s2", "d": "kg.m2", "e": "N.m/rad"}
    assert {name: of_name[name].get("unit") for name in expected} == expected
    assert of_name["a"].get("declaredType") == of_name["b"].get("declaredType") == "SI.Torque"
    bases = {x.get("name"): x.find("BaseUnit").attrib for x in root.iter("Unit")}
    assert bases["N.m"] == {"kg": "1", "m": "2", "s": "-2"}
    assert "N*m" not in bases


def test_a_degree_is_a_part_of_a_radian():
    assert base_unit("deg") == BaseUnit({"rad": 1}, 3.141592653589793 / 180)


# -------------------------------------------------------- types, limits, the scene, derivatives


@pytest.mark.parametrize("name", ["four_bar", "stewart", "double_wishbone"])
def test_every_real_with_a_unit_has_a_declared_type_of_this_unit(name):
    root = root_of(scene_fmu(name))
    units = {
        each.get("name"): each.find("Real").get("unit")
        for each in root.findall("TypeDefinitions/SimpleType")
    }
    names = {variable.get("name") for variable in root.find("ModelVariables")}
    assert units
    assert not names & units.keys()
    for variable in root.findall("ModelVariables/ScalarVariable[Real]"):
        real = variable.find("Real")
        assert units.get(real.get("declaredType")) == real.get("unit")


def test_nominal_values_tell_the_size_of_what_moves():
    # Four-bar: bars of 1 m and 1 kg, a crank at 1 rad/s at first and energies of some 10 J.
    root = root_of(scene_fmu("four_bar"))
    nominal = {
        real.get("unit"): float(real.get("nominal", "nan"))
        for real in root.findall("TypeDefinitions/SimpleType/Real")
    }
    assert (nominal["m"], nominal["m/s"]) == (1.0, 10.0)
    assert nominal["J"] == 100.0


def test_settings_have_the_limits_that_are_checked():
    model = solver.assemble(solver.load(SCENES / "four_bar.toml"))
    integrator = solver.Integrator(model)
    for variable in model.variables:
        if variable.kind == "option" and variable.type == "Real":
            assert variable.minimum is not None
            assert variable.maximum is not None
            for value in (variable.minimum, variable.maximum):
                integrator[variable.name] = value
            for value in (variable.minimum - 1.0, 2.0 * variable.maximum):
                with pytest.raises(solver.OptionError, match=variable.name):
                    integrator[variable.name] = value


def test_the_scene_travels_as_an_annotation_and_gives_the_same_model():
    path = SCENES / "double_pendulum.toml"
    root = root_of(scene_fmu("double_pendulum"))
    scene = root.find("VendorAnnotations/Tool[@name='holonom']/Scene")
    text = scene.findtext("Text")
    assert text == path.read_text(encoding="utf-8")
    again = solver.assemble(solver.loads(text, format=scene.get("format")))
    assert again.fingerprint == solver.assemble(solver.load(path)).fingerprint


def test_overrides_stand_beside_the_scene(tmp_path):
    path = build(SCENES / "double_pendulum.toml", tmp_path / "a.fmu", parameters={"mass": 2.5})
    texts = [each.text for each in root_of(path).findall("VendorAnnotations/Tool/Scene/Override")]
    assert texts == ["mass=2.5"]
    assert fmpy.read_model_description(str(path)).modelName == "double_pendulum"


def test_characters_that_xml_does_not_have_do_not_spoil_the_description():
    text = PLAIN.replace('"plain"', r'"a\u0007b\uFFFE"').replace("# note", "# \ufffe")
    scene = solver.loads(text)
    model = solver.assemble(scene)
    xml = model_description(
        model, identifier="a", guid="{g}", date="d", tool="t", source=scene.source
    )
    assert ElementTree.fromstring(xml).get("description") == "a\ufffdb\ufffd"


PLAIN = """
name = "a"
description = "plain" # note
dimension = 2
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
"""


def test_derivatives_that_the_wrapper_does_not_carry_are_not_promised():
    simulation = fmpy.read_model_description(str(pendulum())).coSimulation
    assert not simulation.canInterpolateInputs
    assert simulation.maxOutputDerivativeOrder == 0
    with instance(pendulum()) as fmu:
        fmu.initialise()
        for call in (fmu.fmu.fmi2SetRealInputDerivatives, fmu.fmu.fmi2GetRealOutputDerivatives):
            references, orders = (ctypes.c_uint32 * 1)(0), (ctypes.c_int32 * 1)(1)
            with pytest.raises(FMICallException) as caught:
                call(fmu.fmu.component, references, 1, orders, (ctypes.c_double * 1)())
            assert caught.value.status == ERROR
        assert fmu.step(0.0, 0.1)


ALLOWED = {
    ("parameter", "fixed", "exact"),
    ("parameter", "tunable", "exact"),
    ("calculatedParameter", "fixed", "calculated"),
    ("calculatedParameter", "tunable", "calculated"),
    ("input", "continuous", None),
    ("output", "continuous", "calculated"),
}
"""Causality, variability and initial of FMI 2.0.5, 2.2.7, as far as they occur here."""


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_causality_variability_initial_and_start_fit_each_other(path):
    root = described(solver.assemble(solver.load(path)))
    variables = root.findall("ModelVariables/ScalarVariable")
    assert len({v.get("name") for v in variables}) == len(variables)
    for variable in variables:
        kind = (variable.get("causality"), variable.get("variability"), variable.get("initial"))
        assert kind in ALLOWED
        (value,) = variable
        start = value.get("start")
        assert (start is None) == (variable.get("initial") == "calculated")
        if start is not None and value.tag == "Real":
            low, high = value.get("min", "-inf"), value.get("max", "inf")
            assert float(low) <= float(start) <= float(high)


def test_a_parameter_calculated_from_a_tunable_one_is_tunable_and_lists_it():
    root = root_of(scene_fmu("spring_pendulum"))
    variables = root.findall("ModelVariables/ScalarVariable")
    indices = {v.get("name"): str(i) for i, v in enumerate(variables, 1)}
    frequency = variables[int(indices["frequency"]) - 1]
    assert frequency.get("variability") == "tunable"
    unknown = root.find(f"ModelStructure/InitialUnknowns/Unknown[@index='{indices['frequency']}']")
    known = {indices["stiffness"], indices["mass"]}
    assert set(unknown.get("dependencies").split()) == known
