"""Loops whose axes are parallel to seven digits, next to a dead centre, move as in the plane.

Crank, rod and foot are nearly in line. Their three hinges are parallel but for what files with few
digits leave, and are taken as parallel: one of the three rows of the ball that closes the loop is
redundant. The reference is a Lagrangian of one freedom, the
angle of the crank, with DOP853 at 1e-12.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import solver
from tests.support.mechanisms.problems import Array

LENGTH, MASS = np.array([0.055, 0.35, 0.07]), np.array([0.1, 0.12, 0.15])
INERTIA = np.array([5e-5, 1.8e-3, 8e-4])
DRAWN = -1.344 + np.array([0.0, -0.017, -0.034])
"""Angles of crank, rod and foot from the x axis of their plane [rad]."""
PLANE = Rotation.from_rotvec([np.pi / 2, 0, 0]) * Rotation.from_rotvec([0.6, 0.5, 0.3])
GRAVITY = np.array([0.0, 0.0, -9.81])
NAMES = ("crank", "rod", "foot")
TIMES = np.linspace(0.02, 0.1, 5)


def along(angle: float) -> Array:
    return np.array([np.cos(angle), np.sin(angle)])


def across(angle: float) -> Array:
    return np.array([-np.sin(angle), np.cos(angle)])


START = LENGTH[0] * along(DRAWN[0])
END = START + LENGTH[1] * along(DRAWN[1])
FOOT = END - LENGTH[2] * along(DRAWN[2])


def closed(crank: float, near: Array) -> Array:
    """Angles of rod and foot, by Newton's iteration."""
    x = near.copy()
    for _ in range(20):
        gap = LENGTH[0] * along(crank) + LENGTH[1] * along(x[0]) - FOOT - LENGTH[2] * along(x[1])
        x -= np.linalg.solve(arms(x), gap)
    return x


def arms(x: Array) -> Array:
    return np.column_stack([LENGTH[1] * across(x[0]), -LENGTH[2] * across(x[1])])


def ratios(crank: float, x: Array) -> Array:
    """Angular velocities over that of the crank."""
    return np.array([1.0, *np.linalg.solve(arms(x), -LENGTH[0] * across(crank))])


def centres(q: Array) -> list[Array]:
    a = LENGTH[0] * along(q[0])
    return [0.5 * a, a + 0.5 * LENGTH[1] * along(q[1]), FOOT + 0.5 * LENGTH[2] * along(q[2])]


@cache
def reference(speed: float) -> list[Array]:
    """Centres in space at `TIMES`, each of shape (3, 3)."""
    near = DRAWN[1:].copy()
    pull = PLANE.inv().apply(GRAVITY)[:2]

    def rate(_t: float, y: Array) -> list[float]:
        near[:] = closed(y[0], near)
        q, r = np.array([y[0], *near]), ratios(y[0], near)
        v = r * y[1]
        outward = [length * along(a) * w**2 for length, a, w in zip(LENGTH, q, v, strict=True)]
        bend = np.linalg.solve(arms(near), outward[0] + outward[1] - outward[2])
        bends = np.array([0.0, *bend])  # second derivatives at a steady crank
        turned = [length * across(a) for length, a in zip(LENGTH, q, strict=True)]
        moved = [
            [0.5 * turned[0], turned[0], 0.0 * turned[0]],
            [0.0 * turned[1], 0.5 * turned[1], 0.0 * turned[1]],
            [0.0 * turned[2], 0.0 * turned[2], 0.5 * turned[2]],
        ]  # by the angle, of each centre
        inward = [0.5 * outward[0], outward[0] + 0.5 * outward[1], 0.5 * outward[2]]
        mass = force = 0.0
        for k in range(3):
            way = sum(moved[j][k] * r[j] for j in range(3))
            bias = sum(moved[j][k] * bends[j] for j in range(3)) - inward[k]
            mass += MASS[k] * way @ way + INERTIA[k] * r[k] ** 2
            force += MASS[k] * way @ (pull - bias) - INERTIA[k] * r[k] * bends[k]
        return [y[1], force / mass]

    begin, span = [DRAWN[0], speed], (0, TIMES[-1])
    run = solve_ivp(rate, span, begin, "DOP853", t_eval=TIMES, rtol=1e-12, atol=1e-14)
    found, x = [], DRAWN[1:]
    for crank in run.y[0]:
        x = closed(crank, x)
        places = [[*p, 0.0] for p in centres(np.array([crank, *x]))]
        found.append(PLANE.apply(places))
    return found


