"""What sections 2 and 3 of García Orden and Ortega say, on constraints that are no quadratics.

The printed equations are written here a second time and must be met by each step. Motions are
compared with closed forms and with equations in one coordinate.
"""

from __future__ import annotations

import math
from itertools import islice, pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from solver.paper import FORMULATIONS, Functions, Method, Moment, Problem, motion
from solver.runtime import StepError
from tests.support.mechanisms.exact_motions import pendulum_angle, pendulum_multiplier
from tests.support.mechanisms.problems import GRAVITY, Array, observed_order

CONSERVING = [name for name in FORMULATIONS if name.startswith("conserving")]
AUGMENTED = [name for name in FORMULATIONS if "-al" in name]


def weights(masses: Array) -> Functions:
    """Energy m g y of points in the plane."""
    slope = GRAVITY * np.kron(masses, [0.0, 1.0])[None]
    return Functions(lambda q: slope @ q, lambda _: slope)


def pendulum(angle: float, rate: float = 0.0) -> Problem:
    """Unit point on a unit rod."""
    s, c = math.sin(angle), math.cos(angle)
    rod = Functions(lambda q: np.array([q @ q - 1.0]), lambda q: 2.0 * q[None])
    q, v = np.array([s, -c]), rate * np.array([c, s])
    return Problem(M=np.eye(2), q=q, v=v, phi=rod, potentials=weights(np.ones(1)))


def bead_on_a_cubic(speed: float = 0.0) -> Problem:
    """Bead of 2 kg in the hollow of y = x^3 - x, at rest at x = 1.1 or passing there."""
    curve = Functions(
        lambda q: np.array([q[1] - q[0] ** 3 + q[0]]),
        lambda q: np.array([[1.0 - 3.0 * q[0] ** 2, 1.0]]),
    )
    x = 1.1
    q, along = np.array([x, x**3 - x]), np.array([1.0, 3.0 * x**2 - 1.0])
    v = speed * along / np.linalg.norm(along)
    return Problem(M=2.0 * np.eye(2), q=q, v=v, phi=curve, potentials=weights(np.array([2.0])))


def two_on_curves() -> Problem:
    """Two beads without weight on a sine and a cubic, joined by a rod: three rows, one freedom."""

    def phi(q: Array) -> Array:
        x, y, u, w = q
        return np.array([y - np.sin(x), w - 2.0 - 0.1 * u**3, np.hypot(x - u, y - w) - 2.0])

    def phi_q(q: Array) -> Array:
        x, y, u, w = q
        r = np.array([x - u, y - w]) / np.hypot(x - u, y - w)
        return np.array([[-np.cos(x), 1, 0, 0], [0, 0, -0.3 * u**2, 1], [*r, *-r]])

    q = np.array([0.0, 0.0, 0.0, 2.0])
    v = np.array([1.0, 1.0, 1.0, 0.0])
    G = phi_q(q)
    v = v - np.linalg.pinv(G) @ G @ v
    return Problem(M=np.diag([1.0, 1.0, 3.0, 3.0]), q=q, v=v, phi=Functions(phi, phi_q))


def on_a_sphere(square: bool) -> Problem:
    """Free point held by exp(|q|) = e, a function of the scalar |q|, which eqs 11 and 26 take."""
    r = np.linalg.norm
    told = Functions(lambda q: np.array([q @ q]), lambda q: 2.0 * q[None]) if square else None
    shell = Functions(
        lambda q: np.array([np.exp(r(q)) - math.e]),
        lambda q: (np.exp(r(q)) / r(q) * q)[None],
        square=told,
    )
    q, v = np.array([0.6, 0.0, 0.8]), np.array([1.2, 1.5, 0.6])
    return Problem(M=1.5 * np.eye(3), q=q, v=v, phi=shell)


def moments(problem: Problem, h: float, n: int, **method: object) -> list[Moment]:
    """Start and n steps."""
    return [*islice(motion(problem, Method(**method), h), n + 1)]  # type: ignore[arg-type]


def energy(problem: Problem, at: Moment) -> float:
    """Kinetic energy and that of the potentials."""
    return float(0.5 * at.v @ problem.M @ at.v + problem.potentials.value(at.q).sum())


# ------------------------------------------------------------------------- the equations as printed


