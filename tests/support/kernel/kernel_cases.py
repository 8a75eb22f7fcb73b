"""Mechanisms on which the kernel is tried."""

from __future__ import annotations

from tests.support.kernel.twins import EVERYTHING, model_of
from tests.support.mechanisms.joint_scenes import train
from tests.support.mechanisms.scene_files import SMOOTH
from tests.support.mechanisms.zoo import PLANE, SPACE

SOURCES = {path.stem: path for path in SMOOTH}
SOURCES |= {f"everything in {dim}-D": text for dim, text in EVERYTHING.items()}
SOURCES["gears and a cam in the plane"] = (
    train(2, "gear", 0.01)
    + """
[constraints]
cam = { value = "frame.y + 0.3*exp(first.angle) - 0.5" }
"""
)
ZOO = {"zoo in the plane": PLANE, "zoo in space": SPACE}
PROFILES = {
    "profiles in the plane": """
name = "profiles"
dimension = 2
gravity = [0, -9.81]
[profiles]
lobe = { x = [0, 1, 2, 3.5, 5, "2*pi"], y = [0.5, 0.6, 0.8, 0.7, 0.55, 0.5], periodic = true }
rubber = { x = [-1, -0.2, 0, 0.3, 1], y = [-90, -9, 0, 12, 120], integrate = true }
drag = { x = [-5, -1, 0, 1, 5], y = [-3, -1, 0, 1, 3] }
[points]
lifter = { position = [0, 0.5], mass = 0.4 }
A = { position = [1.3, 0.4], velocity = [0.5, 0], mass = 0.7 }
[bodies.cam]
position = [0, 0]
mass = 1.0
inertia = 0.1
angular_velocity = 9.0
[joints]
shaft = { type = "revolute", bodies = ["ground", "cam"], position = [0, 0] }
guide = { type = "point_on_line", point = "lifter", axis = [0, 1] }
[constraints]
rise = { value = "lifter.y - lobe(shaft.angle)" }
[forces]
tie = { type = "spring", points = ["lifter", "A"], energy = "rubber(length - 1.3)" }
wind = { type = "force", point = "A", value = ["-drag(A.vx)", "lobe(5*t)"] }
[outputs]
lift = { value = "lobe(shaft.angle)" }
[solver]
assemble = true
step_size = 0.01
"""
}
"""Rows, energies and loads of splines, whose third derivatives jump: not for orders above 2."""


def is_plain(source):
    """Whether a mechanism has no other rows than those of rods."""
    sizes = model_of(source).sizes
    return sizes["n_rows"] == sizes["n_form_rows"] and not sizes["n_bodies"]
