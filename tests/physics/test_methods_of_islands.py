"""Equal steps of orders 4, 6 and 8: each island takes covers or a composition as if it were alone.

A composition keeps the energy of each motion of an island, and a cover that of all of them together
alone. An oscillator with a damper beside them shall change nothing for those without one.
"""

from __future__ import annotations

import json
import math
import sys
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from solver.runtime import Integrator
from tests.physics.test_high_orders import FLYING, MANIPULATOR, RESTLESS
from tests.physics.test_random_islands import GRAVITY, motion
from tests.support.mechanisms.island_scenes import assembled, beside, started
from tests.support.mechanisms.random_mechanisms import driven_systems, free_systems

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

pytestmark = pytest.mark.filterwarnings("ignore:joints.*do not allow the velocity")  # flying

ORDERS = (4, 6, 8)
WELL = {"type": "potential", "value": "0.5*A.x**2 + 15*A.y**2"}
"""A point of 1 kg in it swings with 1 rad/s along x, with sqrt(30) rad/s along y."""
BESIDE_A_BRAKE: dict[str, Any] = {
    "name": "beside_a_brake",
    "dimension": 2,
    "gravity": [0, 0],
    "points": {
        "A": {"position": [1, 1], "mass": 1.0},
        "B": {"position": [2, 0], "mass": 2.0, "velocity": [0.5, 0]},
    },
    "forces": {
        "well": WELL,
        "spring": {
            "type": "spring", "points": ["ground", "B"], "at": [0, 0],
            "stiffness": 18.0, "free_length": 1.5,
        },
        "brake": {"type": "damper", "points": ["ground", "B"], "at": [0, 0], "damping": 2.0},
    },
}  # fmt: skip
"""Beside the point in the well: x'' + x' + 9 x = 0 from (0.5, 0.5), with x = B.x - 1.5."""


def swings(run: Integrator) -> tuple[float, float]:
    """Energies of the point in the well along x and y [J]."""
    x, y, vx, vy = (float(run[f"A.{part}"]) for part in ("x", "y", "vx", "vy"))
    return 0.5 * (vx * vx + x * x), 0.5 * (vy * vy + 30.0 * y * y)


def damped(t: float) -> tuple[float, float]:
    """Place and speed of the damped oscillator [m, m/s], in closed form."""
    w = math.sqrt(8.75)
    a, b, decay, c, s = 0.5, 0.75 / w, math.exp(-0.5 * t), math.cos(w * t), math.sin(w * t)
    return decay * (a * c + b * s), decay * ((b * w - 0.5 * a) * c - (a * w + 0.5 * b) * s)


@pytest.mark.parametrize("order", ORDERS)
def test_each_swing_keeps_its_energy_beside_a_damped_oscillator(order):
    # Composed pairs are the midpoint rule here, which keeps both energies. Covers lost 9.8e-3,
    # 2.5e-5 and 2.9e-8 J of the slow one to the fast one.
    run = started(assembled(BESIDE_A_BRAKE, order=order, step_size=0.1))
    run.advance(0.0, 200.0)
    assert swings(run) == pytest.approx((0.5, 15.0), abs=1e-12)


@pytest.mark.parametrize(("order", "n", "error"), [(4, 40, 1e-6), (6, 16, 1e-6), (8, 10, 1e-6)])
def test_the_damped_oscillator_loses_what_the_exact_one_loses_beside_others(order, n, error):
    run = started(assembled(BESIDE_A_BRAKE, order=order, step_size=1.0 / n))
    run.advance(0.0, 1.0)
    x, v = damped(1.0)
    lost = 0.25 - v * v + 9.0 * (0.25 - x * x)
    assert float(run["B.x"]) == pytest.approx(1.5 + x, abs=error)
    assert float(run["B.vx"]) == pytest.approx(v, abs=10 * error)
    assert float(run["energy.dissipated"]) == pytest.approx(lost, abs=10 * error)
    assert abs(float(run["energy.balance"])) < 1e-13
    assert run["solver.order_in_use"] == order
    assert run["solver.as_pairs"] == 0.0


