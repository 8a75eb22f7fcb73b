"""An impact obeys Newton's restitution and Coulomb's cone, and no restitution creates energy."""

from __future__ import annotations

import ctypes
import itertools
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from build_kernel.compiler import FLAGS, system_compiler, zig_compiler
from tests.problems import Array

SHIM = Path(__file__).parents[1] / "impact_law.c"
KERNEL = Path(__file__).parents[2] / "solver" / "kernel"
STRICT = ["-Werror", "-Wshadow", "-Wcast-qual", "-Wconversion", "-Wno-sign-conversion"]
PARTED, CLOSED, STICKS = range(3)
ROUND_OFF = 1e-14

pytestmark = pytest.mark.skipif(not (system_compiler() or zig_compiler()), reason="no C compiler")


class CImpact(ctypes.Structure):
    """What `hm_impact` is in C."""

    _fields_ = [
        *((name, ctypes.c_int32) for name in ("contacts", "rows")),
        *(
            (name, ctypes.c_void_p)
            for name in (
                *("first", "tangents", "coefficient", "restitution", "W", "before"),
                *("impulse", "after", "status", "scratch"),
            )
        ),
    ]


@dataclass(frozen=True)
class Problem:
    """Contacts of a mechanism with masses M that moves with velocities v; rows of G in contacts."""

    M: Array
    G: Array
    v: Array
    tangents: list[int]
    coefficient: list[float]
    restitution: list[float]

    @property
    def first(self) -> list[int]:
        """Normal row of each contact."""
        return [0, *np.cumsum(np.add(self.tangents, 1))[:-1].tolist()]

    @property
    def W(self) -> Array:  # noqa: N802
        W = self.G @ np.linalg.solve(self.M, self.G.T)
        return 0.5 * (W + W.T)

    @property
    def before(self) -> Array:
        return self.G @ self.v


@dataclass(frozen=True)
class Solution:
    failed: int
    impulse: Array
    after: Array
    status: list[int]
    restitution: Array
    velocity: Array
    loss: float
    size: Array
    """Of each row: sum of the sizes of the terms of gamma- + W p."""


@pytest.fixture(scope="module")
def library(tmp_path_factory) -> ctypes.CDLL:
    """Return the law as this machine's compiler makes it, without a warning."""
    target = tmp_path_factory.mktemp("impact") / "impact.so"
    compiler = system_compiler() or zig_compiler() or ["cc"]
    options = [*FLAGS, *STRICT, "-DDIM=3", f"-I{KERNEL}"]
    command = [*compiler, *options, "-o", str(target), str(SHIM), "-lm"]
    subprocess.run(command, check=True)
    loaded = ctypes.CDLL(str(target))
    loaded.impact_scratch.restype = ctypes.c_int64
    return loaded


@pytest.fixture(scope="module")
def solve(library) -> Callable[[Problem], Solution]:
    def solved(problem: Problem) -> Solution:
        n, W, before = len(problem.G), problem.W, problem.before
        array = {
            "first": np.array(problem.first, np.int32),
            "tangents": np.array(problem.tangents, np.int32),
            "coefficient": np.array(problem.coefficient, float),
            "restitution": np.array(problem.restitution, float),
            "W": W,
            "before": before,
            "impulse": np.full(n, np.nan),
            "after": np.full(n, np.nan),
            "status": np.full(len(problem.tangents), -1, np.int32),
            "scratch": np.full(library.impact_scratch(n), np.nan),
        }
        address = {name: np.ascontiguousarray(value) for name, value in array.items()}
        x = CImpact(
            contacts=len(problem.tangents),
            rows=n,
            **{name: value.ctypes.data for name, value in address.items()},
        )
        failed = library.solve_impact(ctypes.byref(x))
        p, after = address["impulse"], address["after"]
        return Solution(
            failed=failed,
            impulse=p,
            after=after,
            status=address["status"].tolist(),
            restitution=address["restitution"],
            velocity=problem.v + np.linalg.solve(problem.M, problem.G.T @ p),
            loss=float(-p @ (before + after) / 2),
            size=np.abs(before) + np.abs(W) @ np.abs(p),
        )

    return solved


