"""The laws of contact in C: values in closed form, and one solver for redundant contacts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.support.contact.contact_laws import HAS_COMPILER, RETREATED, Laws
from tests.support.contact.exact_contacts import impact_by_routh
from tests.support.mechanisms.problems import Array

VALUES = Path(__file__).with_name("impact_values.json")
ROUND_OFF = 1e-14

pytestmark = pytest.mark.skipif(not HAS_COMPILER, reason="no C compiler")


@pytest.fixture(scope="module")
def laws(tmp_path_factory) -> Laws:
    return Laws(tmp_path_factory.mktemp("laws"))


def sets() -> dict[str, dict[str, Any]]:
    return json.loads(VALUES.read_text())["sets"]


@pytest.mark.parametrize("name", sets())
def test_impacts_are_those_of_the_reference(laws, name):
    """Rods, Kane's pendulum, cradles, rocking, boxes, and Painleve's rod: see the file's source."""
    given = sets()[name]
    W, before, tangents = np.array(given["W"]), np.array(given["before"]), given["tangents"]
    for case in given["cases"]:
        mu, e = ([case[word]] * len(tangents) for word in ("coefficient", "restitution"))
        found = laws.impact(W, before, tangents, mu, e)
        assert not found.failed
        assert not found.newton
        assert (found.jam == RETREATED) <= (name == "rod_jam")
        for word in ("after", "impulse", "loss", "compression", "expansion", "friction"):
            assert getattr(found, word) == pytest.approx(case[word], rel=1e-10, abs=1e-10), case


@pytest.mark.parametrize("e", [0.0, 0.4, 0.9, 1.0])
@pytest.mark.parametrize("mu", [0.0, 1e-9, 0.1, 0.3, 0.5, 1.0])
def test_one_contact_in_the_plane_follows_rouths_path(laws, mu, e):
    """The rod of 0.5 rad, whose slip stops and goes back or sticks."""
    arm = 0.5 * np.array([np.cos(0.5), np.sin(0.5)])
    G = np.array([[0.0, 1.0, -arm[0]], [1.0, 0.0, arm[1]]])
    W, before = (G / [1.0, 1.0, 1.0 / 12.0]) @ G.T, np.array([-2.2, 1.0])
    p, after = impact_by_routh(W, before, mu, e)
    found = laws.impact(W, before, [1], [mu], [e])
    assert found.impulse == pytest.approx(p, rel=1e-13, abs=1e-14)
    assert found.after == pytest.approx(after, rel=1e-13, abs=1e-14)


# ------------------------------------------------------------------------------------- closed forms


@pytest.mark.parametrize("e", [0.0, 0.3, 1.0])
def test_a_ball_leaves_with_restitution_times_its_speed(laws, e):
    found = laws.impact(np.eye(1) / 2.0, np.array([-3.0]), [0], [0.0], [e])
    assert not found.failed
    assert found.impulse == pytest.approx([(1 + e) * 6.0], rel=ROUND_OFF)
    assert found.after == pytest.approx([e * 3.0], rel=ROUND_OFF)
    assert found.loss == pytest.approx((1 - e**2) * 9.0, rel=ROUND_OFF)


def test_a_ball_that_leaves_feels_nothing(laws):
    found = laws.impact(np.eye(1), np.array([0.5]), [0], [0.0], [0.8])
    assert not found.failed
    assert (found.impulse, found.after) == ([0.0], [0.5])


@pytest.mark.parametrize("slip", [-2.0, 2.0])
@pytest.mark.parametrize("coefficient", [0.2, 0.8])
def test_a_disc_slides_or_sticks_on_a_floor(laws, slip, coefficient):
    """Slip v + r omega; the mass that resists it is a third of a disc's."""
    W = np.diag([1.0, 3.0]) / 2.0
    found = laws.impact(W, np.array([-1.0, slip]), [1], [coefficient], [0.5])
    p_N = 2.0 * 1.5
    p_T = -np.sign(slip) * min(coefficient * p_N, 2.0 * abs(slip) / 3.0)
    assert found.impulse == pytest.approx([p_N, p_T], rel=ROUND_OFF)
    if coefficient == 0.8:
        assert abs(found.after[1]) <= ROUND_OFF * abs(slip)