def beta_of_eq_8(f: Functions, q_n: Array, d: Array) -> Array:
    """Gradients at the intermediate configurations, each the zero next to 1/2 of 2001 places."""
    beta = np.linspace(0.0, 1.0, 2001)
    along = np.array([f.gradient(q_n + b * d) @ d for b in beta])
    missed = along - (f.value(q_n + d) - f.value(q_n))
    rows = []
    for i, miss in enumerate(missed.T):
        found = [0.5]
        if abs(miss[1000]) > 1e-13:
            where = np.flatnonzero(miss[:-1] * miss[1:] <= 0.0)
            found = beta[where] + miss[where] / (miss[where] - miss[where + 1]) / 2000.0
        nearest = min(found, key=lambda b: abs(b - 0.5))
        rows.append(f.gradient(q_n + nearest * d)[i])
    return np.array(rows)


def impulse(problem: Problem, method: Method, h: float, n: Moment, n1: Moment) -> Array:
    """Impulse h Phi_q' (alpha Phi + lambda) of the constraints, by the equation of the method."""
    d, lam, phi = n1.q - n.q, n1.iterations[-1].lam, problem.phi
    mean, middle = 0.5 * (phi.value(n.q) + phi.value(n1.q)), n.q + 0.5 * d
    if method.formulation.startswith("conserving"):  # 9, 15
        return h * beta_of_eq_8(phi, n.q, d).T @ (method.alpha * mean + lam)
    if (
        method.formulation == "penalty-velocity"
    ):  # 3, by differences of Phi along the midpoint's line
        e, v, a = 2e-3, d / h, (n1.v - n.v) / h
        at = [phi.value(middle + s * v + 0.5 * s**2 * a) for s in e * np.arange(-2, 3)]
        rate = np.array([1, -8, 0, 8, -1]) @ at / (12 * e)
        second = np.array([-1, 16, -30, 16, -1]) @ at / (12 * e**2)
        force = second + 2 * method.xi * method.omega * rate + method.omega**2 * at[2]
        return h * phi.gradient(middle).T @ (method.alpha * force)
    return h * phi.gradient(middle).T @ (method.alpha * phi.value(middle) + lam)  # 5, 7


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("algorithm", ["nested", "simultaneous"])
def test_each_step_meets_its_equation_as_printed(formulation: str, algorithm: str):
    # M (v_n1 - v_n) + impulse = 0 and the midpoint relation. The differences of eq 3 and the 2001
    # places of eq 8 leave 1e-6 of the impulses, which are some 0.05 N s.
    problem, h = two_on_curves(), 0.02
    method = Method(alpha=4e4, formulation=formulation, algorithm=algorithm)
    path = [*islice(motion(problem, method, h), 9)]
    for n, n1 in pairwise(path):
        left = problem.M @ (n1.v - n.v) + impulse(problem, method, h, n, n1)
        assert np.abs(left).max() < 2e-6
        assert 0.5 * (n.v + n1.v) == pytest.approx((n1.q - n.q) / h, abs=1e-13)
    assert np.abs(problem.M @ (path[-1].v - path[0].v)).max() > 0.05


@pytest.mark.parametrize("formulation", ["conserving-penalty", "conserving-al"])
def test_a_function_of_a_distance_meets_eqs_11_and_26_as_printed(formulation: str):
    # Of Phi(|q|): h 2 dPhi/d(q^2) q_mid (alpha Phi_mean + lambda); with lambda = 0 this is eq 11.
    problem, h, alpha = on_a_sphere(square=True), 0.05, 300.0
    path = moments(problem, h, 12, alpha=alpha, formulation=formulation)
    for n, n1 in pairwise(path):
        phi_n, phi_n1 = (float(problem.phi.value(x.q)[0]) for x in (n, n1))
        lam, squares = float(n1.iterations[-1].lam[0]), (n.q @ n.q, n1.q @ n1.q)
        if formulation == "conserving-penalty":
            if abs(squares[1] - squares[0]) < 1e-4:  # the quotient as printed is 0/0
                continue
            push = alpha * (phi_n1**2 - phi_n**2) / (squares[1] - squares[0])
        else:  # the constraint holds: the quotient is the derivative exp(l)/(2 l) at l = 1
            push = math.e * (alpha * 0.5 * (phi_n + phi_n1) + lam)
        left = problem.M @ (n1.v - n.v) + h * push * 0.5 * (n.q + n1.q)
        assert np.abs(left).max() < 1e-9


