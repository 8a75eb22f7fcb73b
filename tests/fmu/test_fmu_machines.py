"""FMUs of every kind move actuators, dampers with a law and states as `simulate` does."""

from __future__ import annotations

import numpy as np
import pytest
from fmpy.fmi1 import FMICallException

import solver
from build_fmu import build
from build_fmu.run import run_fmu
from tests.fmu.test_kinds import KINDS
from tests.support.fmus.fmu_instance import instance, text_fmu

ARM = """
name = "arm"
dimension = 2
gravity = [0, -9.81]
[parameters]
gain = 8.0
torque = { value = 3.0, unit = "N.m", variability = "tunable" }
[inputs]
target = { start = 0.4, unit = "rad" }
[bodies]
rod = { mass = 1.0, inertia = 0.3, position = [1, 0] }
[joints]
hinge = { type = "revolute", bodies = ["ground", "rod"], position = [0, 0] }
[states]
turns = { update = "turns + 1", sample_time = 0.1, unit = "1" }
[states.pid]
type = "pid"
error = "target - hinge.angle"
kp = "gain"
ki = 2
kd = 1
sample_time = 0.02
[forces.motor]
type = "actuator"
joint = "hinge"
value = "pid.value"
ratio = 10
efficiency = 0.9
max_torque = "torque"
max_power = 60
[forces.brake]
type = "torsion_damper"
joint = "hinge"
torque = "0.2*rate + 0.1*rate*abs(rate)"
"""
SHOWN = [
    "hinge.angle", "hinge.angular_velocity", "motor.torque", "motor.motor_speed",
    "motor.limited", "brake.torque", "pid.value", "pid.integral", "turns", "energy.error",
]  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_an_fmu_moves_as_simulate_does(kind, tmp_path):
    file = tmp_path / "arm.toml"
    file.write_text(ARM, encoding="utf-8")
    given = {"gain": 12.0, "torque": 2.5}
    fmu = build(file, tmp_path / "a.fmu", **KINDS[kind])
    found = run_fmu(fmu, stop_time=1.0, settings=given).values
    scene = solver.load(file, {name: value for name, value in given.items()})
    expected = solver.simulate(scene, stop_time=1.0)
    for name in SHOWN:
        assert np.array_equal(found[name], expected[name]), name
    assert np.ptp(found["pid.value"]) > 1.0
    assert set(found["motor.limited"]) >= {0.0, 1.0}
    assert found["energy.error"].max() < 1e-13


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_a_largest_torque_that_is_negative_is_refused_in_an_fmu(native):
    with instance(text_fmu(ARM, native=native)) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.05)
        try:  # refused when it is set, or in the step that takes it
            fmu.set(torque=-1.0)
            assert not fmu.step(0.05, 0.05)
        except FMICallException:
            pass
        assert any("max_torque must be > 0 N.m, got -1" in str(line) for line in fmu.log)
