"""Bodies that fly freely, held together by one joint or coupling: the same bodies for each."""

from __future__ import annotations

_AT, _AXIS = 'bodies = ["A", "B"], position = [0.5, 0.1, 0.2]', "axis = [1, 2, 2]"
_TIP = 'point = "B.tip", body = "A"'
_FLAT = 'bodies = ["A", "B"], position = [0.5, 0.1]'
_TIPS = 'points = ["A.tip", "B.tip"]'

SPATIAL = {
    # name: (text of the joint, rows of the textbook)
    "spherical": (_AT, 3),
    "revolute": (f"{_AT}, {_AXIS}", 5),
    "universal": (f"{_AT}, axes = [[1, 2, 2], [2, 1, -2]]", 4),
    "cylindrical": (f"{_AT}, {_AXIS}", 4),
    "prismatic": (f"{_AT}, {_AXIS}", 5),
    "planar": (f"{_AT}, {_AXIS}", 3),
    "fixed": (_AT, 6),
    "screw": (f"{_AT}, {_AXIS}, pitch = 0.3", 5),
    "distance": (_TIPS, 1),
    "point_on_line": (f"{_TIP}, {_AXIS}", 2),
    "point_on_plane": (f"{_TIP}, {_AXIS}", 1),
    "point_on_surface": (f'{_TIP}, surface = "x**2 + 2*y**2 + 3*z**2 - 1"', 1),
    "angle": ('bodies = ["A", "B"], axes = [[1, 2, 2], [1, 0, 0.3]]', 1),
}
"""Joints in space: every one at a place and along an axis that no coordinate knows."""

PLANAR = {
    "revolute": (_FLAT, 2),
    "prismatic": (f"{_FLAT}, axis = [1, 2]", 2),
    "fixed": (_FLAT, 3),
    "distance": (_TIPS, 1),
    "point_on_line": (f"{_TIP}, axis = [1, 2]", 1),
    "point_on_surface": (f'{_TIP}, surface = "x**2 + 2*y**2 - 0.8802"', 1),
}
"""Joints in the plane."""

COUPLINGS = {
    # (dimension, name): (first joint, second joint, the coupling, rows of all three)
    (3, "gear"): ("revolute", "revolute", 'type = "gear"\nratio = -1.5', 11),
    (3, "gear on sleeves"): ("cylindrical", "cylindrical", 'type = "gear"\nratio = -1.5', 9),
    (3, "rack"): ("revolute", "prismatic", 'type = "rack"\nradius = 0.12', 11),
    (3, "rack on sleeves"): ("cylindrical", "cylindrical", 'type = "rack"\nradius = 0.12', 9),
    (2, "gear"): ("revolute", "revolute", 'type = "gear"\nratio = -1.5', 5),
    (2, "rack"): ("revolute", "prismatic", 'type = "rack"\nradius = 0.12', 5),
}
"""Couplings of two joints of a frame, in space of two skew axes that no coordinate knows."""

_BODIES = {
    3: """
[bodies.A]
position = {place_of_A}
mass = {mass_of_A}
inertia = [0.11, 0.13, 0.17]
orientation = {{ rotation_vector = [0.2, -0.3, 0.4] }}
velocity = [0.1, -0.2, 0.3]
angular_velocity = {spin_of_A}
points = {{ tip = [0.3, -0.1, 0.2] }}
[bodies.B]
position = [0.9, 0.3, -0.1]
center_of_mass = [0.02, 0.05, -0.03]
mass = 1.0
inertia = [[0.05, 0.01, 0.0], [0.01, 0.06, -0.005], [0.0, -0.005, 0.04]]
orientation = {{ quaternion = [0.9, 0.1, -0.3, 0.2] }}
points = {{ tip = [-0.2, 0.1, 0.05] }}
""",
    2: """
[bodies.A]
position = {place_of_A}
mass = {mass_of_A}
inertia = 0.13
orientation = 0.3
velocity = [0.1, -0.2]
angular_velocity = {spin_of_A}
points = {{ tip = [0.3, -0.1] }}
[bodies.B]
position = [0.9, 0.3]
center_of_mass = [0.02, 0.05]
mass = 1.0
inertia = 0.05
orientation = -0.4
points = {{ tip = [-0.2, 0.1] }}
""",
}
_FRAME = {
    3: """[bodies.frame]
position = [0.4, 0.2, 0.1]
mass = 3.0
inertia = [0.4, 0.5, 0.35]
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
""",
    2: """[bodies.frame]
position = [0.4, 0.2]
mass = 3.0
inertia = 0.4
[joints.first]
type = "{first}"
bodies = ["frame", "A"]
position = [0.2, 0.1]
[joints.second]
type = "{second}"
bodies = ["frame", "B"]
position = [0.7, 0.3]
{axis}
""",
}


def _scene(dimension: int, place: str, mass: float, spin: str, joints: str, h: float) -> str:
    bodies = _BODIES[dimension].format(place_of_A=place, mass_of_A=mass, spin_of_A=spin)
    settings = f"[solver]\nassemble = true\nstep_size = {h}\n"
    return f'name = "joined"\ndimension = {dimension}\n{joints}{bodies}{settings}'


def pair(dimension: int, kind: str, h: float) -> str:
    """Scene of two bodies on a joint, in steps of `h` [s]; `assemble` finds the velocity of B."""
    joint = (SPATIAL if dimension == 3 else PLANAR)[kind][0]
    spin = "[1.0, -0.5, 0.7]" if dimension == 3 else "1.7"
    joints = f'[joints]\njoint = {{ type = "{kind}", {joint} }}\n'
    return _scene(dimension, str([0] * dimension), 2.0, spin, joints, h)


def train(dimension: int, kind: str, h: float) -> str:
    """Scene of the three bodies, in steps of `h` [s]; `assemble` finds velocities but A's."""
    first, second, coupling, _ = COUPLINGS[dimension, kind]
    axis = "axis = [1, 2]" if second == "prismatic" else ""
    joints = _FRAME[dimension].format(first=first, second=second, axis=axis)
    joints += f'[joints.mesh]\njoints = ["first", "second"]\n{coupling}\n'
    spin = "[1.0, 0.6, 0.7]" if dimension == 3 else "1.7"
    return _scene(dimension, str([0.1, 0.1, 0.3][:dimension]), 1.2, spin, joints, h)


PAIRS = [(3, kind) for kind in SPATIAL] + [(2, kind) for kind in PLANAR]
"""Dimension and type of every joint."""
TRAINS = [*COUPLINGS]
"""Dimension and name of every coupling."""
