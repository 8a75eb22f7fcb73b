"""FMUs of every kind tell sensors, accelerations and powers as `simulate` does, bit for bit."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from build_fmu import build
from build_fmu.run import run_fmu
from tests.fmu.test_kinds import KINDS

TURNTABLE = """
name = "turntable"
gravity = [0, 0, -9.81]
[bodies.table]
mass = 1.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 0]
angular_velocity = [0, 0, 3]
[bodies.load]
mass = 1.0
inertia = [0.1, 0.2, 0.3]
position = [1, 0.5, 2]
angular_velocity = [0.3, 1, 2]
[joints]
hinge = { type = "revolute", bodies = ["ground", "table"], position = [0, 0, 0], axis = [0, 0, 1] }
[forces]
drag = { type = "torsion_damper", joint = "hinge", damping = 0.01 }
[sensors]
imu = { type = "imu", body = "table", at = [0.2, 0, 0.1] }
gap = { type = "relative", bodies = ["table", "load"], axes = "table" }
[outputs]
lost = { value = "drag.power", unit = "W" }
[fmu]
outputs = ["imu.*", "gap.*", "lost", "load.az"]
"""


@pytest.mark.parametrize("kind", KINDS)
def test_an_fmu_tells_what_sensors_show(kind, tmp_path):
    file = tmp_path / "turntable.toml"
    file.write_text(TURNTABLE, encoding="utf-8")
    found = run_fmu(build(file, tmp_path / "a.fmu", **KINDS[kind]), stop_time=0.5).values
    expected = solver.simulate(file, stop_time=0.5)
    names = [name for name in expected if name.startswith(("imu.", "gap."))]
    assert len(names) == 6 + 14
    for name in (*names, "lost", "load.az"):
        assert np.array_equal(found[name], expected[name]), name
    first = [found[f"imu.{word}"][0] for word in ("fx", "fy", "fz", "wx", "wy", "wz")]
    assert first == pytest.approx([-1.8, -0.06, 9.81, 0, 0, 3], abs=1e-9)  # 0.2 m * 0.03/0.1 rad/s2
    assert found["load.az"] == pytest.approx(-9.81, abs=1e-12)
    assert found["lost"][0] == pytest.approx(-0.09, abs=1e-9)
