"""Three bodies that fly freely, two of them on joints of the first that a gear or rack couples."""

from __future__ import annotations

SPATIAL = {
    # name: (first joint, second joint, type of the coupling, its field, rows of all three)
    "gear": ("revolute", "revolute", "gear", "ratio = -1.5", 11),
    "gear on sleeves": ("cylindrical", "cylindrical", "gear", "ratio = -1.5", 9),
    "rack": ("revolute", "prismatic", "rack", "radius = 0.12", 11),
    "rack on sleeves": ("cylindrical", "cylindrical", "rack", "radius = 0.12", 9),
}
"""Couplings in space: two skew axes, places and axes that no coordinate knows."""

PLANAR = {
    "gear": ("revolute", "revolute", "gear", "ratio = -1.5", 5),
    "rack": ("revolute", "prismatic", "rack", "radius = 0.12", 5),
}
"""Couplings in the plane."""

_SPATIAL = """
name = "train"
[bodies.frame]
position = [0.4, 0.2, 0.1]
mass = 3.0
inertia = [0.4, 0.5, 0.35]
[bodies.A]
position = [0.1, 0.1, 0.3]
mass = 1.2
inertia = [0.11, 0.13, 0.17]
orientation = {{ rotation_vector = [0.2, -0.3, 0.4] }}
velocity = [0.1, -0.2, 0.3]
angular_velocity = [1.0, 0.6, 0.7]
[bodies.B]
position = [0.9, 0.3, -0.1]
center_of_mass = [0.02, 0.05, -0.03]
mass = 1.0
inertia = [[0.05, 0.01, 0.0], [0.01, 0.06, -0.005], [0.0, -0.005, 0.04]]
orientation = {{ quaternion = [0.9, 0.1, -0.3, 0.2] }}
[joints.first]
type = "{first}"
bodies = ["frame", "A"]
position = [0.2, 0.1, 0.2]
axis = [1, 2, 2]
[joints.second]
type = "{second}"
bodies = ["frame", "B"]
position = [0.7, 0.3, 0.0]
axis = [2, -1, 2]
[joints.mesh]
type = "{coupling}"
joints = ["first", "second"]
{field}
[solver]
assemble = true
step_size = {h}
"""

_PLANAR = """
name = "train"
dimension = 2
[bodies.frame]
position = [0.4, 0.2]
mass = 3.0
inertia = 0.4
[bodies.A]
position = [0.1, 0.1]
mass = 1.2
inertia = 0.13
orientation = 0.3
velocity = [0.1, -0.2]
angular_velocity = 1.7
[bodies.B]
position = [0.9, 0.3]
center_of_mass = [0.02, 0.05]
mass = 1.0
inertia = 0.05
orientation = -0.4
[joints.first]
type = "{first}"
bodies = ["frame", "A"]
position = [0.2, 0.1]
[joints.second]
type = "{second}"
bodies = ["frame", "B"]
position = [0.7, 0.3]
{axis}
[joints.mesh]
type = "{coupling}"
joints = ["first", "second"]
{field}
[solver]
assemble = true
step_size = {h}
"""


def train(dimension: int, kind: str, h: float) -> str:
    """Scene of the three bodies, in steps of `h` [s]; `assemble` finds velocities but A's."""
    first, second, coupling, field, _ = (SPATIAL if dimension == 3 else PLANAR)[kind]
    axis = "axis = [1, 2]" if second == "prismatic" else ""
    text = _SPATIAL if dimension == 3 else _PLANAR
    return text.format(
        first=first, second=second, coupling=coupling, field=field, axis=axis, h=h
    )  # fmt: skip


TRAINS = [(3, kind) for kind in SPATIAL] + [(2, kind) for kind in PLANAR]
"""Dimension and name of every coupling."""