def drawn(tilt: float, speed: float, **settings: float) -> solver.Scene:
    """The loop; the axis of the foot's hinge is tilted against the others [rad]."""

    def place(p: Array) -> list[float]:
        return PLANE.apply([*p, 0.0]).tolist()

    axis, r = PLANE.apply([0.0, 0.0, 1.0]), ratios(DRAWN[0], DRAWN[1:])
    centre, text = centres(DRAWN), f'name = "loop"\ngravity = {GRAVITY.tolist()}\n'
    for k, name in enumerate(NAMES):
        x, y, z, w = (PLANE * Rotation.from_rotvec([0, 0, DRAWN[k]])).as_quat().tolist()
        own = INERTIA[k].item()
        text += f"[bodies.{name}]\nposition = {place(centre[k])}\nmass = {MASS[k]}\n"
        text += f"orientation = {{ quaternion = {[w, x, y, z]} }}\n"
        text += f"inertia = {[0.01 * own, own, own]}\n"
        text += f"angular_velocity = {(speed * r[k] * axis).tolist()}\n" if speed else ""
    tilted = (axis + tilt * PLANE.apply([1.0, 0.3, 0.0])).tolist()
    text += "[joints]\n"
    for pin, bodies, at, line in (
        ("O", ["ground", "crank"], np.zeros(2), axis.tolist()),
        ("A", ["crank", "rod"], START, axis.tolist()),
        ("C", ["ground", "foot"], FOOT, tilted),
    ):
        text += f'{pin} = {{ type = "revolute", bodies = {bodies}, '
        text += f"position = {place(at)}, axis = {line} }}\n"
    text += f'B = {{ type = "spherical", bodies = ["rod", "foot"], position = {place(END)} }}\n'
    text += "[solver]\n" + ("assemble = true\n" if speed else "")
    return solver.loads(text + "".join(f"{name} = {x}\n" for name, x in settings.items()))


@pytest.mark.parametrize("step", [1e-3, 1e-4])
@pytest.mark.parametrize("tolerance", [None, 1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize(
    ("tilt", "speed"), [(0.0, 0.0), *((tilt, v) for tilt in (1e-9, 7e-8, 1e-6) for v in (0.0, 3.0))]
)
@pytest.mark.filterwarnings("ignore:.* is parallel to that of joint:solver.SceneWarning")
def test_a_loop_of_nearly_parallel_axes_moves_as_in_its_plane(tilt, speed, tolerance, step):
    settings = {"step_size": step} | ({"tolerance": tolerance} if tolerance else {})
    run = solver.simulate(drawn(tilt, speed, **settings), stop_time=TIMES[-1], step_size=step)
    size = LENGTH.sum()
    # The tilt moves places by no more than itself times the size; errors of pairs are of order 2.
    bound = tilt * size + (3.0 * tolerance * size if tolerance else 0.1 * step**2) + 1e-10
    for t, right in zip(TIMES, reference(speed), strict=True):
        at = int(np.argmin(np.abs(np.array(run.t) - t)))
        for k, name in enumerate(NAMES):
            found = [run[f"{name}.{x}"][at] for x in "xyz"]
            assert found == pytest.approx(right[k], abs=bound)
    assert run["energy.error"].max() < 1e-9
    assert run["constraint.position"].max() < tilt + 1e-12


def test_axes_that_are_taken_as_parallel_are_told():
    with pytest.warns(solver.SceneWarning, match="to that of joint 'O' but for 1.04e-06 rad"):
        drawn(1e-6, 0.0)


def test_a_loop_whose_axes_are_meant_to_be_tilted_is_a_frame():
    """1e-3 rad are no digits of a file: hinges that are not parallel, and a ball, hold the loop."""
    scene = drawn(1e-3, 0.0, step_size=1e-3)
    assert not scene.warnings
    run = solver.simulate(scene, stop_time=0.1, step_size=1e-3)
    assert abs(run["crank.y"][-1] - run["crank.y"][0]) < 1e-3 * LENGTH.sum()


def test_short_steps_do_not_enlarge_what_rows_of_tilted_axes_miss():
    # Multipliers of what is missed would grow as 1/h^2.
    run = solver.simulate(drawn(7e-8, 0.0, step_size=1e-6), stop_time=1e-3, step_size=1e-5)
    assert run["energy.error"].max() < 1e-10