@pytest.mark.parametrize("coefficient", [0.1, 0.9])
def test_a_sphere_slides_or_sticks_in_any_direction(laws, coefficient):
    """Two sevenths of a sphere's mass resist its slip, whatever the direction."""
    slip = np.array([3.0, -4.0]) / 5.0
    W = np.diag([1.0, 3.5, 3.5])
    found = laws.impact(W, np.array([-1.0, *slip]), [2], [coefficient], [0.0])
    assert found.impulse == pytest.approx(
        [1.0, *(-slip * min(coefficient, 2.0 / 7.0))], rel=ROUND_OFF
    )


def test_a_flat_rod_sticks_at_both_ends(laws):
    """One motion, two rows of slip: W is singular, and its friction is shared by both ends."""
    G = np.array([[0, 1, -0.5], [1, 0, 0], [0, 1, 0.5], [1, 0, 0]])
    v, M = np.array([0.2, -1.0, 0.1]), np.array([1.0, 1.0, 1.0 / 12.0])
    found = laws.impact((G / M) @ G.T, G @ v, [1, 1], [0.25] * 2, [0.0] * 2)
    assert not found.failed
    assert np.abs(found.after).max() <= ROUND_OFF
    assert found.loss == pytest.approx(0.5 * (M * v) @ v, rel=ROUND_OFF)


def table(coefficient: float, laws: Laws) -> tuple[Array, Array, Array]:
    """Return what a table on four legs has after its impact: 12 rows, 6 motions."""
    legs = [(x, y, -0.4) for x in (-0.5, 0.5) for y in (-0.3, 0.3)]
    axes = ((0, 0, 1), (1, 0, 0), (0, 1, 0))
    G = np.array([[*axis, *np.cross(leg, axis)] for leg in legs for axis in axes], float)
    M = np.array([3.0, 3.0, 3.0, 0.4, 0.5, 0.6])
    v = np.array([0.3, -0.4, -1.0, 0.0, 0.0, 0.0])
    found = laws.impact((G / M) @ G.T, G @ v, [2] * 4, [coefficient] * 4, [0.0] * 4)
    assert not found.failed
    return v + G.T @ found.impulse / M, found.impulse, found.after


def test_a_table_of_four_legs_sticks(laws):
    assert np.abs(table(0.7, laws)[0]).max() <= 2 * ROUND_OFF


def test_a_table_of_four_legs_slides_with_friction_by_its_weight(laws):
    """No leg leaves the floor: the friction is that of the whole momentum."""
    v, p, after = table(0.1, laws)
    assert np.abs(after[::3]).max() <= 1e-13
    assert p[::3].sum() == pytest.approx(3.0, rel=1e-13)
    assert v[:2] == pytest.approx(np.array([0.3, -0.4]) * (1.0 - 0.1 / 0.5), rel=1e-12)


def test_redundant_legs_share_in_one_way_whatever_their_units(laws):
    """A box falls flat and straight on four corners, two of them measured in mm."""
    corners = [(x, y, -0.1) for x in (-0.2, 0.2) for y in (-0.1, 0.1)]
    G = np.array([[0, 0, 1, *np.cross(c, (0, 0, 1))] for c in corners], float)
    M = np.array([1.0, 1.0, 1.0, 0.01, 0.02, 0.03])
    unit = np.array([1.0, 1000.0, 1.0, 1000.0])
    rows = unit[:, None] * G
    found = laws.impact((rows / M) @ rows.T, rows @ np.array([0, 0, -1.0, 0, 0, 0]),
                        [0] * 4, [0.0] * 4, [0.5] * 4)  # fmt: skip
    assert found.impulse * unit == pytest.approx([0.375] * 4, rel=1e-12)


def test_drivers_that_push_parts_into_each_other_fail(laws):
    """W = 0: no impulse parts them; nor does one arise where they part by themselves."""
    W = np.zeros((1, 1))
    assert not laws.impact(W, np.ones(1), [0], [0.0], [0.5]).failed
    assert laws.impact(W, -np.ones(1), [0], [0.0], [0.5]).failed


def test_what_is_not_a_number_fails(laws):
    assert laws.impact(np.eye(1), np.array([np.nan]), [0], [0.0], [0.5]).failed


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_long_row_of_touching_balls_gives_back_what_it_has_taken(laws, e):
    chance, n = np.random.default_rng(7), 40
    G = np.diff(np.eye(n), axis=0)
    for _ in range(10):
        M, v = 10.0 ** chance.uniform(-1, 1, n), chance.standard_normal(n)
        found = laws.impact((G / M) @ G.T, G @ v, [0] * (n - 1), [0.0] * (n - 1), [e] * (n - 1))
        assert not found.failed
        energy = float(0.5 * (M * v) @ v)
        assert found.impulse.min() >= 0.0
        assert found.after.min() >= -1e-12
        assert found.loss == pytest.approx((1 - e**2) * found.compression.sum(), abs=1e-12 * energy)