def by_statuses(problem: Problem, e: Array | list[float]) -> Iterator[Array]:
    """Impulses of a problem in the plane: of each combination of statuses that fits the law."""
    W, before = problem.W, problem.before
    for chosen in itertools.product(
        *(["open", "+", "-", "sticks"] if n else ["open", "0"] for n in problem.tangents)
    ):
        A, b = np.eye(len(W)), np.zeros(len(W))
        for i, k in enumerate(problem.first):
            if chosen[i] == "open":
                continue
            A[k], b[k] = W[k], -(1 + e[i]) * before[k]
            if chosen[i] == "sticks":
                A[k + 1], b[k + 1] = W[k + 1], -before[k + 1]
            elif chosen[i] in ("+", "-"):
                A[k + 1, k] = problem.coefficient[i] * float(chosen[i] + "1")
        if np.linalg.cond(A) > 1e10:
            continue
        p = np.linalg.solve(A, b)
        after = before + W @ p
        small = 1e-10 * (np.abs(before) + np.abs(W) @ np.abs(p))
        fits = True
        for i, k in enumerate(problem.first):
            fits &= p[k] * W[k, k] >= -small[k] and after[k] + e[i] * before[k] >= -small[k]
            if chosen[i] == "sticks":
                fits &= abs(p[k + 1]) <= problem.coefficient[i] * p[k] * (1 + 1e-10)
            elif chosen[i] in ("+", "-"):
                fits &= after[k + 1] * float(chosen[i] + "1") >= -small[k + 1]
        if fits:
            yield p


# ------------------------------------------------------------------------------------- closed forms


@pytest.mark.parametrize("e", [0.0, 0.3, 1.0])
def test_a_ball_leaves_with_restitution_times_its_speed(solve, e):
    found = solve(Problem(np.eye(1) * 2.0, np.eye(1), np.array([-3.0]), [0], [0.0], [e]))
    assert not found.failed
    assert found.impulse == pytest.approx([(1 + e) * 6.0], rel=ROUND_OFF)
    assert found.after == pytest.approx([e * 3.0], rel=ROUND_OFF)
    assert found.loss == pytest.approx((1 - e**2) * 9.0, rel=ROUND_OFF)
    assert found.status == [CLOSED]


def test_a_ball_that_leaves_feels_nothing(solve):
    found = solve(Problem(np.eye(1), np.eye(1), np.array([0.5]), [0], [0.0], [0.8]))
    assert not found.failed
    assert (found.impulse, found.after, found.status) == ([0.0], [0.5], [PARTED])


@pytest.mark.parametrize("slip", [-2.0, 2.0])
@pytest.mark.parametrize(("coefficient", "status"), [(0.2, CLOSED), (0.8, STICKS)])
def test_a_disc_slides_or_sticks_on_a_floor(solve, slip, coefficient, status):
    """Slip v + r omega; the mass that resists it is a third of a disc's."""
    disc = np.diag([2.0, 2.0, 0.25])  # m, m, m r^2/2 with r = 0.5
    G = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.5]])
    v = np.array([slip, -1.0, 0.0])
    found = solve(Problem(disc, G, v, [1], [coefficient], [0.5]))
    p_N = 2.0 * 1.5
    p_T = -np.sign(slip) * min(coefficient * p_N, 2.0 * abs(slip) / 3.0)
    assert not found.failed
    assert found.status == [status]
    assert found.impulse == pytest.approx([p_N, p_T], rel=ROUND_OFF)
    if status == STICKS:
        assert abs(found.after[1]) <= ROUND_OFF * abs(slip)


@pytest.mark.parametrize(("coefficient", "status"), [(0.1, CLOSED), (0.9, STICKS)])
def test_a_sphere_slides_or_sticks_in_any_direction(solve, coefficient, status):
    """Two sevenths of a sphere's mass resist its slip, whatever the direction."""
    mass = np.diag([1.0, 2.0 / 7.0, 2.0 / 7.0])
    slip = np.array([3.0, -4.0]) / 5.0
    v = np.array([-1.0, *slip])
    found = solve(Problem(mass, np.eye(3), v, [2], [coefficient], [0.0]))
    p_T = -slip * min(coefficient, 2.0 / 7.0)
    assert not found.failed
    assert found.status == [status]
    assert found.impulse == pytest.approx([1.0, *p_T], rel=ROUND_OFF)


def test_a_flat_rod_sticks_at_both_ends(solve):
    """One motion, two rows of slip: W is singular, and its friction is shared by both ends."""
    rod = np.diag([1.0, 1.0, 1.0 / 12.0])
    G = np.array([[0, 1, -0.5], [1, 0, 0], [0, 1, 0.5], [1, 0, 0]])
    found = solve(Problem(rod, G, np.array([0.2, -1.0, 0.1]), [1, 1], [0.25] * 2, [0.0] * 2))
    assert not found.failed
    assert found.status == [STICKS] * 2
    assert np.abs(found.velocity).max() <= ROUND_OFF
    assert found.loss == pytest.approx(0.5 * (0.2**2 + 1.0 + 0.1**2 / 12.0), rel=ROUND_OFF)


