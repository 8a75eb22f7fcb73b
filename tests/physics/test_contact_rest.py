"""What is parked rests as long as some forces inside Coulomb's cones hold it.

Whether there are such forces a linear program tells, too: in the plane a cone is two inequalities.
"""

from __future__ import annotations

import functools
import itertools
import math

import numpy as np
import pytest
from scipy.optimize import linprog

import solver
from tests.support.kernel.twins import start

G = 9.81
PLANE = 'name = "rest"\ndimension = 2\n'


def run(text: str, stop: float = 1.0, **settings: solver.Setting) -> solver.Trajectory:
    return solver.simulate(solver.loads(text), stop_time=stop, step_size=0.05, **settings)


def way(found: solver.Trajectory, *names: str) -> float:
    """Largest change of variables over the run."""
    return max(float(np.ptp(found[name])) for name in names)


def feet(static: float, kinetic: float) -> str:
    return f"friction = {kinetic!r}, static_friction = {static!r}"


def slope(demand: float, height: float, static: float, kinetic: float) -> str:
    """Block of 1 kg on two feet under a load along the floor."""
    return f"""{PLANE}gravity = [{demand * G!r}, {-G!r}]
[bodies.b]
position = [0, {height!r}]
mass = 1
inertia = 0.02
points = {{ l = [-0.2, {-height!r}], r = [0.2, {-height!r}] }}
[contacts]
l = {{ type = "plane", point = "b.l", axis = [0, 1], {feet(static, kinetic)} }}
r = {{ type = "plane", point = "b.r", axis = [0, 1], {feet(static, kinetic)} }}
"""


def box(demand: float, direction: tuple[float, float], static: float, kinetic: float) -> str:
    """Box on four corners."""
    x, y = (demand * G * d for d in direction)
    return f"""name = "rest"
gravity = [{x!r}, {y!r}, {-G!r}]
[bodies]
b = {{ position = [0, 0, 0.1], shape = {{ type = "box", size = [0.4, 0.3, 0.2], density = 1000 }} }}
[contacts.f]
type = "corners"
body = "b"
size = [0.4, 0.3, 0.2]
axis = [0, 0, 1]
friction = {kinetic!r}
static_friction = {static!r}
"""


def table(static: float) -> str:
    """Four legs, a load of 100 N at (0.2, 0.1), a push of (30, 20) N at the top, 0.7 m high."""
    legs = [(-0.5, -0.4), (-0.5, 0.4), (0.5, -0.4), (0.5, 0.4)]
    points = ", ".join(f"l{i} = [{x - 0.2!r}, {y - 0.1!r}, -0.7]" for i, (x, y) in enumerate(legs))
    law = f"axis = [0, 0, 1], friction = {static!r}"
    contacts = "\n".join(
        f'l{i} = {{ type = "plane", point = "b.l{i}", {law} }}' for i in range(len(legs))
    )
    return f"""name = "table"
gravity = [0, 0, -10]
[bodies.b]
position = [0.2, 0.1, 0.7]
mass = 10
inertia = [1, 1, 1]
points = {{ {points}, top = [-0.2, -0.1, 0] }}
[forces]
f = {{ type = "force", point = "b.top", value = [30, 20, 0] }}
[contacts]
{contacts}
"""


def ladder(static: float, angle: float) -> str:
    """Ladder of 2 m between a rough floor and a rough wall."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    law = f"friction = {static!r}"
    return f"""{PLANE}gravity = [0, {-G!r}]