@pytest.mark.parametrize("order", ORDERS)
def test_a_swing_returns_to_its_start_with_the_time_beside_a_damped_oscillator(order):
    # Symmetric steps there and back end where they began; the damped one is at rest by then.
    there = started(assembled(BESIDE_A_BRAKE, order=order, step_size=0.1))
    there.advance(0.0, 50.0)
    back = {**BESIDE_A_BRAKE, "points": {**BESIDE_A_BRAKE["points"]}}
    back["points"]["A"] = {
        "position": [float(there["A.x"]), float(there["A.y"])],
        "velocity": [-float(there["A.vx"]), -float(there["A.vy"])],
        "mass": 1.0,
    }
    run = started(assembled(back, order=order, step_size=0.1))
    run.advance(0.0, 50.0)
    ends = [float(run[f"A.{part}"]) for part in ("x", "y", "vx", "vy")]
    assert ends == pytest.approx([1.0, 1.0, 0.0, 0.0], abs=1e-11)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("order", ORDERS)
@settings(deadline=None, max_examples=6)
@given(data=st.data())
def test_free_mechanisms_move_as_alone_beside_damped_ones(order, dimension, data):
    def drawn(kind: st.SearchStrategy) -> Any:
        found = data.draw(kind.filter(lambda content: content["dimension"] == dimension))
        return found | {"gravity": GRAVITY[:dimension]}

    contents = [
        drawn(driven_systems()),
        drawn(free_systems().map(lambda drawn: drawn[0])),
        drawn(driven_systems()),
    ]
    together = started(assembled(beside(*contents), order=order, step_size=0.02))
    free = started(assembled(contents[1], order=order, step_size=0.02))
    for run in (together, free):
        for _ in range(10):
            run.advance(run.time, 0.02)
    # Rounding differs with the size of the whole, on which floors of the iterations rest. Covers
    # were off by more than 1e-9 at orders 4 and 6.
    assert motion(together, contents[1], "_1") == pytest.approx(
        motion(free, contents[1]), rel=1e-11, abs=1e-11
    )
    assert float(together["energy.error"]) < 1e-13


def joined(first: str, second: str) -> tuple[dict[str, Any], ...]:
    """Two scenes, and one of both, all with the gravity of the first."""
    a, b = (tomllib.loads(text) for text in (first, second))
    b |= {"gravity": a["gravity"]}
    tables = {k: {**a[k], **b.get(k, {})} for k in a if isinstance(a[k], dict)}
    return a, b, {**b, **a, **tables}


DRIVEN_POINT = """
name = "driven_point"
dimension = 2
gravity = [0, -9.81]
[points]
P = { position = [4, 0] }
Q = { position = [4.6, -0.8], mass = 1.0 }
[joints]
string = { type = "distance", points = ["P", "Q"] }
[forces]
breath = { type = "spring", points = ["ground", "Q"], at = [4, -3], stiffness = "9 + 2*sin(4*t)" }
[drivers]
hand = { type = "position", point = "P", value = ["4 + 0.1*sin(2*t)", "0"] }
"""
"""A pendulum on a driven point, with a spring that follows the time."""

LAWS = {
    "driven points, laws of springs": (DRIVEN_POINT, RESTLESS, ("Q.x", "Q.y", "Q.vx", "Q.vy")),
    "bodies on a motor": (MANIPULATOR, FLYING, ("tool.x", "tool.y", "tool.vz", "arm.wx")),
}


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("case", LAWS)
def test_what_the_time_moves_without_a_damper_moves_as_alone(case, order):
    first, second, names = LAWS[case]
    runs = []
    for content in joined(first, second):
        run = Integrator(solver.assemble(solver.loads(json.dumps(content), format="json")))
        run["solver.order"], run["solver.step_size"] = float(order), 0.02
        run.advance(0.0, 1.0)
        runs.append(run)
    undamped, damped, both = runs
    for name in names:
        assert float(both[name]) == pytest.approx(float(undamped[name]), abs=1e-11)
    for account in ("energy.work", "energy.dissipated"):
        total = float(undamped[account]) + float(damped[account])
        assert float(both[account]) == pytest.approx(total, abs=1e-11)
    assert float(both["energy.error"]) < 1e-13
    assert float(both["constraint.position"]) < 1e-13