@pytest.mark.parametrize(("coefficient", "status"), [(0.1, CLOSED), (0.7, STICKS)])
def test_a_table_lands_on_four_legs(solve, coefficient, status):
    """12 rows, 6 motions."""
    legs = [(x, y, -0.4) for x in (-0.5, 0.5) for y in (-0.3, 0.3)]
    rows = [
        [*axis, *np.cross(leg, axis)] for leg in legs for axis in ((0, 0, 1), (1, 0, 0), (0, 1, 0))
    ]
    table = Problem(
        np.diag([3.0, 3.0, 3.0, 0.4, 0.5, 0.6]),
        np.array(rows, float),
        np.array([0.3, -0.4, -1.0, 0.0, 0.0, 0.0]),
        [2] * 4,
        [coefficient] * 4,
        [0.0] * 4,
    )
    found = solve(table)
    assert not found.failed
    if status == STICKS:
        assert found.status == [STICKS] * 4
        assert np.abs(found.velocity).max() <= 2 * ROUND_OFF
    obeys(table, found)


def test_restitution_that_would_create_energy_is_halved(solve):
    """Kane and Levinson's effect: the coupling of normal and slip feeds one from the other."""
    M, v = np.linalg.inv([[1.0, 0.9], [0.9, 1.0]]), np.array([-1.0, -1.0])
    problem = Problem(M, np.eye(2), v, [1], [1.0], [1.0])
    losses = {
        e: [-p @ (2 * problem.before + problem.W @ p) / 2 for p in by_statuses(problem, [e])]
        for e in (1.0, 0.5, 0.25)
    }
    assert max(losses[1.0]) < 0.0
    assert max(losses[0.5]) < 0.0
    found = solve(problem)
    assert not found.failed
    assert found.restitution == [0.25]
    assert [found.loss] == pytest.approx(losses[0.25], rel=1e-12)
    assert found.loss > 0.0
    obeys(problem, found)


def test_drivers_that_push_parts_into_each_other_fail(solve):
    """W = 0: no impulse parts them; nor does one arise where they part by themselves."""
    problem = Problem(np.eye(1), np.zeros((1, 1)), np.ones(1), [0], [0.0], [0.5])
    assert not solve(problem).failed
    heavy = Problem(np.eye(1) * 1e200, np.eye(1) * 1e-100, -np.ones(1) * 1e100, [0], [0.0], [0.5])
    assert heavy.W == 0.0
    assert heavy.before == -1.0
    assert solve(heavy).failed


def test_what_is_not_a_number_fails(solve):
    assert solve(Problem(np.eye(1), np.eye(1), np.array([np.nan]), [0], [0.0], [0.5])).failed


# --------------------------------------------------------------------------------------- properties


def obeys(problem: Problem, found: Solution, round_off: float = 1e-12) -> None:
    """Check every line of the law."""
    before, p, after, size = problem.before, found.impulse, found.after, found.size
    assert np.abs(after - before - problem.W @ p).max() <= ROUND_OFF * size.max()
    assert np.abs(after - problem.G @ found.velocity).max() <= round_off * size.max()
    assert found.loss >= -round_off * np.abs(p) @ size
    for i, k in enumerate(problem.first):
        excess, status = after[k] + found.restitution[i] * before[k], found.status[i]
        assert p[k] >= 0.0
        assert excess >= -round_off * size[k]
        assert abs(excess) <= round_off * size[k] or p[k] == 0.0
        assert (status == PARTED) <= (p[k] == 0.0)
        tangents = slice(k + 1, k + 1 + problem.tangents[i])
        p_T, slip = p[tangents], after[tangents]
        limit, small = problem.coefficient[i] * p[k], round_off * size[tangents].sum()
        assert np.linalg.norm(p_T) <= limit * (1 + 1e-11)
        if status == STICKS:
            assert np.linalg.norm(slip) <= small
        elif status == CLOSED and limit:
            assert np.linalg.norm(np.linalg.norm(slip) * p_T + limit * slip) <= 2 * small * limit


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_long_row_of_touching_balls_obeys_the_law(solve, e):
    """Where the guess has not seen the far end of a row, contacts change until all agree."""
    chance, n = np.random.default_rng(7), 40
    M, G = np.diag(10.0 ** chance.uniform(-1, 1, n)), np.diff(np.eye(n), axis=0)
    for _ in range(10):
        row = Problem(
            M, G, chance.standard_normal(n), [0] * (n - 1), [0.0] * (n - 1), [e] * (n - 1)
        )
        found = solve(row)
        assert not found.failed
        obeys(row, found)