[bodies.b]
position = [0, {s!r}]
mass = 1
inertia = 0.3
points = {{ l = [{-c!r}, {-s!r}], r = [{c!r}, {s!r}] }}
[contacts]
l = {{ type = "plane", point = "b.l", axis = [0, 1], {law} }}
r = {{ type = "plane", point = "b.r", axis = [-1, 0], position = [{c!r}, 0], {law} }}
"""


def stack(static: float, level: int) -> str:
    """Three boxes of 1 kg on each other, each on two corners; 2 N push one of them."""
    text = f"{PLANE}gravity = [0, {-G!r}]\n[bodies]\n"
    for k in range(3):
        text += (
            f"b{k} = {{ position = [0, {0.1 + 0.2 * k!r}], mass = 1, inertia = 0.02, "
            "points = { l = [-0.2, -0.1], r = [0.2, -0.1] } }\n"
        )
    text += f'[forces]\nf = {{ type = "force", point = "b{level}", value = [2, 0] }}\n[contacts]\n'
    for k in range(3):
        for foot in "lr":
            below = "" if k == 0 else f', body = "b{k - 1}"'
            text += (
                f'c{k}{foot} = {{ type = "plane", point = "b{k}.{foot}", axis = [0, 1], '
                f"position = [0, {0.2 * k!r}], friction = {static!r}{below} }}\n"
            )
    return text


@pytest.mark.parametrize("kinetic", [0.1, 0.6])
@pytest.mark.parametrize("height", [0.0, 0.05, 0.1, 0.2, 0.3])
def test_static_friction_alone_says_when_a_block_on_two_feet_slides(height, kinetic):
    held = run(slope(0.6 * (1 - 1e-6), height, 0.6, kinetic))
    assert way(held, "b.x", "b.y", "b.angle") < 1e-12
    assert (held["l.mode"] == 1).all()
    assert (held["r.mode"] == 1).all()
    assert held["solver.events"].sum() == 0
    demand = 0.6 * (1 + 1e-6)
    slid = run(slope(demand, height, 0.6, kinetic))
    assert way(slid, "b.x") == pytest.approx(0.5 * G * (demand - kinetic), rel=1e-6)
    assert (slid["l.mode"][1:] == 2).all()


@pytest.mark.parametrize("kinetic", [0.3, 0.561])
@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.8, 0.6)])
def test_static_friction_alone_says_when_a_box_on_four_corners_slides(direction, kinetic):
    held = run(box(0.561 * (1 - 1e-6), direction, 0.561, kinetic))
    assert way(held, "b.x", "b.y", "b.z") < 1e-12
    assert held["solver.events"].sum() == 0
    demand = 0.561 * (1 + 1e-6)
    slid = run(box(demand, direction, 0.561, kinetic))
    expected = 0.5 * G * (demand - kinetic)
    assert np.hypot(way(slid, "b.x"), way(slid, "b.y")) == pytest.approx(expected, rel=1e-5)
    assert slid["solver.stepped"].sum() == 0


def test_forces_at_rest_are_the_least_ones_inside_the_cones():
    # The front foot carries more. Without cones each would hold 2.45 N, more than 0.6 of 3.68 N.
    found = run(slope(4.9 / G, 0.1, 0.6, 0.1))
    assert found["l.force"][1:] == pytest.approx(3.68, rel=1e-6)
    assert found["l.friction"][1:] == pytest.approx(-0.6 * 3.68, rel=1e-6)
    assert found["r.force"][1:] == pytest.approx(6.13, rel=1e-6)
    assert found["r.friction"][1:] == pytest.approx(0.6 * 3.68 - 4.9, rel=1e-6)
    assert not found["l.slip"].any()


@pytest.mark.parametrize(
    ("build", "threshold"),
    [
        (table, 0.361533),
        (functools.partial(ladder, angle=60), math.tan(math.radians(15))),
        (functools.partial(ladder, angle=70), math.tan(math.radians(10))),
        (functools.partial(stack, level=0), 2 / G / 3),
        (functools.partial(stack, level=1), 2 / G / 2),
        (functools.partial(stack, level=2), 2 / G),
    ],
    ids=["table", "ladder at 60", "ladder at 70", "stack 0", "stack 1", "stack 2"],
)
def test_a_parked_mechanism_needs_the_least_coefficient_that_holds_it(build, threshold):
    held, slid = (run(build(threshold + change), stop=0.2) for change in (2e-6, -2e-6))
    places = [name for name in held.names if name.endswith((".x", ".y", ".z")) and name[0] in "bw"]
    assert way(held, *places) < 1e-12
    assert held["solver.events"].sum() == 0
    assert way(slid, *places) > 1e-9


# Boxes that lie on each other: (size, mass) from below. They are as wide as long, or not.
LIKE = [((0.4, 0.3, 0.2), 1.0)] * 3
UNLIKE = [((0.4, 0.3, 0.2), 1.35), ((0.31, 0.17, 0.11), 0.53), ((0.2, 0.15, 0.07), 0.81)]


def boxes(n: int, dimension: int, friction: float, pile: list, level: int, angle: float) -> str:
    """Boxes of a pile, each on its corners; 2 N push one of them, in space at this angle."""
    last = dimension - 1
    signs = itertools.product(*[(-0.5, 0.5)] * last)
    feet = {f"p{i}": [*sign, -0.5] for i, sign in enumerate(signs)}
    bodies, contacts, height = "", "", 0.0
    for k, (size, mass) in enumerate(pile[:n]):
        x, y, z = size
        sides = size if dimension == 3 else (x, z)
        turns = [(y * y + z * z), (x * x + z * z), (x * x + y * y)]
        inertia = [mass * turn / 12 for turn in turns] if dimension == 3 else mass * turns[1] / 12
        points = ", ".join(
            f"{name} = {[a * b for a, b in zip(foot, sides, strict=True)]}"
            for name, foot in feet.items()
        )
        bodies += (
            f"b{k} = {{ position = {[0.0] * last + [height + z / 2]}, mass = {mass!r}, "
            f"inertia = {inertia}, points = {{ {points} }} }}\n"
        )
        below = f', body = "b{k - 1}"' if k else ""
        for name in feet:
            contacts += (
                f'c{k}{name} = {{ type = "plane", point = "b{k}.{name}", '
                f"axis = {[0] * last + [1]}, position = {[0.0] * last + [height]}, "
                f"friction = {friction!r}{below} }}\n"
            )
        height += z
    push = [2 * math.cos(angle), 2 * math.sin(angle), 0.0] if dimension == 3 else [2.0, 0.0]
    return f"""name = "pile"
