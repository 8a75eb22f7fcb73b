"""Mechanisms with numbers far from one: texts of scenes that tests and benchmarks run alike."""

from __future__ import annotations

import math

GRAVITY = 9.81


def linked_bodies(*, ratio: float = 1.0, length: float = 1.0, rate: float = 0.0) -> str:
    """Two boxes in space, the second hung on the first: a revolute and a spherical joint.

    `ratio` is the second's mass [kg] over the first's, `length` that of either [m], `rate` the
    first's angular velocity [rad/s].
    """
    half, side, pivot = 0.5 * length, 0.2 * length, "position = [0, 0, 0], axis = [0, 1, 0]"
    return f"""
name = "linked"
gravity = [0, 0, {-GRAVITY}]
[bodies.first]
position = [{half}, 0, 0]
mass = 1.0
shape = {{ type = "box", size = [{length}, {side}, {0.5 * side}] }}
angular_velocity = [0, {rate}, 0]
velocity = [0, 0, {-rate * half}]
[bodies.second]
position = [{length}, {half}, 0]
mass = {ratio!r}
shape = {{ type = "box", size = [{side}, {length}, {0.5 * side}] }}
velocity = [0, 0, {-rate * length}]
[joints]
hinge = {{ type = "revolute", bodies = ["ground", "first"], {pivot} }}
ball = {{ type = "spherical", bodies = ["first", "second"], position = [{length}, 0, 0] }}
"""


def four_bar(
    *, angle: float = 1.0, ratio: float = 1.0, length: float = 1.0, dimension: int = 2,
    copies: int = 1, rate: float = 2.0,
) -> str:  # fmt: skip
    """Parallelogram of uniform bars as rigid bodies; its cranks turn at `rate` [rad/s].

    `angle` [rad] is that of the cranks from the line of their pivots, where all bars lie in one
    line; `ratio` the coupler's mass over a crank's; `copies` of each hinge make the rows of a loop
    redundant, as does space (dimension 3).
    """
    c, s = length * math.cos(angle), length * math.sin(angle)
    rest = ", 0" * (dimension - 2)
    spin = f"{rate!r}" if dimension == 2 else f"[0, 0, {rate!r}]"
    text = f'name = "parallel"\ndimension = {dimension}\ngravity = [0, {-GRAVITY}{rest}]\n'
    for name, x in (("left", 0.0), ("right", length)):
        text += f"""[bodies.{name}]
position = [{x + 0.5 * c!r}, {0.5 * s!r}{rest}]
velocity = [{-0.5 * rate * s!r}, {0.5 * rate * c!r}{rest}]
angular_velocity = {spin}
mass = 1.0
{_bar(dimension, length, 1.0, angle)}
"""
    text += f"""[bodies.coupler]
position = [{0.5 * length + c!r}, {s!r}{rest}]
velocity = [{-rate * s!r}, {rate * c!r}{rest}]
mass = {ratio!r}
{_bar(dimension, length, ratio, 0.0)}
[joints]
"""
    hinges = {
        "A": ("ground", "left", 0.0, 0.0),
        "B": ("left", "coupler", c, s),
        "C": ("right", "coupler", length + c, s),
        "D": ("ground", "right", length, 0.0),
    }
    axis = ", axis = [0, 0, 1]" if dimension == 3 else ""
    for name, (first, second, x, y) in hinges.items():
        for copy in range(copies):
            text += (
                f'{name}{copy} = {{ type = "revolute", bodies = ["{first}", "{second}"], '
                f"position = [{x!r}, {y!r}{rest}]{axis} }}\n"
            )
    return text


def _bar(dimension: int, length: float, mass: float, tilt: float) -> str:
    """Inertia and orientation of a uniform bar."""
    across = mass * length**2 / 12.0
    if dimension == 2:
        return f"inertia = {across!r}\norientation = {tilt!r}"
    return (
        f"inertia = [{0.05 * across!r}, {across!r}, {across!r}]\n"
        f"orientation = {{ rotation_vector = [0, 0, {tilt!r}] }}"
    )


def nearly_parallel(apart: float, across: float = 0.0) -> str:
    """A point on two rods whose other ends are `apart` [m]: a triangle that folds as it vanishes.

    In space it swings about the line through both ends; its rows are the closer to dependent the
    smaller that is. `across` [m/s2] pulls along that line.
    """
    return f"""
name = "nearly"
gravity = [0, {across!r}, {-GRAVITY}]
[points]
O = {{ position = [0, 0, 0], fixed = true }}
E = {{ position = [0, {apart!r}, 0], fixed = true }}
A = {{ position = [1, 0, 0], mass = 1.0 }}
[joints]
one = {{ type = "distance", points = ["O", "A"] }}
two = {{ type = "distance", points = ["E", "A"] }}
"""


def stiff_chain(soft: float, stiff: float) -> str:
    """Three unit masses on springs [N/m] of very different stiffness, a rod at their end."""
    ground = 'points = ["ground", "A"], at = [0, 0], free_length = 1'
    return f"""
name = "springs"
dimension = 2
gravity = [0, {-GRAVITY}]
[points]
A = {{ position = [1, 0], mass = 1.0 }}
B = {{ position = [2, 0], mass = 1.0 }}
C = {{ position = [3, 0], mass = 1.0 }}
[forces]
first = {{ type = "spring", {ground}, stiffness = {stiff!r} }}
second = {{ type = "spring", points = ["A", "B"], stiffness = {soft!r}, free_length = 0.5 }}
[joints]
rod = {{ type = "distance", points = ["B", "C"] }}
"""


def spinning(rate: float, *, inertia: str = "[1, 2, 3]", pinned: bool = False) -> str:
    """A body that turns at `rate` [rad/s] about all axes; free, or pinned beside its centre."""
    pin = (
        '[joints]\npin = { type = "spherical", bodies = ["ground", "rotor"], '
        "position = [0.1, 0, 0] }\n"
        if pinned
        else ""
    )
    part = rate / math.sqrt(3.0)
    velocity = f"velocity = [0, {-0.1 * part!r}, {0.1 * part!r}]" if pinned else ""
    return f"""
name = "rotor"
gravity = [0, 0, {-GRAVITY if pinned else 0.0}]
[bodies.rotor]
position = [0, 0, 0]
mass = 1.0
inertia = {inertia}
angular_velocity = [{part!r}, {part!r}, {part!r}]
{velocity}
{pin}
"""