def far_apart() -> list[Problem]:
    """Return problems of masses far apart and strong friction."""
    chance, found = np.random.default_rng(2), []
    for _ in range(2000):
        count, size = chance.integers(2, 6), chance.integers(4, 8)
        tangents = chance.integers(0, 3, count).tolist()
        A = chance.standard_normal((size, size)) * 10.0 ** chance.uniform(-1, 1, size)
        problem = Problem(
            A @ A.T + np.diag(10.0 ** chance.uniform(-1, 1, size)),
            chance.standard_normal((sum(tangents) + count, size)),
            chance.standard_normal(size),
            tangents,
            chance.choice([0.3, 1.0, 2.0], count).tolist(),
            [0.0] * count,
        )
        found.append(problem)
    return found


def test_masses_far_apart_and_strong_friction_obey_the_law(solve):
    """Guesses are poor, and with two problems of the 2000 changes of all at once go in circles."""
    for problem in far_apart():
        found = solve(problem)
        assert not found.failed
        obeys(problem, found, 1e-10)


def test_the_last_digit_of_a_mass_does_not_decide_whether_impulses_are_found(solve):
    """Five contacts of four freedoms: changes of all and of one went in circles with 44 of 100."""
    chance, problem = np.random.default_rng(0), far_apart()[509]
    for _ in range(100):
        other = replace(problem, M=problem.M * (1.0 + 1e-15 * chance.standard_normal()))
        found = solve(other)
        assert not found.failed
        obeys(other, found, 1e-10)


def problems(most_tangents: int = 2, most_contacts: int = 5) -> st.SearchStrategy[Problem]:
    """Draw sizes and numbers; a part of the contacts are others again, and so depend on them."""

    @st.composite
    def draw(pick: st.DrawFn) -> Problem:
        count, size = pick(st.integers(1, most_contacts)), pick(st.integers(1, 7))
        tangents = pick(st.lists(st.integers(0, most_tangents), min_size=count, max_size=count))
        chance = np.random.default_rng(pick(st.integers(0, 2**32)))
        rows = [chance.standard_normal((1 + n, size)) for n in tangents]
        if pick(st.booleans()):
            for i in range(1, count):
                shared = min(len(rows[i]), len(rows[0]))
                rows[i][:shared] = rows[0][:shared]
        A = chance.standard_normal((size, size))
        each = st.lists(st.sampled_from([0.0, 0.3, 0.8, 1.0]), min_size=count, max_size=count)
        friction = st.lists(st.sampled_from([0.0, 0.1, 0.5]), min_size=count, max_size=count)
        return Problem(
            M=A @ A.T + np.eye(size),
            G=np.concatenate(rows),
            v=chance.standard_normal(size),
            tangents=tangents,
            coefficient=pick(friction),
            restitution=pick(each),
        )

    return draw()


@settings(max_examples=500, deadline=None)
@given(problem=problems())
def test_random_impacts_obey_the_law(solve, problem):
    found = solve(problem)
    assert not found.failed
    obeys(problem, found)


@settings(max_examples=200, deadline=None)
@given(problem=problems(most_tangents=1, most_contacts=3))
def test_impulses_in_the_plane_are_among_those_of_all_statuses(solve, problem):
    found = solve(problem)
    assert not found.failed
    others = list(by_statuses(problem, found.restitution))
    if np.linalg.matrix_rank(problem.G) == len(problem.G):
        rates = [np.abs(problem.W @ (p - found.impulse)).max() for p in others]
        assert min(rates) <= 1e-9 * found.size.max()


@settings(max_examples=200, deadline=None)
@given(problem=problems())
def test_restitution_is_lowered_for_all_alike_or_for_none(solve, problem):
    e, found = np.array(problem.restitution), solve(problem)
    halvings = [e * 0.5**k for k in range(12)]
    lowered = [np.where(h < 1e-3, 0.0, h) for h in halvings]
    assert any(np.array_equal(found.restitution, h) for h in lowered)
