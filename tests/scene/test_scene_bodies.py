"""Rigid bodies of a scene: shapes weigh what formulas say, attitudes are rotations."""

import math
import random

import pytest

from solver import assemble
from solver.scene import Expr, Rigid, SceneError, evaluate, loads

HEAD = 'name = "body"\n[parameters]\na = 0.7\n[bodies.b]\nposition = [1, 2, 3]\n'
PLANE = HEAD.replace("[par", "dimension = 2\n[par").replace(", 3]", "]")
POINT_MASS = "mass = 2.0\ninertia = [0, 0, 0]\n"


def body(text: str, head: str = HEAD) -> Rigid:
    rigid = loads(head + text).bodies["b"]
    assert isinstance(rigid, Rigid)
    return rigid


def values(matrix):
    """Numbers of a vector or matrix with the default parameters."""
    if isinstance(matrix, tuple):
        return [values(item) for item in matrix]
    return evaluate(matrix, {"a": 0.7})


def turned(orientation: str) -> list[list[float]]:
    return values(body(f"{POINT_MASS}orientation = {orientation}\n").orientation)


def close(x, y) -> bool:
    """Equal but for the round-off of a few operations on numbers of size 1."""
    return all(math.isclose(a, b, abs_tol=4e-16) for r, s in zip(x, y, strict=True)
               for a, b in zip(r, s, strict=True))  # fmt: skip


def diagonal(inertia):
    rows = values(inertia)
    assert all(rows[i][j] == 0.0 for i in range(3) for j in range(3) if i != j)
    return [rows[i][i] for i in range(3)]


def test_a_body_is_at_rest_and_not_turned_unless_it_says_so():
    rigid = body(POINT_MASS)
    assert rigid.velocity is None
    assert rigid.angular_velocity is None
    assert rigid.center_of_mass == (0.0, 0.0, 0.0)
    assert turned("{ axis = [0, 0, 3], angle = 0 }") == values(rigid.orientation)


QUARTER = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]


@pytest.mark.parametrize(
    "orientation",
    [
        '{ axis = [0, 0, 2], angle = "pi/2" }',
        "{ quaternion = [1, 0, 0, 1] }",
        "{ quaternion = [-3, 0, 0, -3] }",
        '{ rotation_vector = [0, 0, "pi/2"] }',
        "{ matrix = [[0, -1, 0], [1, 0, 0], [0, 0, 1]] }",
        '{ axis = [0, 0, 1], angle = "pi/2 + 0*a" }',
        '{ rotation_vector = [0, 0, "pi*a/1.4"] }',
        '{ quaternion = ["a", 0, 0, "a"] }',
    ],
)
def test_every_way_of_writing_a_quarter_turn_is_the_same(orientation):
    assert close(turned(orientation), QUARTER)


def test_random_rotation_vectors_are_rotations_and_agree_with_axis_and_angle():
    numbers = random.Random(4)
    for size in (1e-9, 1e-3, 1.0, 6.0):
        v = [size * numbers.uniform(-1, 1) for _ in range(3)]
        by_vector = turned(f"{{ rotation_vector = {v} }}")
        by_axis = turned(f"{{ axis = {v}, angle = {math.hypot(*v)!r} }}")
        half = math.hypot(*v) / 2.0
        unit = [math.sin(half) * x / math.hypot(*v) for x in v]
        by_quaternion = turned(f"{{ quaternion = {[math.cos(half), *unit]} }}")
        for i in range(3):
            for j in range(3):
                product = math.fsum(by_vector[k][i] * by_vector[k][j] for k in range(3))
                assert product == pytest.approx(float(i == j), abs=1e-15)
                assert by_vector[i][j] == pytest.approx(by_axis[i][j], abs=1e-15)
                assert by_vector[i][j] == pytest.approx(by_quaternion[i][j], abs=2e-15)


def test_a_rotation_vector_may_vanish_with_its_parameter():
    matrix = body(POINT_MASS + 'orientation = { rotation_vector = [0, 0, "a"] }').orientation
    assert isinstance(matrix, tuple)
    assert isinstance(matrix[0][0], Expr)
    assert [[evaluate(x, {"a": 0.0}) for x in row] for row in matrix] == [
        [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0],
    ]  # fmt: skip


def test_an_angular_velocity_in_body_axes_arrives_in_global_axes():
    text = POINT_MASS + 'orientation = { axis = [0, 0, 1], angle = "pi/2" }\n'
    own = body(text + "angular_velocity = { body = [1, 2, 3] }\n").angular_velocity
    assert values(own) == pytest.approx([-2.0, 1.0, 3.0], abs=1e-15)
    assert body(text + "angular_velocity = [1, 2, 3]\n").angular_velocity == (1.0, 2.0, 3.0)