dimension = {dimension}
gravity = {[0.0] * last + [-G]}
[bodies]
{bodies}
[forces]
f = {{ type = "force", point = "b{level}", value = {push} }}
[contacts]
{contacts}
"""


PILES = [
    (n, dimension, pile, level, angle)
    for n, dimension, pile, angle in [
        (2, 2, LIKE, 0.0),
        (3, 2, UNLIKE, 0.0),
        (2, 3, LIKE, 0.0),
        (2, 3, UNLIKE, 0.7),
        (2, 3, UNLIKE, 3.9),
    ]
    for level in range(n)
]


@pytest.mark.parametrize(("n", "dimension", "pile", "level", "angle"), PILES)
def test_boxes_on_each_other_rest_above_one_coefficient_and_slide_below(
    n, dimension, pile, level, angle
):
    # Contact `level` carries the least of those that pass the push on; the boxes above ride along
    # without friction beyond the cone as long as the acceleration g (threshold - friction) allows.
    carried = sum(mass for _, mass in pile[level:n])
    threshold = 2 / G / carried
    build = functools.partial(boxes, n, dimension, pile=pile, level=level, angle=angle)
    places = [f"b{k}.{axis}" for k in range(n) for axis in "xyz"[:dimension]]
    for friction in (threshold * (1 + 1e-6), threshold + 1e-4, 0.45, 0.6, 0.9):
        held = run(build(friction=friction), stop=0.1)
        assert way(held, *places) < 1e-12
        assert held["solver.events"].sum() == 0
        assert held["solver.stepped"].sum() == 0
    for friction in (threshold * (1 - 1e-6), threshold - 1e-4, 0.6 * threshold):
        slid = run(build(friction=friction), stop=0.1)
        assert slid["solver.stepped"].sum() == 0
        assert slid["solver.events"].sum() == 0
        for k in range(n):
            along = slid[f"b{k}.x"] * math.cos(angle)
            if dimension == 3:
                along = along + slid[f"b{k}.y"] * math.sin(angle)
            moved = 0.5 * G * (threshold - friction) * slid.t**2 if k >= level else 0.0 * slid.t
            assert along == pytest.approx(moved, abs=1e-11)


# Shapes of two boxes, below and above, their masses, and the angle of the push.
TIES = [
    ((0.4, 0.3, 0.2), (0.2, 0.15, 0.07), 1.0, 1.0, 0.0),
    ((0.4, 0.3, 0.2), (0.31, 0.17, 0.11), 1.35, 0.53, 0.7),
    ((0.4, 0.3, 0.2), (0.31, 0.17, 0.18), 0.7, 1.9, 3.9),
    ((0.4, 0.3, 0.2), (0.25, 0.1, 0.15), 1.8, 1.4, 0.0),
]


@pytest.mark.parametrize("share", [0.5, 0.505, 0.51, 0.515, 0.52, 0.55])
@pytest.mark.parametrize(("below", "above", "m0", "m1", "angle"), TIES)
def test_a_box_rides_on_one_that_slides_as_long_as_its_friction_suffices(
    below, above, m0, m1, angle, share
):
    # g (threshold - friction) is the acceleration: less than friction g above 0.5, equal at 0.5.
    threshold = 2 / G / (m0 + m1)
    pile = [(below, m0), (above, m1)]
    found = run(boxes(2, 3, share * threshold, pile, 0, angle), stop=0.2)
    moved = 0.5 * G * threshold * (1 - share) * found.t**2
    for name in ("b0", "b1"):
        along = found[f"{name}.x"] * math.cos(angle) + found[f"{name}.y"] * math.sin(angle)
        assert along == pytest.approx(moved, abs=1e-12)
    assert found["solver.stepped"].sum() == 0
    assert found["solver.events"].sum() == 0
    assert (found["c1p0.mode"] == 1).all()


TAN_15 = math.tan(math.radians(15))


@pytest.mark.parametrize(
    "friction",
    [
        0.1,
        TAN_15 - 1e-6,
        TAN_15 + 1e-7,
        TAN_15 + 1e-6,
        TAN_15 + 1e-5,
        TAN_15 + 1e-4,
        TAN_15 + 1e-3,
        0.27,
        0.6,
        0.9,
    ],
)
def test_a_wedge_of_15_degrees_locks_itself_above_tan_15(friction):
    # Pulled out with 3 N: 3 = 2 N (friction cos - sin) of the least forces that hold it.
    c, s = math.cos(math.radians(15)), math.sin(math.radians(15))
    found = run(f"""{PLANE}gravity = [0, 0]