@pytest.mark.parametrize("order", ORDERS)
def test_a_swing_keeps_its_energy_through_the_hits_of_a_ball(order):
    # Dropped from 1 m with restitution 0.5, the ball hits at T, 2 T, 2.5 T ... (T = sqrt(2/g)).
    content = {**BESIDE_A_BRAKE, "gravity": [0, -10]}
    content["points"] = {**content["points"], "C": {"position": [9, 1], "mass": 1.0}}
    content["forces"] = {
        "well": {"type": "potential", "value": "0.5*A.x**2 + 15*A.y**2 - 10*A.y"},
        "spring": content["forces"]["spring"],
        "brake": content["forces"]["brake"],
    }
    content["contacts"] = {
        "floor": {
            "type": "plane", "point": "C", "position": [0, 0], "axis": [0, 1], "restitution": 0.5,
        }
    }  # fmt: skip
    run = started(assembled(content, order=order, step_size=0.1))
    run.advance(0.0, 0.8)
    time = 0.8 - math.sqrt(0.2)
    assert float(run["C.y"]) == pytest.approx(math.sqrt(20) / 2 * time - 5 * time * time, abs=1e-9)
    assert swings(run) == pytest.approx((0.5, 15.0), abs=1e-12)


def test_directors_of_a_free_body_stay_at_right_angles_beside_a_damped_oscillator():
    # 20,000 steps: each internal step begins with directors of round-off. Without that in the
    # composition they were off by 1.5e-15, growing with the root of the steps.
    content = {
        "name": "spinning_beside_a_brake", "dimension": 3, "gravity": [0, 0, 0],
        "bodies": {
            "top": {
                "position": [5, 0, 0], "mass": 1.0, "inertia": [0.2, 0.3, 0.4],
                "angular_velocity": [1.0, 2.0, 0.5],
            }
        },
        "points": {"B": {"position": [2, 0, 0], "mass": 2.0, "velocity": [0.5, 0, 0]}},
        "forces": {
            "spring": {
                "type": "spring", "points": ["ground", "B"], "at": [0, 0, 0],
                "stiffness": 18.0, "free_length": 1.5,
            },
            "brake": {
                "type": "damper", "points": ["ground", "B"], "at": [0, 0, 0], "damping": 0.02,
            },
        },
    }  # fmt: skip
    run = started(assembled(content, order=8, step_size=0.02))
    worst = 0.0
    for _ in range(100):
        run.advance(run.time, 4.0)
        nodes = np.array(run.state.vectors["q"]).reshape(-1, 3)
        groups = (nodes[k : k + 3] for k in range(len(nodes) - 2))
        worst = max(worst, min(float(abs(D @ D.T - np.eye(3)).max()) for D in groups))
    assert worst < 5e-16


def test_a_rod_tells_its_force_at_the_time_of_the_step_where_covers_of_others_stand_as_pairs():
    # 3 m g sin a of a pendulum of 1 m and 1 kg, let go from the horizontal. Means of pairs err by
    # h^2 F''/8, with F'' = 3 g^2 (cos^2 a - 2 sin^2 a) up to 577 N/s^2. At the times of its stages,
    # taken for those of covers, the mean of a composition was off by 0.24 N.
    h = 0.04
    content = {**BESIDE_A_BRAKE, "gravity": [0, -9.81]}
    content["points"] = {
        "O": {"position": [5, 0], "fixed": True},
        "P": {"position": [6, 0], "mass": 1.0},
        "B": content["points"]["B"],
    }
    content["joints"] = {"rod": {"type": "distance", "points": ["O", "P"]}}
    content["forces"] = {
        "spring": content["forces"]["spring"],
        "brake": {**content["forces"]["brake"], "damping": 5000.0},
    }
    run = started(assembled(content, order=8, step_size=h))
    errors = []
    for _ in range(25):
        run.advance(run.time, h)
        if run["solver.order_in_use"] == 2.0:
            right = float(run["P.vx"]) ** 2 + float(run["P.vy"]) ** 2 - 9.81 * float(run["P.y"])
            errors.append(abs(abs(float(run["rod.force"])) - right))
    assert errors
    assert max(errors) < 577.0 / 8.0 * h * h
