"""Ellipsoids that roll, slide and hit, against equations of motion that are written down here."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import solver
from tests.physics.test_bodies_with_shapes import run, vector
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism, observed_order
from tests.support.mechanisms.reduced_models import Array, rotation

SCENES = Path(solver.__file__).parents[1] / "scenes"


def crossed(a: Array) -> Array:
    """Matrix of a x."""
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])


def rolling_stone(
    half: Array, mass: float, inertia: Array, centre: Array, spin: Array, times: Array
) -> tuple[Array, Array]:
    """Angular velocities and heights of the axes of a stone that rolls without slip on z = 0.

    In its axes, from the centre of mass: w, the upward normal n and the place r that touches,
    r = -A n/|a n| - c with A = diag a^2.  v = -w x r,  m (v' + w x v + g n) = F,
    I w' + w x I w = r x F,  n' = -w x n.
    """
    squares = half**2

    def slope(_: float, state: Array) -> Array:
        n, w = state[:3], state[3:]
        n_rate, h = -np.cross(w, n), math.sqrt(squares @ (n * n))
        r = -squares * n / h - centre
        r_rate = -squares * n_rate / h + squares * n * (squares @ (n * n_rate)) / h**3
        v = -np.cross(w, r)
        known = mass * (-np.cross(w, r_rate) + np.cross(w, v) + GRAVITY * n)  # F = known - m w' x r
        matrix = inertia - mass * crossed(r) @ crossed(r)
        w_rate = np.linalg.solve(matrix, np.cross(r, known) - np.cross(w, inertia @ w))
        return np.array([*n_rate, *w_rate])

    start = np.concatenate(([0.0, 0.0, 1.0], spin))
    found = solve_ivp(slope, (0.0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-13)
    assert found.success
    return np.array(found.y[3:].T), np.array(found.y[:3].T)


def rattled(h: float, order: int) -> tuple[solver.Trajectory, Array]:
    """Spin about the vertical of the scene, and by the equations of rolling."""
    scene = solver.load(SCENES / "rattleback.toml", {"solver.step_size": h, "solver.order": order})
    ran = solver.simulate(scene, stop_time=2.0)
    skew = rotation([0.0, 0.0, 0.1])
    inertia = skew @ np.diag([1e-5, 5e-4, 5e-4]) @ skew.T
    spins, normals = rolling_stone(
        np.array([0.1, 0.02, 0.015]), 0.2, inertia, np.array([0, 0, -0.005]),
        np.array([0.1, 0.0, -3.0]), ran.t,
    )  # fmt: skip
    return ran, np.einsum("ki,ki->k", spins, normals)


def test_a_rattleback_turns_back_as_the_equations_of_rolling_say():
    """Clockwise at 3 rad/s it turns the other way with 2.84 rad/s after 1.3 s; order 4."""
    errors = []
    for h in (0.004, 0.002):
        ran, spin = rattled(h, 4)
        assert spin[0] == -3.0
        assert spin.max() == pytest.approx(2.8435, abs=1e-3)
        assert ran["energy.error"].max() < 1e-12
        assert ran["table.slip"].max() < 1e-6  # of order 4, too
        errors.append(float(np.abs(ran["stone.wz"] - spin).max()))
    assert errors[1] < 5e-6
    assert observed_order([0.004, 0.002], errors) == pytest.approx(4.0, abs=0.3)


def test_a_rattleback_turns_on_if_it_is_spun_the_other_way():
    scene = solver.load(SCENES / "rattleback.toml", {"parameters.spin.value": 3.0})
    ran = solver.simulate(scene, stop_time=2.0)
    assert ran["stone.wz"].min() > 1.0


def stone(half: list[float], **more: object) -> Content:
    body = {"mass": 2.0, "inertia": [0.02, 0.03, 0.04], "position": [0, 0, half[2]]}
    contact = {"type": "ellipsoid", "body": "a", "semi_axes": half, "axis": [0, 0, 1]}
    return mechanism("stone", 3, bodies={"a": body}, contacts={"c": contact | more})


def sliding_stone(half: Array, friction: float, spin: Array, v: Array, times: Array) -> Array:
    """Centres of a stone that slides on z = 0 with Coulomb's friction, in global axes.

    z = |a n| fixes the vertical force N:  z' = r . (w x up) with the arm r to the place that
    touches, z'' by N through the linear equations, and the friction is -c N s/|s|.
    """
    mass, own = 2.0, np.array([0.02, 0.03, 0.04])
    up, squares = np.array([0.0, 0.0, 1.0]), half**2

    def parts(R: Array, w: Array) -> tuple[Array, Array]:
        """Arm to the place that touches, and its rate in body axes turned to global ones."""
        n = R.T @ up
        n_rate, h = -np.cross(R.T @ w, n), math.sqrt(squares @ (n * n))
        r = -squares * n / h
        r_rate = -squares * n_rate / h + squares * n * (squares @ (n * n_rate)) / h**3
        return R @ r, R @ r_rate

    def slope(_: float, state: Array) -> Array:
        R, w, v = state[:9].reshape(3, 3), state[9:12], state[12:15]
        r, r_body = parts(R, w)
        slip = v + np.cross(w, r)
        pull = up - friction * (slip - slip[2] * up) / np.linalg.norm(slip[:2])
        inverse = R @ np.diag(1.0 / own) @ R.T
        gyration = inverse @ -np.cross(w, R @ (own * (R.T @ w)))
        turned = inverse @ np.cross(r, pull)
        # (v + w x r) . up = 0; its rate with r' = r_body + w x r
        bias = (np.cross(gyration, r) + np.cross(w, r_body + np.cross(w, r)))[2] - GRAVITY
        force = -bias / (1.0 / mass + np.cross(turned, r)[2])
        w_rate, v_rate = gyration + force * turned, force / mass * pull - GRAVITY * up
        return np.concatenate(((crossed(w) @ R).ravel(), w_rate, v_rate, v))

    start = np.concatenate((np.eye(3).ravel(), spin, v, [0.0, 0.0, half[2]]))
    found = solve_ivp(slope, (0.0, times[-1]), start, "DOP853", times, rtol=1e-11, atol=1e-12)
    assert found.success
    return np.array(found.y[15:].T)


def test_a_stone_slides_and_turns_as_coulombs_law_says():
    half, friction, spin, v = [0.3, 0.2, 0.1], 0.2, [0.3, 0.2, 4.0], [2.0, 0.5, 0.0]
    v[2] = float(-np.cross(spin, [0.0, 0.0, -half[2]])[2])
    content = stone(half, friction=friction)
    content["bodies"]["a"] |= {"velocity": v, "angular_velocity": spin}
    times = np.array([0.0, 0.4])
    exact = sliding_stone(np.array(half), friction, np.array(spin), np.array(v), times)[-1]
    errors = []
    for h in (0.02, 0.01):
        ran = run(content, 0.4, h=h, order=4)
        errors.append(float(np.linalg.norm(vector(ran, "a.") - exact)))
    assert errors[1] < 1e-6
    assert observed_order([0.02, 0.01], errors) > 3.5


@pytest.mark.parametrize("touches", ["plane", "ball"])
def test_an_ellipsoid_of_equal_axes_is_a_ball(touches):
    """It moves as a ball with a radius does, sliding first and rolling later."""
    radius, found = 0.2, []
    body = {
        "mass": 2.0, "inertia": [0.03, 0.03, 0.03], "position": [0, 0, 0.2],
        "velocity": [0.3, 0.1, 0.0], "angular_velocity": [1.0, 2.0, 3.0],
    }  # fmt: skip
    bodies: Content = {"a": body}
    like = {"type": "plane", "point": "a", "axis": [0, 0, 1], "radius": radius}
    own: Content = {"type": "ellipsoid", "body": "a", "semi_axes": [radius] * 3}
    if touches == "plane":
        own["axis"] = [0, 0, 1]
    else:
        like = {"type": "sphere", "points": ["a", "b"], "radii": [radius, 0.5]}
        own |= {"point": "b", "radius": 0.5}
        bodies["b"] = {"mass": 50.0, "inertia": [5.0] * 3, "position": [0, 0, -0.5]}
    for contact in (like, own):
        content = mechanism("ball", 3, bodies=bodies, contacts={"c": contact | {"friction": 0.1}})
        content["gravity"] = [0, 0, -9.81 if touches == "plane" else 0.0]
        ran = run(content, 0.5, h=0.01)
        found.append(np.concatenate([vector(ran, "a."), vector(ran, "a.w"), vector(ran, "a.v")]))
    assert found[1] == pytest.approx(found[0], abs=1e-10)


@pytest.mark.parametrize("restitution", [1.0, 0.5, 0.0])
def test_an_ellipsoid_and_a_ball_that_hit_keep_their_momenta(restitution):
    """And lose (1 - e^2) of what they lose with e = 0, W = sum 1/m + (r x n) . (r x n)/J."""
    half, radius, speed = np.array([0.3, 0.2, 0.1]), 0.15, 2.0
    inertia = np.array([0.02, 0.03, 0.04])
    n = np.array([2.0, 1.0, 2.0]) / 3.0
    place = half**2 * n / np.linalg.norm(half * n)
    ball = {
        "mass": 1.0, "inertia": [0.01] * 3, "position": (place + (radius + 0.1) * n).tolist(),
        "velocity": (-speed * n).tolist(),
    }  # fmt: skip
    stone = {"mass": 2.0, "inertia": inertia.tolist(), "position": [0, 0, 0]}
    contact = {
        "type": "ellipsoid", "body": "a", "semi_axes": half.tolist(), "point": "b",
        "radius": radius, "restitution": restitution, "friction": 0.0,
    }  # fmt: skip
    content = mechanism(
        "hit", 3, gravity=False, bodies={"a": stone, "b": ball}, contacts={"c": contact}
    )  # fmt: skip
    ran = run(content, 0.2, h=0.01)
    assert ran["c.impacts"] == 1.0
    arm = np.cross(place, n)
    inverse = 1.0 / 1.0 + 1.0 / 2.0 + arm @ (arm / inertia)
    lost = 0.5 * (1.0 - restitution**2) * speed**2 / inverse
    assert ran["energy.impact"] == pytest.approx(lost, abs=1e-12)
    impulse = (1.0 + restitution) * speed / inverse
    assert vector(ran, "b.v") == pytest.approx((impulse - speed) * n, abs=1e-10)
    assert vector(ran, "momentum.") == pytest.approx(-speed * n, abs=1e-13)


def ball_on_a_stone(
    half: Array, radius: float, start: Array, spin: Array, times: Array
) -> tuple[Array, Array]:
    """Places x that a ball touches, and its spins w, which rolls on an ellipsoid at rest.

    c = x + R n, v = R w x n, v = (E + R N) x' with N = dn/dx,
    (I + m R^2 (E - n n')) w' = -m R n x (R w x n' + g up), up to m: I/m = 2/5 R^2.
    """
    weights = 1.0 / half**2
    gravity = np.array([0.0, 0.0, -GRAVITY])

    def slope(_: float, state: Array) -> Array:
        x, w = state[:3], state[3:]
        size = np.linalg.norm(weights * x)
        n = weights * x / size
        N = (np.diag(weights) - np.outer(n, weights * n)) / size
        x_rate = np.linalg.solve(np.eye(3) + radius * N, radius * np.cross(w, n))
        n_rate = N @ x_rate
        matrix = radius**2 * (1.4 * np.eye(3) - np.outer(n, n))
        right = -radius * np.cross(n, radius * np.cross(w, n_rate) - gravity)
        return np.array([*x_rate, *np.linalg.solve(matrix, right)])

    found = solve_ivp(slope, (0.0, times[-1]), np.concatenate((start, spin)), "DOP853", times,
                      rtol=1e-12, atol=1e-13)  # fmt: skip
    assert found.success
    return np.array(found.y[:3].T), np.array(found.y[3:].T)


def test_a_ball_rolls_on_an_ellipsoid_as_the_equations_of_rolling_say():
    half, radius = np.array([0.6, 0.4, 0.3]), 0.1
    n = np.array([0.1, 0.1, 1.0])
    n = n / np.linalg.norm(n)
    place = half**2 * n / np.linalg.norm(half * n)
    spin = np.array([1.0, -0.5, 2.0])
    x, w = ball_on_a_stone(half, radius, place, spin, np.array([0.0, 0.3]))
    ball = {
        "mass": 0.5, "inertia": [0.4 * 0.5 * radius**2] * 3,
        "position": (place + radius * n).tolist(), "angular_velocity": spin.tolist(),
        "velocity": (radius * np.cross(spin, n)).tolist(),
    }  # fmt: skip
    stone = {"mass": 1.0, "inertia": [1.0] * 3, "position": [0, 0, 0]}
    contact = {
        "type": "ellipsoid", "body": "a", "semi_axes": half.tolist(), "point": "b",
        "radius": radius, "friction": 5.0,
    }  # fmt: skip
    content = mechanism(
        "rolls", 3, bodies={"a": stone, "b": ball}, contacts={"c": contact},
        joints={"held": {"type": "fixed", "bodies": ["ground", "a"]}},
    )  # fmt: skip
    ran = run(content, 0.3, h=0.01, order=4)
    exact = x[-1] / half**2
    exact = x[-1] + radius * exact / np.linalg.norm(exact)
    assert vector(ran, "b.") == pytest.approx(exact, abs=1e-6)
    assert vector(ran, "b.w") == pytest.approx(w[-1], abs=1e-5)
    assert ran["energy.dissipated"] == pytest.approx(0.0, abs=1e-13)


def test_an_ellipse_that_rolls_on_a_line_rocks_with_its_exact_period():
    """T + V = E in one coordinate: (J + m r^2) phi'^2/2 + m g h(phi), with h = |a n|."""
    a, b, mass, inertia, angle = 0.3, 0.2, 1.5, 0.05, 0.4
    s, c = np.sin(angle), np.cos(angle)
    height = math.hypot(a * s, b * c)

    def rate(phi: float) -> float:
        low = math.hypot(a * math.sin(phi), b * math.cos(phi))
        shift = (a * a - b * b) * math.sin(phi) * math.cos(phi) / low
        energy = 2.0 * mass * GRAVITY * (height - low)
        return math.sqrt(max(energy, 0.0) / (inertia + mass * (low * low + shift * shift)))

    turns = np.linspace(0.0, math.pi / 2, 2001)[:-1]  # phi = angle sin(turn) has no poles
    ways = angle * np.cos(turns[1:])
    rates = np.array([rate(angle * math.sin(x)) for x in turns[1:]])
    first = angle / rate(0.0)
    last = 2.0 * (ways / rates)[-1] - (ways / rates)[-2]
    values = np.concatenate(([first], ways / rates, [last]))
    quarter = (turns[1] - turns[0]) * (values.sum() - 0.5 * (values[0] + values[-1]))
    body = {
        "mass": mass, "inertia": inertia, "position": [0, height], "orientation": angle,
    }  # fmt: skip
    contact = {
        "type": "ellipsoid", "body": "a", "semi_axes": [a, b], "axis": [0, 1], "friction": 2.0
    }  # fmt: skip
    content = mechanism("rocks", 2, bodies={"a": body}, contacts={"c": contact})
    ran = run(content, float(quarter), h=0.005, order=4)
    assert ran["a.angle"] == pytest.approx(0.0, abs=2e-6)
    assert abs(float(ran["a.angular_velocity"])) == pytest.approx(rate(0.0), rel=1e-7)


@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_slips_and_frictions_count_to_the_right_of_the_normal(speed):
    """A ball of 1 kg, 0.01 kg m2 and 0.1 m that slides on a floor, and on a round ellipse.

    s' = -(mu N/m)(1 + m r^2/I): it slides in front of a friction mu N that holds it back.
    """
    floor = {"type": "plane", "point": "ball", "radius": 0.1, "axis": [0, 1], "friction": 0.2}
    round_one = {"type": "ellipsoid", "body": "ball", "semi_axes": [0.1, 0.1], "axis": [0, 1]}
    below = {"type": "ellipsoid", "body": "base", "semi_axes": [1.0, 1.0], "point": "ball"}
    balls = {"type": "sphere", "points": ["base", "ball"], "radii": [1.0, 0.1], "friction": 0.2}
    found = {}
    for name, contact, height in (
        ("floor", floor, 0.1),
        ("round", round_one | {"friction": 0.2}, 0.1),
        ("below", below | {"radius": 0.1, "friction": 0.2}, 1.1),
        ("balls", balls, 1.1),
    ):
        body = {"mass": 1.0, "inertia": 0.01}
        bodies = {
            "ball": body | {"position": [0, height], "velocity": [speed, 0]},
            "base": body | {"position": [0, 0]},
        }
        held = {"held": {"type": "fixed", "bodies": ["ground", "base"]}}
        content = mechanism("slip", 2, bodies=bodies, joints=held, contacts={"c": contact})
        integrator = run(content, 0.02)
        found[name] = [float(integrator[f"c.{word}"]) for word in ("slip", "friction", "force")]
    s = math.copysign(1.0, speed)
    exact = [s * (1.0 - 0.2 * GRAVITY * 2.0 * 0.02), -s * 0.2 * GRAVITY, GRAVITY]
    assert found["floor"] == pytest.approx(exact, rel=1e-12)
    assert found["round"] == pytest.approx(exact, rel=1e-12)
    slip, friction, force = found["below"]  # right of the normal is clockwise about the lower one
    assert (s * slip > 0.9, friction) == (True, pytest.approx(-s * 0.2 * force, rel=1e-12))
    assert found["balls"] == pytest.approx([-slip, -friction, force], rel=1e-6)  # of a step


def test_a_ball_drawn_at_the_centre_of_an_ellipsoid_is_in_penetration():
    """There is no normal there, nor a direction of slip that begins with it."""
    pair = {"type": "ellipsoid", "body": "b", "point": "p", "semi_axes": [0.2, 0.1, 0.3]}
    content: Content = {
        "name": "within", "dimension": 3, "gravity": [0, 0, -GRAVITY],
        "bodies": {"b": {"position": [0, 0, 0], "mass": 1, "inertia": [0.1, 0.1, 0.1]}},
        "points": {"p": {"position": [0, 0, 0], "mass": 1}},
        "contacts": {"c": pair | {"radius": 0.01, "friction": 0.3}},
    }  # fmt: skip
    with pytest.raises(solver.SceneError, match="drawn in penetration"):
        run(content, 0.1, h=0.01)