@pytest.mark.parametrize("algorithm", ["nested", "simultaneous"])
@pytest.mark.parametrize("update", ["paper", "end"])
@pytest.mark.parametrize("formulation", AUGMENTED)
def test_updates_add_alpha_times_the_constraint(formulation: str, update: str, algorithm: str):
    # Eqs 16 and 27. Where the rows held at the start of the step both updates are the same.
    problem = two_on_curves()
    path = moments(
        problem,
        0.02,
        2,
        alpha=1e5,
        formulation=formulation,
        multiplier_update=update,
        algorithm=algorithm,
    )
    conserving = formulation.startswith("conserving")
    for at in path[1:]:
        assert len(at.iterations) > 2
        for k, k1 in pairwise(at.iterations):
            step = np.abs(k1.lam - k.lam).max()
            if conserving:  # the largest row of the mean, to what Phi_n was missed by
                assert step == pytest.approx(1e5 * 0.5 * k.phi, rel=1e-9, abs=1e-9)
            if algorithm == "nested":
                assert update == "end" or k1.lam == pytest.approx(k.mu, abs=1e-9)


# ------------------------------------------------------------------------------------- the energies


@pytest.mark.parametrize("problem", [bead_on_a_cubic(1.0), two_on_curves(), pendulum(2.0)])
@pytest.mark.parametrize("formulation", CONSERVING)
def test_the_energy_of_every_iteration_is_that_of_eqs_17_18_and_28(formulation, problem):
    # For any multipliers, also before they have converged, to the round-off of energies of 30 J.
    path = moments(problem, 0.05, 10, alpha=5e3, formulation=formulation)
    seen = 0.0
    for n, n1 in pairwise(path):
        for k in n1.iterations:
            for work in (k.eq17, k.eq18, k.eq28):
                assert k.kinetic == pytest.approx(k.applied + work, abs=2e-13)
            seen = max(seen, abs(k.eq17))
        kinetic = [0.5 * x.v @ problem.M @ x.v for x in (n, n1)]
        assert n1.iterations[-1].kinetic == pytest.approx(kinetic[1] - kinetic[0], abs=1e-12)
    assert seen > 1e-4  # there is something to balance


def test_the_change_of_energy_falls_with_the_iterations_below_the_bound_of_eq_20():
    # |dT| <= |dV| + |dPhi| |lambda|, and both sides go to 0 as multipliers converge (eqs 20 to 22).
    path = moments(two_on_curves(), 0.02, 4, alpha=3e4, formulation="conserving-al-beta")
    for at in path[1:]:
        assert len(at.iterations) >= 10
        for k in at.iterations:
            bound = 3 * (0.5 * 3e4 * k.phi**2 + k.phi * np.abs(k.lam).max())  # of three rows
            assert abs(k.kinetic) <= bound + 1e-14
        assert at.iterations[9].phi < 0.1 * at.iterations[0].phi
        assert abs(at.iterations[-1].kinetic) < 1e-13


@pytest.mark.parametrize("algorithm", ["nested", "simultaneous"])
@pytest.mark.parametrize("formulation", ["conserving-al", "conserving-al-beta"])
def test_a_bead_on_a_cubic_keeps_its_energy_with_large_steps(formulation: str, algorithm: str):
    # 300 steps of 50 ms, some 20 of which make a swing; its 6 J are kept to round-off.
    problem = bead_on_a_cubic()
    path = moments(
        problem,
        0.05,
        300,
        alpha=1e8,
        formulation=formulation,
        algorithm=algorithm,
        multiplier_update="end",
    )
    energies = np.array([energy(problem, at) for at in path])
    assert np.abs(energies - energies[0]).max() < 1e-12
    assert max(np.abs(problem.phi.value(at.q)).max() for at in path) < 1e-13
    assert np.ptp([at.q[0] for at in path]) > 1.0


@pytest.mark.parametrize("problem", [bead_on_a_cubic(), two_on_curves(), pendulum(2.0)])
def test_the_conserving_penalty_keeps_the_energy_with_that_of_the_penalty(problem: Problem):
    # E = T + V + alpha Phi^2/2 (eq 9 and what follows it); the rows are seen to give way.
    alpha = 2e3
    path = moments(problem, 0.05, 100, alpha=alpha, formulation="conserving-penalty")
    phi = np.array([problem.phi.value(at.q) for at in path])
    energies = [energy(problem, at) for at in path] + 0.5 * alpha * np.sum(phi**2, axis=1)
    assert np.abs(energies - energies[0]).max() < 1e-11
    assert np.abs(phi).max() > 1e-4


