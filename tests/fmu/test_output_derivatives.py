"""fmi2GetRealOutputDerivatives and fmi3GetOutputDerivatives of native FMUs (docs/native.md)."""

from __future__ import annotations

import ctypes
import random
import tempfile

import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from hypothesis import given
from hypothesis import strategies as st

import solver
from build_fmu.instance import Log
from tests.fmu.test_fmu_scenes import ALL_SCENES
from tests.physics.test_smooth_inputs import ARM
from tests.support.fmus.fmu_instance import Instance, instance, text_fmu
from tests.support.fmus.native_fmus import native_fmu, native_scene_fmu, slave_of_fmi3
from tests.support.mechanisms.problems import assemble
from tests.support.mechanisms.random_mechanisms import driven_systems, free_systems

ERROR = 3
RATES = {
    "angle": "angular_velocity", "displacement": "velocity",
    **{axis: f"v{axis}" for axis in "xyz"},
}  # fmt: skip
"""Last words of outputs, and of those that are their rates."""


def outputs_of(fmu: Instance) -> list[str]:
    return [v.name for v in fmu.description.modelVariables if v.causality == "output"]


def derivatives(fmu: Instance, *names: str) -> list[float]:
    """Derivatives of outputs by their names, or of all."""
    references = [fmu.references[name] for name in names or outputs_of(fmu)]
    return fmu.fmu.getRealOutputDerivatives(references, [1] * len(references))


def check_measured_rates(fmu: Instance) -> int:
    """Compare each derivative with the output that shows it; return how many there are."""
    outputs = outputs_of(fmu)
    value, rate = (dict(zip(outputs, x, strict=True)) for x in (fmu.outputs(), derivatives(fmu)))
    found = 0
    for name in outputs:
        part, _, word = name.rpartition(".")
        other = f"{part}.{RATES.get(word)}"
        if other in value and part not in ("momentum", "angular_momentum"):
            assert rate[name] == value[other], name
            found += 1
    return found


def check_balance(fmu: Instance) -> None:
    """At the start, where constraints have no rates, what acts puts its power into the energy."""
    names = "energy.work", "energy.dissipated", "energy.kinetic", "energy.potential", "energy.total"
    work, dissipated, kinetic, potential, total = derivatives(fmu, *names)
    size = max(map(abs, (work, dissipated, kinetic, potential)))
    energies = abs(fmu.get("energy.kinetic")), abs(fmu.get("energy.potential"))
    rounded = 1e-8 * (1.0 + max(energies))  # some 1e-15 of these over 1e-2 of a step, twice
    assert total == pytest.approx(kinetic + potential, abs=1e-7 * size + rounded)
    sampled = 2e-3  # works are booked over hundredths of a step, which begins from rest [W]
    assert total == pytest.approx(work - dissipated, abs=1e-6 * size + rounded + sampled)


@pytest.mark.parametrize("name", ALL_SCENES)
def test_of_a_scene_derivatives_are_the_measured_rates_and_asking_changes_nothing(name):
    """The twin is never asked; the one that is asked comes back to a saved state as well."""
    path = native_scene_fmu(name)
    with instance(path) as fmu, instance(path) as twin:
        h = float(fmu.description.defaultExperiment.stepSize)
        for each in (fmu, twin):
            each.initialise()
        check_balance(fmu)
        for k in range(6):
            asked = derivatives(fmu)
            saved = fmu.fmu.getFMUstate()
            assert fmu.outputs() == twin.outputs()
            for each in (fmu, twin):
                assert each.step(k * h, h)
            fmu.fmu.setFMUState(saved)
            assert derivatives(fmu) == asked
            fmu.fmu.freeFMUState(saved)
            assert fmu.step(k * h, h)
            check_measured_rates(fmu)
        assert fmu.outputs() == twin.outputs()


@given(st.one_of(free_systems(), driven_systems().map(lambda content: (content, 0.01))))
def test_of_a_random_mechanism_derivatives_are_the_measured_rates_from_the_start_on(drawn):
    content, h = drawn
    with instance(native_fmu(assemble(content, step_size=h))) as fmu:
        fmu.initialise()
        check_balance(fmu)
        for k in range(4):
            assert check_measured_rates(fmu) >= len(content["points"]) - 1
            assert fmu.step(k * h, h)