@pytest.mark.parametrize(
    ("shape", "mass", "moments"),
    [
        ('type = "box", size = [1, 2, 3], density = 2', 12.0, [13.0, 10.0, 5.0]),
        ('type = "cylinder", radius = 1, length = 2, density = 3', 6 * math.pi,
         [3.5 * math.pi, 3.5 * math.pi, 3 * math.pi]),
        ('type = "cylinder", radius = 1, length = 2, axis = "y", density = 3', 6 * math.pi,
         [3.5 * math.pi, 3 * math.pi, 3.5 * math.pi]),
        ('type = "sphere", radius = 2, density = 3', 32 * math.pi, [51.2 * math.pi] * 3),
        ('type = "sphere", radius = 2, inner_radius = 1, density = 3', 28 * math.pi,
         [(51.2 - 1.6) * math.pi] * 3),
        ('type = "cylinder", radius = 2, inner_radius = 1, length = 1, density = 1', 3 * math.pi,
         [4 * math.pi, 4 * math.pi, 7.5 * math.pi]),
    ],
)  # fmt: skip
def test_shapes_in_space_weigh_what_the_textbook_says(shape, mass, moments):
    rigid = body(f"shape = {{ {shape} }}\n")
    assert values(rigid.mass) == pytest.approx(mass, rel=4e-16)
    assert diagonal(rigid.inertia) == pytest.approx(moments, rel=1e-15)


@pytest.mark.parametrize(
    ("shape", "mass", "moment"),
    [
        ('type = "box", size = [3, 4], density = 2', 24.0, 50.0),
        ('type = "disc", radius = 2, density = 1', 4 * math.pi, 8 * math.pi),
        ('type = "disc", radius = 2, inner_radius = 1, density = 1', 3 * math.pi, 7.5 * math.pi),
        ('type = "rod", length = 6, density = 2', 12.0, 36.0),
    ],
)
def test_shapes_in_the_plane_weigh_what_the_textbook_says(shape, mass, moment):
    rigid = body(f"shape = {{ {shape} }}\n", PLANE)
    assert values(rigid.mass) == pytest.approx(mass, rel=4e-16)
    assert values(rigid.inertia) == pytest.approx(moment, rel=1e-15)


def test_a_shape_with_a_mass_needs_no_density_and_follows_parameters():
    rigid = body('mass = "3*a"\nshape = { type = "box", size = ["a", 1, 1] }\n')
    assert values(rigid.mass) == pytest.approx(2.1, rel=1e-15)
    moments = [evaluate(rigid.inertia[i][i], {"a": 2.0}) for i in range(3)]
    assert moments == pytest.approx([1.0, 2.5, 2.5], rel=1e-15)


@pytest.mark.parametrize("inertia", ["[0, 0, 0]", "[0, 2, 2]", "[1, 2, 3]", "[1e-9, 0.1, 0.1]"])
def test_points_rods_and_plates_are_bodies(inertia):
    body(f"mass = 1.0\ninertia = {inertia}\n")


def test_the_triangle_inequality_is_that_of_the_principal_moments():
    """A plate of moments 1, 2, 3 turned by 0.7 rad is a body; with 3 + 1e-6 it is none."""
    c, s = math.cos(0.7), math.sin(0.7)

    def inertia(x: float, y: float, z: float) -> str:
        rows = [[c * c * x + s * s * z, 0, c * s * (x - z)], [0, y, 0],
                [c * s * (x - z), 0, s * s * x + c * c * z]]  # fmt: skip
        return f"mass = 1.0\ninertia = {rows}\n"

    body(inertia(1.0, 2.0, 3.0 - 1e-12))
    with pytest.raises(SceneError, match="inertia that no body can have"):
        body(inertia(1.0, 2.0, 3.0 + 1e-6))


def test_the_place_of_a_body_point_is_where_the_turned_body_has_it():
    text = POINT_MASS + 'orientation = { axis = [0, 0, 1], angle = "pi/2" }\n'
    text += 'points = { tip = [1, 0, 0] }\n[forces]\ns = { type = "damper", damping = 1, '
    text += 'points = ["ground", "b.tip"], at = [[0, 0, 0], '
    loads(HEAD + text + "[1, 3, 3]] }\n")
    with pytest.raises(SceneError, match=r"the point 'b.tip' is drawn at"):
        loads(HEAD + text + "[2, 2, 3]] }\n")


def test_a_body_that_is_too_large_for_numbers_is_reported():
    with pytest.raises(SceneError, match="larger than any floating-point number"):
        body('shape = { type = "sphere", radius = 1e150, density = 1 }\n')


def test_whether_a_velocity_was_given_is_kept():
    points = loads(
        'name = "p"\n[points]\nA = { position = [0, 0, 0], mass = 1 }\n'
        "B = { position = [0, 0, 0], mass = 1, velocity = [0, 0, 0] }\n"
    ).points
    assert points["A"].velocity is None
    assert points["B"].velocity == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(("head", "inertia"), [(PLANE, "0.0"), (HEAD, "[0, 0, 0]")])
def test_a_lone_body_without_inertia_is_told_part_rule_and_remedy(head, inertia):
    with pytest.raises(SceneError) as caught:
        assemble(loads(f"{head}mass = 2.0\ninertia = {inertia}\n"))
    report = str(caught.value)
    assert "bodies.b: inertia must be > 0 kg.m2, got 0" in report
    assert "write an inertia, or a point instead of the body" in report