def test_a_function_of_a_distance_keeps_angular_momentum_and_eq_8_does_not():
    # The force of eq 26 acts along q at the midpoint; that of eq 8 for beta off 1/2 does not.
    lost, alpha = [], 10.0
    for square in (True, False):
        problem = on_a_sphere(square)  # on which, if it held, beta would be 1/2 by symmetry
        path = moments(problem, 0.1, 100, alpha=alpha, formulation="conserving-penalty")
        momentum = np.array([np.cross(at.q, problem.M @ at.v) for at in path])
        lost.append(np.abs(momentum - momentum[0]).max())
        phi = np.array([problem.phi.value(at.q)[0] for at in path])
        energies = [energy(problem, at) for at in path] + 0.5 * alpha * phi**2
        assert np.abs(energies - energies[0]).max() < 1e-11
    assert lost[0] < 1e-12
    assert lost[1] > 1e-4


# -------------------------------------------------------------------------------------- the motions


@pytest.mark.parametrize("formulation", [*AUGMENTED, "conserving-penalty", "midpoint-penalty"])
def test_a_pendulum_swings_as_elliptic_functions_tell_to_second_order(formulation: str):
    # Penalties grow as h^-2, so that what they give way is of second order, too.
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        path = moments(
            pendulum(1.0), h, round(0.6 / h), alpha=100.0 / h**2, formulation=formulation
        )
        exact = np.sin(pendulum_angle(np.array([at.t for at in path]), 1.0))
        errors.append(np.abs(exact - [at.q[0] for at in path]).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.15)
    assert errors[-1] < 1e-3


def test_the_multiplier_is_the_tension_of_the_rod():
    # 2 L mu is the tension; a step's multiplier is of first order, that of two in a row of second.
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        path = moments(pendulum(1.0, 2.0), h, round(1.0 / h), alpha=1e8, multiplier_update="end")
        mu = np.array([at.iterations[-1].mu[0] for at in path[1:]])
        between = np.array([at.t for at in path[1:-1]])
        error = 0.5 * (mu[1:] + mu[:-1]) - pendulum_multiplier(between, 1.0, 2.0)
        errors.append(np.abs(error).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.15)


@pytest.mark.parametrize("formulation", AUGMENTED)
def test_a_bead_on_a_cubic_moves_as_its_equation_in_one_coordinate(formulation: str):
    # With y = f(x): (1 + f'^2) x'' + f' f'' x'^2 + g f' = 0, by DOP853.
    def rates(_: float, y: Array) -> list[float]:
        x, dx = y
        slope, bend = 3.0 * x**2 - 1.0, 6.0 * x
        return [dx, -slope * (bend * dx**2 + GRAVITY) / (1.0 + slope**2)]

    exact = solve_ivp(rates, (0.0, 1.0), [1.1, 0.0], method="DOP853", rtol=1e-12, atol=1e-12)
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        at = moments(bead_on_a_cubic(), h, round(1.0 / h), alpha=1e8, formulation=formulation)[-1]
        errors.append(abs(at.q[0] - exact.y[0, -1]))
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.2)


@pytest.mark.parametrize("chi", [0.5, 3.0, 50.0])
def test_each_update_divides_what_is_missed_by_one_plus_chi(chi: float):
    # chi = alpha h^2 sigma/4 with sigma = 4 L^2/m = 4; 3 % is what higher terms may change.
    h = 0.01
    path = moments(pendulum(1.0, 2.0), h, 1, alpha=chi / h**2)
    missed = [k.phi for k in path[1].iterations if k.phi > 1e-13]
    rates = [later / now for now, later in pairwise(missed)]
    assert len(rates) >= 3
    assert rates[-3:] == pytest.approx([1.0 / (1.0 + chi)] * 3, rel=0.03)


def test_updates_with_the_mean_turn_a_defect_round_for_ever_and_pump_energy():
    # lambda + alpha (Phi_n + Phi_1)/2 rests where Phi_1 = -Phi_n (eq 16): a fixed point that is no
    # solution. With the end of the step the defect is gone after one.
    start = pendulum(1.0, 2.0)
    problem = Problem(
        M=start.M, q=1.0001 * start.q, v=start.v, phi=start.phi, potentials=start.potentials
    )
    phi_0, phi, energies = 1.0001**2 - 1.0, {}, {}
    for update in ("paper", "end"):
        path = moments(problem, 0.01, 8, alpha=1e12, multiplier_update=update)
        phi[update] = [problem.phi.value(at.q)[0] for at in path]
        energies[update] = [energy(problem, at) for at in path]
    assert phi["paper"] == pytest.approx(phi_0 * (-1.0) ** np.arange(9), rel=1e-9)
    assert phi["end"][1:] == pytest.approx(np.zeros(8), abs=1e-15)
    change = np.abs(np.array(energies["paper"]) - energies["paper"][0])
    assert change[-1] > 10.0 * change[1]