# ------------------------------------------------------------------------------- the solver alone


def far_apart(seed: int) -> list[tuple[Array, Array, list[int], Array]]:
    """Return problems of masses far apart and strong friction, with up to five contacts."""
    chance, found = np.random.default_rng(seed), []
    for _ in range(2000):
        count, size = chance.integers(2, 6), chance.integers(4, 8)
        tangents = chance.integers(0, 3, count).tolist()
        A = chance.standard_normal((size, size)) * 10.0 ** chance.uniform(-1, 1, size)
        M = A @ A.T + np.diag(10.0 ** chance.uniform(-1, 1, size))
        G = chance.standard_normal((sum(tangents) + count, size))
        W = G @ np.linalg.solve(M, G.T)
        v = chance.standard_normal(size)
        found.append((0.5 * (W + W.T), G @ v, tangents, chance.choice([0.3, 1.0, 2.0], count)))
    return found


@pytest.mark.parametrize("seed", [2, 3])
def test_masses_far_apart_and_strong_friction_obey_the_law(laws, seed):
    for W, b, tangents, mu in far_apart(seed):
        failed, p, rate, _ = laws.contacts(W, b, tangents, mu)
        assert not failed
        size, k = np.abs(b) + np.abs(W) @ np.abs(p), 0
        for n, c in zip(tangents, mu, strict=True):
            assert p[k] >= 0.0
            assert rate[k] >= -1e-9 * size[k]
            assert p[k] == 0.0 or rate[k] <= 1e-9 * size[k]
            force, slip = p[k + 1 : k + 1 + n], rate[k + 1 : k + 1 + n]
            assert np.linalg.norm(force) <= c * p[k] * (1 + 1e-10)
            small = 2e-9 * size[k + 1 : k + 1 + n].sum()
            if np.linalg.norm(slip) > small and p[k]:
                against = np.linalg.norm(slip) * force + c * p[k] * slip
                assert np.linalg.norm(against) <= small * c * p[k]
            k += 1 + n


@pytest.mark.parametrize("seed", range(3))
def test_one_contact_in_space_has_impulses_whatever_its_friction(laws, seed):
    """Symmetric, positive W: a contact without slip parts, sticks, or slides against friction."""
    random = np.random.default_rng(seed)
    for _ in range(300):
        A = random.normal(size=(3, 3))
        W, mu = A @ A.T, 10.0 ** random.uniform(1.5, 3.0)
        b = random.normal(size=3) * np.sqrt(np.diag(W))
        failed, p, rate, _ = laws.contacts(W, b, [2], [mu])
        assert not failed
        # Defects of 1e-12 of the rates count as none; round-off is that of the sums W p.
        none = 1e-11 * np.abs(b).max() + 1e-14 * (np.abs(W) @ np.abs(p)).max()
        assert rate == pytest.approx(b + W @ p, abs=none)
        assert p[0] >= 0.0
        assert rate[0] >= -none
        assert rate[0] <= none or p[0] == 0.0
        held, slip = float(np.linalg.norm(p[1:])), float(np.linalg.norm(rate[1:]))
        assert held <= mu * p[0] * (1.0 + 1e-11)
        if p[0] > 0.0 and slip > 10.0 * none:  # friction is all of it, against the slip
            most = held * (1e-9 + none / slip)
            assert p[1:] == pytest.approx(-mu * p[0] * rate[1:] / slip, abs=most)


def test_of_several_solutions_the_one_of_least_work_counts(laws):
    """Of Painleve's rod, which may push or part."""
    W = np.array([[1.0, 2.0], [2.0, 5.0]])
    b, way = np.array([0.1, 0.0]), np.array([0.0, 1.0])
    least = laws.contacts(W, b, [1], [1.0], [1], way)
    most = laws.contacts(W, b, [1], [1.0], [1], way, wanted=1)
    assert least[1].tolist() == [0.0, 0.0]
    assert most[1] == pytest.approx([0.1, -0.1], rel=1e-13)  # (1 - 2) p_N + 0.1 = 0


@pytest.mark.parametrize(("load", "holds"), [(1.0, True), (-1.0, False), (np.nan, False)])
def test_a_contact_holds_what_presses_it_and_no_load_that_is_not_a_number(laws, load, holds):
    assert laws.holds(load) == holds