FORCED = """
name = "forced"
dimension = 2
gravity = [0, -9.81]
[inputs]
push = { start = 0.0, interpolation = "ramp" }
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1.0 }
B = { position = [2, 0.5], mass = 2.0 }
P = { position = [3, 1], fixed = true }
[joints]
rod = { type = "distance", points = ["O", "A"] }
link = { type = "distance", points = ["A", "B"] }
[forces]
wind = { type = "force", point = "A", value = ["push", "sin(3*t)"] }
rope = { type = "spring", points = ["B", "P"], stiffness = 20.0, free_length = 0.5 }
drag = { type = "damper", points = ["B", "P"], damping = 0.3 }
[outputs]
clock = { value = "t", unit = "s" }
heading = { value = "atan2(A.y, A.x)", unit = "rad" }
size = { value = "abs(B.vx)", unit = "m/s" }
shared = { value = "push", unit = "N" }
"""


def derivatives_and_differences(h: float) -> dict[str, float]:
    """Largest error of each derivative beside central differences of outputs, over 0.2 s."""
    model = solver.assemble(solver.loads(FORCED + f"[solver]\nstep_size = {h!r}\n"))
    with instance(native_fmu(model)) as fmu:
        fmu.initialise()
        names, values, rates = outputs_of(fmu), [], []
        for k in range(round(0.2 / h)):
            fmu.set(push=5.0 * (k + 1) * h)
            assert fmu.step(k * h, h)
            values.append(fmu.outputs())
            rates.append(derivatives(fmu))
    measured = np.gradient(np.array(values), h, axis=0)[2:-1]
    errors = np.abs(np.array(rates)[2:-1] - measured).max(axis=0)
    return dict(zip(names, errors / (1.0 + np.abs(measured).max(axis=0)), strict=True))


FIRST_ORDER = ("rod.force", "link.force")
"""Multipliers lie on the line through the means of the last two steps, one and a half behind."""
COUNTED = ("solver.", "constraint.", "energy.error", "energy.balance")


def test_derivatives_are_those_of_the_outputs_and_their_errors_fall_with_the_step():
    """Central differences have an error of h^2, which of the others is all there is."""
    coarse, fine = derivatives_and_differences(0.01), derivatives_and_differences(0.0025)
    compared = [name for name in fine if not name.startswith(COUNTED)]
    assert len(compared) > 20
    for name in compared:
        power = 1 if name in FIRST_ORDER else 2
        assert fine[name] < (0.2 if power == 1 else 1e-3), name
        assert fine[name] < 2.0 * 4.0**-power * coarse[name] + 1e-9, name
    with instance(native_fmu(solver.assemble(solver.loads(FORCED)))) as fmu:
        fmu.initialise()
        fmu.set(push=1.0)
        assert fmu.step(0.0, 0.1)
        assert derivatives(fmu, "clock", "shared") == pytest.approx([1.0, 10.0], abs=1e-9)
        assert derivatives(fmu, "solver.substeps", "energy.error") == [0.0, 0.0]


@pytest.mark.parametrize("name", ["jansen_with_clearance", "double_wishbone", "quarter_car"])
def test_fmi_3_gives_the_derivatives_of_fmi_2_bit_for_bit(name):
    with (
        instance(native_scene_fmu(name)) as two,
        tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder,
    ):
        three = slave_of_fmi3(native_scene_fmu(name, 3), folder)
        references = [two.references[name] + 1 for name in outputs_of(two)]
        two.initialise()
        three.setupExperiment(startTime=0.0)
        three.enterInitializationMode()
        three.exitInitializationMode()
        for k in range(4):
            orders = [1] * len(references)
            assert three.getOutputDerivatives(references, orders) == derivatives(two)
            two.step(k * 0.01, 0.01)
            three.doStep(k * 0.01, 0.01)
        three.terminate()
        three.freeInstance()