def test_the_converged_step_is_that_of_any_penalty_and_either_algorithm():
    problem, ends = bead_on_a_cubic(1.0), []
    for alpha in (3e4, 1e9):
        for algorithm in ("nested", "simultaneous"):
            ends.append(moments(problem, 0.02, 30, alpha=alpha, algorithm=algorithm)[-1].q)
    assert np.ptp(ends, axis=0).max() < 1e-11


def test_penalty_velocity_lets_a_defect_die_out_as_a_damped_oscillator():
    # Without forces and for a large penalty Phi'' + 2 xi omega Phi' + omega^2 Phi = 0 (eq 3), here
    # of a bead beside its cubic; critical: Phi = Phi_0 (1 + omega t) exp(-omega t).
    start = bead_on_a_cubic()
    q = start.q + np.array([0.0, 0.01])
    problem = Problem(M=start.M, q=q, v=start.v, phi=start.phi)
    errors, steps = [], [0.02, 0.01, 0.005]
    for h in steps:
        path = moments(
            problem, h, round(0.6 / h), alpha=1e7, formulation="penalty-velocity", omega=10.0
        )
        t = np.array([at.t for at in path])
        phi = np.array([problem.phi.value(at.q)[0] for at in path])
        errors.append(np.abs(phi - 0.01 * (1.0 + 10.0 * t) * np.exp(-10.0 * t)).max())
    assert observed_order(steps, errors) == pytest.approx(2.0, abs=0.15)


# ----------------------------------------------------------- what the midpoint rule does, section 2


def chain(n: int) -> Problem:
    """Unit points on n unit rods, straight from the origin in the horizontal."""
    ends = np.eye(n) - np.eye(n, k=-1)  # of each rod

    def phi_q(q: Array) -> Array:
        return 2.0 * np.einsum("rp,rd->rpd", ends, ends @ q.reshape(n, 2)).reshape(n, 2 * n)

    rods = Functions(lambda q: np.sum((ends @ q.reshape(n, 2)) ** 2, axis=1) - 1.0, phi_q)
    q = np.column_stack([np.arange(1.0, n + 1), np.zeros(n)]).ravel()
    weight = weights(np.ones(n))
    return Problem(M=np.eye(2 * n), q=q, v=np.zeros(2 * n), phi=rods, potentials=weight)


def largest_change_of_energy(problem: Problem, formulation: str, limit: float) -> float:
    """In six seconds of steps of 10 ms, until it is above a limit, or until a step fails."""
    method = Method(alpha=1e8, formulation=formulation, multiplier_update="end")
    change, start = 0.0, None
    try:
        for at in islice(motion(problem, method, 0.01), 601):
            start = energy(problem, at) if start is None else start
            change = max(change, abs(energy(problem, at) - start))
            if change > limit:
                break
    except StepError:
        assert formulation.startswith("midpoint")
    return change


@pytest.mark.parametrize("n", [1, 2, 5])
def test_the_midpoint_rule_loses_a_chain_within_6_s(n: int):
    # "Usually exhibits an unstable behavior for moderate time step sizes" (end of section 2.2): the
    # ends of its steps feed in more than ten times what gravity can ever give.
    assert largest_change_of_energy(chain(n), "midpoint-al", 10.0 * n * GRAVITY) > 10 * n * GRAVITY


def test_the_midpoint_rule_loses_a_bead_on_a_cubic_that_the_conserving_one_keeps():
    # Of the 6 J that gravity gives.
    assert largest_change_of_energy(bead_on_a_cubic(), "conserving-al", 1.0) < 1e-11
    assert largest_change_of_energy(bead_on_a_cubic(), "midpoint-al", 10.0) > 10.0


def test_a_step_that_cannot_be_solved_is_told_with_its_time_and_a_remedy():
    # The rod cannot reach: the circles of both rows do not meet.
    apart = Functions(
        lambda q: np.array([q @ q - 1.0, (q[0] - 5.0) ** 2 + q[1] ** 2 - 1.0]),
        lambda q: np.array([2.0 * q, 2.0 * (q - [5.0, 0.0])]),
    )
    problem = Problem(M=np.eye(2), q=np.array([2.5, 0.1]), v=np.zeros(2), phi=apart)
    with pytest.raises(StepError, match=r"t = 0 s with h = 0.01 s .*smaller step_size"):
        moments(problem, 0.01, 1, alpha=1e4)