[bodies.b]
position = [0, 0]
mass = 1
inertia = 0.05
points = {{ l = [-0.1, 0], r = [0.1, 0] }}
[forces]
f = {{ type = "force", point = "b", value = [0, 3] }}
[contacts.l]
type = "plane"
point = "b.l"
axis = [{c!r}, {s!r}]
position = [-0.1, 0]
friction = {friction!r}
[contacts.r]
type = "plane"
point = "b.r"
axis = [{-c!r}, {s!r}]
position = [0.1, 0]
friction = {friction!r}
""", stop=0.2)  # fmt: skip
    assert found["solver.events"].sum() == 0
    assert found["solver.stepped"].sum() == 0
    if friction < TAN_15:
        assert found["b.y"][-1] == pytest.approx(0.5 * 3 * 0.2**2, rel=1e-12)
        return
    assert way(found, "b.x", "b.y", "b.angle") < 1e-12
    for name in "lr":
        assert (found[f"{name}.mode"] == 1).all()
        # Splits may be 1e-7 of the coefficient inside their cones.
        inside = 1.1e-7 * friction * c / (friction * c - s)
        larger = inside / (1.0 - inside)
        assert found[f"{name}.force"][1:] == pytest.approx(3 / 2 / (friction * c - s), rel=larger)


@pytest.mark.parametrize("load", [-4.2, -3.9, -1.0, -0.1, 0.5, 1.0])
def test_a_block_on_a_belt_and_a_floor_slides_on_the_belt_and_sticks_to_the_floor(load):
    # The belt pulls with 0.4 of half the weight, the floor holds up to that.
    text = slope(load / G, 0.0, 0.4, 0.4)
    found = run(text.replace('point = "b.l"', 'point = "b.l", surface_velocity = [1, 0]'), stop=0.2)
    pull = 0.4 * G / 2
    floor = max(-pull, min(pull, -load - pull))
    acceleration = load + pull + floor
    assert (found["l.mode"] == 2).all()
    assert (found["r.mode"] == (1 if acceleration == 0.0 else 2)).all()
    assert found["b.x"] - found["b.x"][0] == pytest.approx(
        0.5 * acceleration * found.t**2, abs=1e-12
    )
    assert found["solver.events"].sum() == 0
    assert found["l.friction"][1:] == pytest.approx(pull, rel=1e-9)
    assert found["r.friction"][1:] == pytest.approx(floor, rel=1e-9)


def holds(contacts: list[tuple[np.ndarray, np.ndarray]], load: np.ndarray, friction: float) -> bool:
    """Whether forces inside the cones of planar contacts (place, normal) hold a body (LP)."""
    columns = []
    for place, normal in contacts:
        along = np.array([normal[1], -normal[0]])
        for edge in (normal + friction * along, normal - friction * along):
            columns.append([*edge, place[0] * edge[1] - place[1] * edge[0]])
    matrix = np.array(columns).T
    return linprog(np.zeros(matrix.shape[1]), A_eq=matrix, b_eq=-load, method="highs").status == 0


@pytest.mark.parametrize("seed", range(12))
def test_random_bodies_on_random_feet_rest_where_a_linear_program_finds_forces(seed):
    random = np.random.default_rng(seed)
    n = int(random.integers(2, 5))
    angles = random.uniform(-0.6, 0.6, n)
    places = np.stack(
        [np.sort(random.uniform(-0.5, 0.5, n)), -random.uniform(0.05, 0.4, n)], axis=1
    )
    normals = np.stack([np.sin(angles), np.cos(angles)], axis=1)
    push, turn = random.uniform((-6.0, -0.5), (6.0, 0.5)).tolist()
    friction = float(random.uniform(0.1, 0.9))
    points = ", ".join(f"p{i} = [{x!r}, {y!r}]" for i, (x, y) in enumerate(places.tolist()))
    contacts = "\n".join(
        f'p{i} = {{ type = "plane", point = "b.p{i}", axis = [{a!r}, {b!r}], '
        f"position = {places[i].tolist()}, friction = {friction!r} }}"
        for i, (a, b) in enumerate(normals.tolist())
    )
    found = run(f"""{PLANE}gravity = [{push!r}, {-G!r}]
