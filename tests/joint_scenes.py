"""Two bodies that fly freely, held together by one joint: the same pair for every joint."""

from __future__ import annotations

SPATIAL = {
    # name: (text of the joint, rows of the textbook)
    "spherical": ('bodies = ["A", "B"], position = [0.5, 0.1, 0.2]', 3),
    "revolute": ('bodies = ["A", "B"], position = [0.5, 0.1, 0.2], axis = [1, 2, 2]', 5),
    "universal": (
        'bodies = ["A", "B"], position = [0.5, 0.1, 0.2], axes = [[1, 2, 2], [2, 1, -2]]',
        4,
    ),
    "cylindrical": ('bodies = ["A", "B"], position = [0.5, 0.1, 0.2], axis = [1, 2, 2]', 4),
    "prismatic": ('bodies = ["A", "B"], position = [0.5, 0.1, 0.2], axis = [1, 2, 2]', 5),
    "planar": ('bodies = ["A", "B"], position = [0.5, 0.1, 0.2], axis = [1, 2, 2]', 3),
    "fixed": ('bodies = ["A", "B"], position = [0.5, 0.1, 0.2]', 6),
    "screw": (
        'bodies = ["A", "B"], position = [0.5, 0.1, 0.2], axis = [1, 2, 2], pitch = 0.3',
        5,
    ),
    "distance": ('points = ["A.tip", "B.tip"]', 1),
    "point_on_line": ('point = "B.tip", body = "A", axis = [1, 2, 2]', 2),
    "point_on_plane": ('point = "B.tip", body = "A", axis = [1, 2, 2]', 1),
    "point_on_surface": (
        'point = "B.tip", body = "A", surface = "x**2 + 2*y**2 + 3*z**2 - 1"',
        1,
    ),
    "angle": ('bodies = ["A", "B"], axes = [[1, 2, 2], [1, 0, 0.3]]', 1),
}
"""Joints in space: every one at a place and along an axis that no coordinate knows."""

PLANAR = {
    "revolute": ('bodies = ["A", "B"], position = [0.5, 0.1]', 2),
    "prismatic": ('bodies = ["A", "B"], position = [0.5, 0.1], axis = [1, 2]', 2),
    "fixed": ('bodies = ["A", "B"], position = [0.5, 0.1]', 3),
    "distance": ('points = ["A.tip", "B.tip"]', 1),
    "point_on_line": ('point = "B.tip", body = "A", axis = [1, 2]', 1),
    "point_on_surface": ('point = "B.tip", body = "A", surface = "x**2 + 2*y**2 - 0.8802"', 1),
}
"""Joints in the plane."""

_SPATIAL = """
name = "pair"
[bodies.A]
position = [0, 0, 0]
mass = 2.0
inertia = [0.11, 0.13, 0.17]
orientation = {{ rotation_vector = [0.2, -0.3, 0.4] }}
velocity = [0.1, -0.2, 0.3]
angular_velocity = [1.0, -0.5, 0.7]
points = {{ tip = [0.3, -0.1, 0.2] }}
[bodies.B]
position = [0.9, 0.3, -0.1]
center_of_mass = [0.02, 0.05, -0.03]
mass = 1.0
inertia = [[0.05, 0.01, 0.0], [0.01, 0.06, -0.005], [0.0, -0.005, 0.04]]
orientation = {{ quaternion = [0.9, 0.1, -0.3, 0.2] }}
points = {{ tip = [-0.2, 0.1, 0.05] }}
[joints]
joint = {{ type = "{kind}", {joint} }}
[solver]
assemble = true
step_size = {h}
"""

_PLANAR = """
name = "pair"
dimension = 2
[bodies.A]
position = [0, 0]
mass = 2.0
inertia = 0.13
orientation = 0.3
velocity = [0.1, -0.2]
angular_velocity = 1.7
points = {{ tip = [0.3, -0.1] }}
[bodies.B]
position = [0.9, 0.3]
center_of_mass = [0.02, 0.05]
mass = 1.0
inertia = 0.05
orientation = -0.4
points = {{ tip = [-0.2, 0.1] }}
[joints]
joint = {{ type = "{kind}", {joint} }}
[solver]
assemble = true
step_size = {h}
"""


def pair(dimension: int, kind: str, h: float) -> str:
    """Scene of the pair, advanced in steps of `h` [s]; `assemble` finds the velocity of B."""
    joints, text = (SPATIAL, _SPATIAL) if dimension == 3 else (PLANAR, _PLANAR)
    return text.format(kind=kind, joint=joints[kind][0], h=h)


PAIRS = [(3, kind) for kind in SPATIAL] + [(2, kind) for kind in PLANAR]
"""Dimension and type of every joint."""
