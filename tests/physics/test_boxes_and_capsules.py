"""Boxes that hit, rock and roll on capsules and balls, against closed forms and quadrature."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

from tests.physics.test_bodies_with_shapes import run, vector
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism


@pytest.mark.parametrize("restitution", [1.0, 0.5, 0.0])
@pytest.mark.parametrize("ends", [[[0, 0, 0]], [[-0.4, 0, 0], [0.4, 0, 0]]])
def test_a_ball_and_a_lying_rod_hit_a_box_as_two_masses_do(restitution, ends):
    """Speeds (m - e M) u/(m + M) and (1 + e) m u/(m + M); lost is (1 - e^2) m M/(m + M) u^2/2."""
    m, M, u = 1.0, 3.0, 2.0
    contact = {
        "type": "box", "bodies": ["crate", "rod"], "sizes": [[1, 1, 0.5]], "segment": ends,
        "radii": [0, 0.1], "restitution": restitution, "friction": 0.3,
    }  # fmt: skip
    bodies = {
        "crate": {"mass": M, "inertia": [0.4, 0.4, 0.6], "position": [0, 0, 0]},
        "rod": {"mass": m, "inertia": [0.1] * 3, "position": [0, 0, 0.45], "velocity": [0, 0, -u]},
    }
    content = mechanism("hit", 3, gravity=False, bodies=bodies, contacts={"c": contact})
    ran = run(content, 0.2, h=0.01)
    after = [-(m - restitution * M) * u / (m + M), -(1.0 + restitution) * m * u / (m + M)]
    assert [ran["rod.vz"], ran["crate.vz"]] == pytest.approx(after, abs=1e-12)
    lost = 0.5 * (1.0 - restitution**2) * m * M / (m + M) * u * u
    assert ran["energy.impact"] == pytest.approx(lost, abs=1e-12)
    assert vector(ran, "rod.w") == pytest.approx([0, 0, 0], abs=1e-12)


@pytest.mark.parametrize("dim", [2, 3])
def test_a_ball_slides_off_the_edge_of_a_table_and_leaves_it_where_its_weight_gives_way(dim):
    """v^2 = v0^2 + 2 g R (1 - cos) and v^2 = g R cos of the angle at which it leaves the edge."""
    radius, speed = 0.1, 0.3
    cosine = (2.0 + speed**2 / (GRAVITY * radius)) / 3.0
    size = [1.0] * dim
    place, velocity = [0.4] + [0.0] * (dim - 1), [speed] + [0.0] * (dim - 1)
    place[-1] = 0.5 + radius
    contact = {
        "type": "box", "bodies": ["ground", "ball"], "sizes": [size], "segment": [[0.0] * dim],
        "radii": [0, radius],
    }  # fmt: skip
    ball = {
        "mass": 0.7, "inertia": [0.01] * 3 if dim == 3 else 0.01, "position": place,
        "velocity": velocity,
    }  # fmt: skip
    content = mechanism("table", dim, bodies={"ball": ball}, contacts={"c": contact})
    ran = run(content, 0.7, h=0.002, order=4)
    assert ran["c.mode"] == 0.0
    assert float(ran["c.gap"]) > 0.02
    assert ran["ball.vx"] == pytest.approx(math.sqrt(GRAVITY * radius * cosine) * cosine, rel=1e-7)


def board(dim: int) -> tuple[Content, float]:
    """A board, tilted, that rocks on a round beam without slip; and a quarter of its period.

    Its middle plane is b above the place that touches, which is r phi from its centre:
    T = (J + m (b^2 + r^2 phi^2)) phi'^2/2,  V = m g ((r + b) cos phi + r phi sin phi).
    """
    r, half, mass, tilt = (
        0.3,
        np.array([0.8, 0.2, 0.05])[[0, 1, 2] if dim == 3 else [0, 2]],
        4.0,
        0.3,
    )
    b = half[-1]
    inertia = mass / 3.0 * (half[0] ** 2 + b**2)

    def height(phi: float) -> float:
        return (r + b) * math.cos(phi) + r * phi * math.sin(phi)

    def slowness(turn: float) -> float:
        """Of phi = tilt cos(turn), d phi/(phi' sin): smooth up to both ends."""
        phi = tilt * math.cos(turn)
        energy = 2.0 * mass * GRAVITY * (height(tilt) - height(phi))
        speed = math.sqrt(energy / (inertia + mass * (b * b + (r * phi) ** 2)))
        return tilt * math.sin(turn) / speed

    quarter = quad(slowness, 1e-6, math.pi / 2, epsabs=1e-12)[0]
    quarter += 1e-6 * slowness(1e-3)
    c, s = math.cos(tilt), math.sin(tilt)
    centre = [-(r + b) * s + r * tilt * c, (r + b) * c + r * tilt * s]
    long = {"mass": mass, "inertia": inertia, "position": centre, "orientation": tilt}
    ends: list[list[float]] = [[0.0, 0.0]]
    if dim == 3:
        own = mass / 3.0 * np.array([half[1] ** 2 + b**2, inertia * 3.0 / mass, half @ half - b**2])
        long |= {
            "inertia": own.tolist(), "position": [centre[0], 0.0, centre[1]],
            "orientation": {"axis": [0, -1, 0], "angle": tilt},
        }  # fmt: skip
        ends = [[0, -1, 0], [0, 1, 0]]
    contact = {
        "type": "box", "bodies": ["board", "ground"], "sizes": [(2.0 * half).tolist()],
        "segment": ends, "radii": [0, r], "friction": 3.0,
    }  # fmt: skip
    return mechanism("board", dim, bodies={"board": long}, contacts={"c": contact}), quarter


@pytest.mark.parametrize("dim", [2, 3])
def test_a_board_rocks_on_a_round_beam_with_its_exact_period(dim):
    """In space the beam crosses two edges of the board, which carry it together."""
    content, quarter = board(dim)
    ran = run(content, quarter, h=0.005, order=4)
    across = ran["board.angle"] if dim == 2 else ran["board.qy"]
    assert across == pytest.approx(0.0, abs=2e-6)
    assert ran["board.x"] == pytest.approx(0.0, abs=1e-6)
    assert ran["energy.dissipated"] == pytest.approx(0.0, abs=1e-11)


def test_the_slip_of_a_ball_has_a_direction_on_each_face_of_a_box():
    """Also on the face against that on which it is drawn: it comes there as the box turns over."""
    contact = {
        "type": "box", "bodies": ["crate", "ball"], "sizes": [[1, 1, 1]], "segment": [[0, 0, 0]],
        "radii": [0, 0.1], "friction": 0.2,
    }  # fmt: skip
    bodies = {
        "crate": {
            "mass": 5.0, "inertia": [1.0] * 3, "position": [0, 0, 0],
            "angular_velocity": [0, math.pi, 0],
        },
        "ball": {
            "mass": 1.0, "inertia": [0.004] * 3, "position": [0, 0.1, 2.6],
            "velocity": [0, 0, -2.0],
        },
    }  # fmt: skip
    content = mechanism("turns", 3, gravity=False, bodies=bodies, contacts={"c": contact})
    ran = run(content, 1.1, h=0.01)
    assert ran["c.impacts"] == 1.0
    assert float(ran["energy.impact"]) > 0.0
    assert float(ran["crate.wy"]) < math.pi