[bodies]
b = {{ position = [0, 0], mass = 1, inertia = 0.05, points = {{ {points} }} }}
[forces]
turn = {{ type = "torque", body = "b", value = {turn!r} }}
[contacts]
{contacts}
""", stop=0.05)  # fmt: skip
    rests = way(found, "b.x", "b.y", "b.angle") < 1e-12
    load = np.array([push, -G, turn])
    assert rests == holds(list(zip(places, normals, strict=True)), load, friction)


@pytest.mark.parametrize("kinetic", [0.1, 0.5, 0.6])
def test_a_load_that_grows_slides_a_box_when_static_friction_is_reached(kinetic):
    push = 'push = { type = "force", point = "b", value = ["24*9.81*0.8*t", 0, 0] }'
    text = box(0.0, (1.0, 0.0), 0.6, kinetic)
    text = text.replace("[contacts.f]", f"[forces]\n{push}\n[contacts.f]")
    found = run(text, stop=1.0)
    start = 0.75  # where 0.8 t is 0.6
    moving = np.maximum(found.t - start, 0.0)
    expected = 0.5 * G * (0.6 - kinetic) * moving**2 + 0.8 * G * moving**3 / 6
    assert found["b.x"] == pytest.approx(expected, abs=1e-6)  # the default tolerance
    assert found["solver.events"].sum() <= 4
    assert found["solver.stepped"].sum() == 0


def test_belts_that_part_pull_a_block_to_both_sides():
    # Both feet slide for ever: the block follows the load alone, as frictions cancel.
    text = slope(0.5 / G, 0.0, 0.5, 0.4)
    text = text.replace('point = "b.l"', 'point = "b.l", surface_velocity = [1, 0]')
    text = text.replace('point = "b.r"', 'point = "b.r", surface_velocity = [-1, 0]')
    found = run(text, stop=0.5)
    assert (found["l.mode"] == 2).all()
    assert (found["r.mode"] == 2).all()
    assert abs(found["l.friction"][1:]) == pytest.approx(0.4 * G / 2, rel=1e-9)
    assert found["b.x"][-1] - found["b.x"][0] == pytest.approx(0.5 * 0.5 * 0.5**2, rel=1e-9)


def test_the_functions_at_a_communication_point_are_those_of_the_step_before():
    """Those in the state are m g/4 of each foot, and the gap of a ball that has fallen for 0.1 s.

    A step that finds them anew does the same.
    """
    scene = solver.loads("""
name = "parked"
gravity = [0, 0, -9.81]
[bodies.box]
position = [0, 0, 0.1]
mass = 4
inertia = [1, 1, 1]
[points]
ball = { position = [5, 0, 0.1], mass = 1.0 } # so near that its contact is awake
[contacts]
feet = { type = "corners", body = "box", size = [0.4, 0.4, 0.2], axis = [0, 0, 1] }
floor = { type = "plane", point = "ball", axis = [0, 0, 1] }
""")
    run = start(solver.assemble(scene), step_size=0.01)
    for k in range(10):
        run.advance(0.01 * k, 0.01)
    values, _ = np.split(np.array(run.state.vectors["functions"]), 2)
    closed = np.sort(values)[-4:]
    assert run.state.head["functions_known"] == 1.0
    assert closed == pytest.approx(4 * [G], rel=1e-9)
    gap = 0.1 - 0.5 * G * 0.1**2
    assert values[np.argmin(abs(values - gap))] == pytest.approx(gap, rel=1e-12)
    kept, ends = run.save(), []
    for known in (1.0, 0.0):
        run.restore(kept)
        run.state.head["functions_known"] = known
        run.advance(0.1, 0.01)
        ends.append([float(run[name]) for name in ("ball.z", "box.z", "ball.vz")])
    assert ends[0] == ends[1]