REFUSED = {
    "order 0": ("A.x", 0, "outputs have derivatives of order 1, not of order 0"),
    "order 2": ("A.x", 2, "outputs have derivatives of order 1, not of order 2"),
    "an input": ("push", 1, "push has no derivative: it is no output"),
    "a setting": ("solver.step_size", 1, "solver.step_size has no derivative: it is no output"),
    "no variable": (None, 1, "value references [9999] are not those of Real variables"),
    "a word": ("solver.start", 1, "are not those of Real variables"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_both_versions_refuse_the_same_with_one_sentence_and_nothing_changes(case):
    name, order, sentence = REFUSED[case]
    model, log = solver.assemble(solver.loads(FORCED)), Log()
    with (
        instance(native_fmu(model)) as two,
        tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder,
    ):
        reference = two.references[name] if name else 9999
        three = slave_of_fmi3(native_fmu(model, 3), folder, log)
        two.initialise()
        three.setupExperiment(startTime=0.0)
        three.enterInitializationMode()
        three.exitInitializationMode()
        before = two.outputs()
        calls = two.fmu.getRealOutputDerivatives, three.getOutputDerivatives
        for first, call in enumerate(calls):  # references begin with 0 and 1
            with pytest.raises(FMICallException) as caught:
                call([two.references["A.x"] + first, reference + first], [1, order])
            assert caught.value.status == ERROR
        assert two.outputs() == before
        assert sentence in two.log[-1][2]
        assert log.messages[-1].replace(f"[{reference + 1}]", f"[{reference}]") == two.log[-1][2]
        three.freeInstance()


def test_missing_memory_is_refused():
    with instance(text_fmu(FORCED, native=True)) as fmu:
        fmu.initialise()
        one, order = (ctypes.c_uint32 * 1)(fmu.references["A.x"]), (ctypes.c_int32 * 1)(1)
        value = (ctypes.c_double * 1)()
        for arguments in ((None, 1, order, value), (one, 1, None, value), (one, 1, order, None)):
            with pytest.raises(FMICallException) as caught:
                fmu.fmu.fmi2GetRealOutputDerivatives(fmu.fmu.component, *arguments)
            assert caught.value.status == ERROR
            assert len(fmu.log[-1][2]) > 20
        fmu.fmu.fmi2GetRealOutputDerivatives(fmu.fmu.component, None, 0, None, None)


def test_derivatives_are_the_same_whoever_asks_for_how_many():
    """One by one, all at once, in any order, in a restored twin."""
    chance = random.Random(5)
    path = native_scene_fmu("four_bar_with_clearance")
    with instance(path) as fmu, instance(path) as other:
        for each in (fmu, other):
            each.initialise()
        fmu.run(0.0, 0.01, 30)
        names = outputs_of(fmu)
        known = dict(zip(names, derivatives(fmu), strict=True))
        state = fmu.fmu.serializeFMUState(fmu.fmu.getFMUstate())
        other.fmu.setFMUState(other.fmu.deserializeFMUState(state))
        for each in (fmu, other):
            asked = chance.sample(names, 12)
            assert derivatives(each, *asked) == [known[name] for name in asked]
            for name in asked:
                assert derivatives(each, name) == [known[name]]


def test_derivatives_know_the_acceleration_of_a_smooth_input():
    """An arm that u = t^2/2 turns: its velocity grows by 1 rad/s2, and work is all its energy."""
    model = solver.assemble(solver.loads(ARM.replace("TOLERANCE", "0")))
    names = "A.angular_velocity", "energy.work", "energy.kinetic", "energy.potential"
    with instance(native_fmu(model)) as fmu:
        fmu.initialise()
        for k in range(5):
            fmu.set(u=0.5 * ((k + 1) * 0.02) ** 2)
            assert fmu.step(k * 0.02, 0.02)
        faster, work, kinetic, potential = derivatives(fmu, *names)
    assert faster == pytest.approx(1.0, rel=1e-5)
    assert work == pytest.approx(kinetic + potential, rel=1e-5)
