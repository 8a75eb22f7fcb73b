"""Residual and tangent of the kernel against the oracle's, and against each other."""

from __future__ import annotations

import numpy as np
import pytest

from solver.runtime.layout import ISLAND
from tests.oracle import Mechanism, Residual
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.kernel_cases import SOURCES, ZOO
from tests.support.kernel.twins import EVERYTHING, advance, model_of, numbers, start, vector

ALL = SOURCES | ZOO


@pytest.fixture(params=[2, 3], ids=["plane", "space"], scope="module")
def probed(request):
    """Kernel in a state of a mechanism of all laws, a little under way."""
    run = start(model_of(EVERYTHING[request.param]), step_size=0.05)
    advance(run, 2)
    run.state.head["penalty"] = 10.0  # so that the rows' compliance is seen
    return run


class Bodies:
    """Turns theta of bodies in a step, whose directors the oracle has for unknowns (theory 9.6)."""

    def __init__(self, run):
        sizes, tables = run.model.sizes, run.model.tables
        self.dim, self.turning = sizes["dim"], 2 * sizes["dim"] - 3
        self.first = [int(a) for a in tables["body_node"]]
        free = self.dim * sizes["n_free"]
        self.q, self.v = (vector(run, x)[:free].reshape(-1, self.dim) for x in "qv")
        self.is_unknown = np.ones(free + sizes["n_rows"], dtype=bool)
        for a in self.first:
            begin = self.dim * a
            self.is_unknown[begin + self.turning : begin + self.dim * self.turning] = False
        end = free + sizes["n_form_rows"]
        self.is_unknown[end - sizes["n_rigidity_rows"] : end] = False

    def cross(self, turn, vector):
        """Return turn x vector; in the plane turns have one number."""
        return np.cross(turn, vector) if self.dim == 3 else turn * [-vector[1], vector[0]]

    def moment(self, arm, force):
        """Return arm x force, as many numbers as a turn has."""
        if self.dim == 3:
            return np.cross(arm, force)
        return np.array([arm[0] * force[1] - arm[1] * force[0]])

    def directors(self, theta, a):
        """Changes of the directors of the body with first director a."""
        t = 0.5 * theta
        for k in range(a, a + self.turning):
            x = self.cross(t, self.q[k])
            yield k, 2.0 * (x + self.cross(t, x)) / (1.0 + t @ t)

    def increments(self, unknown, h):
        """Return w of all nodes."""
        w = unknown.reshape(-1, self.dim).copy()
        for a in self.first:
            for k, change in self.directors(unknown.reshape(w.shape)[a][: self.turning], a):
                w[k] = change - h * self.v[k]
        return w.ravel()

    def torques(self, unknown, balance):
        """Return the balance of momentum with torques in the place of forces on directors."""
        r = balance.reshape(-1, self.dim).copy()
        for a in self.first:
            torque = np.zeros(self.turning, dtype=r.dtype)
            for k, change in self.directors(unknown.reshape(r.shape)[a][: self.turning], a):
                force = balance.reshape(r.shape)[k]
                torque = torque + self.moment(self.q[k] + 0.5 * change, force)
            r[a : a + self.turning] = 0.0
            r[a, : self.turning] = torque
        return r.ravel()

    def rates(self, unknown, x):
        """Return the rates of the unknowns in a direction x, which has spins at the end."""
        rate = x[: len(unknown)].reshape(-1, self.dim).copy()
        for a in self.first:
            t, spin = 0.5 * unknown.reshape(rate.shape)[a][: self.turning], rate[a, : self.turning]
            across = self.cross(t, spin) if self.dim == 3 else 0.0
            rate[a, : self.turning] = spin - across + t * (t @ spin)
        return rate.ravel()

    def of_the_motion(self, h):
        """Return the turns h omega of bodies, and nothing for points."""
        found = np.zeros_like(self.q)
        for a in self.first:
            spins = [self.moment(self.q[k], self.v[k]) for k in range(a, a + self.turning)]
            found[a, : self.turning] = h * np.sum(spins, axis=0) / (self.dim - 1)
        return found.ravel()


def unknowns(run, size, seed):
    """Random w [m] and turns of a size, mu, and a direction (w, mu)."""
    random, known = np.random.default_rng(seed), ~Bodies(run).is_unknown
    n = len(known) - run.model.sizes["n_rows"]
    w, mu, x = size * random.normal(size=n), 5.0 * random.normal(size=len(known) - n), known * 0.0
    x += random.normal(size=len(known))
    w[known[:n]] = mu[known[n:]] = x[known] = 0.0
    return w, mu, x


def probe_of_the_oracle(run, h, w, mu, x):
    """Residual and tangent times x, rows as in the kernel.

    They are Phi_n1 - (2/alpha) mu there, which is eq 15 with lam = -alpha Phi_n/2.
    """
    oracle, bodies = Mechanism.of(run.model, run.state), Bodies(run)
    oracle.numbers[:] = numbers(run)
    equations = Residual(oracle, h)
    lam = -0.5 * equations.alpha * equations.phi_n
    n, step = len(w), 1e-30j

    def residual(w, mu):
        found = equations.residual(bodies.increments(w, h), mu, lam)
        whole = np.concatenate([bodies.torques(w, found[:n]), 2.0 * found[n:]])
        return np.where(bodies.is_unknown, whole, 0.0)

    ahead = residual(w + step * bodies.rates(w, x), mu + step * x[n:])
    return residual(w, mu), ahead.imag / 1e-30


def lower_penalties(run):
    """Lower penalties to those that were asked for, which are the oracle's."""
    levels = np.asarray(run.state.vectors["islands"])[ISLAND.index("penalty_level") :: len(ISLAND)]
    levels[:] = 0.0


def is_near(ours, theirs):
    """Whether they are equal but for the rounding of terms, up to 1e5 in rows, that cancel."""
    return ours == pytest.approx(theirs, rel=1e-12, abs=1e-13 * np.max(np.abs(theirs)))


@pytest.mark.parametrize("size", [1e-9, 1e-2, 1.0])
def test_residual_and_tangent_of_the_kernel_are_those_of_the_equations(probed, size):
    """At increments from none (series of the torque's law) to links turned by more than 90°."""
    for seed in range(5):
        arguments = unknowns(probed, size, seed)
        status, *ours = kernel_of(probed).probe(0.1, *arguments)
        assert status == 0
        for a, b in zip(ours, probe_of_the_oracle(probed, 0.1, *arguments), strict=True):
            assert is_near(a, b)


@pytest.mark.parametrize("name", ALL)
def test_residual_and_tangent_of_every_scene_are_those_of_the_equations(name):
    """At increments next to those of the motion: formulas of a scene may have no value far off."""
    run = start(ALL[name])
    advance(run, 2)
    lower_penalties(run)
    h = run.state.head["step_size"]
    for seed in range(3):
        _, mu, x = unknowns(run, 1.0, seed)
        free = len(x) - len(mu)
        bodies = Bodies(run)
        w = 0.5 * h**2 * vector(run, "a_first")[:free] * (1.0 + 0.1 * seed)
        kinds = np.asarray(run.model.tables["node_kind"])[: len(bodies.q)]
        turning = np.repeat(kinds > 0, bodies.dim)
        w = np.where(turning, (1.0 + 0.1 * seed) * bodies.of_the_motion(h), w)
        status, *ours = kernel_of(run).probe(h, w, mu, x)
        assert status == 0
        for a, b in zip(ours, probe_of_the_oracle(run, h, w, mu, x), strict=True):
            # Rows of all scales are beside balances of all scales; each is a sum that cancels.
            assert a == pytest.approx(b, rel=1e-10, abs=1e-11 * np.max(np.abs(b)))


@pytest.mark.parametrize("size", [1e-9, 1e-2, 1.0])
def test_the_tangent_is_the_derivative_of_the_residual(probed, size):
    kernel = probed
    for seed in range(5):
        w, mu, x = unknowns(kernel, size, seed)
        n, step, rates = len(w), 1e-5, Bodies(kernel).rates(w, x)
        _, _, tangent = kernel_of(kernel).probe(0.1, w, mu, x)
        ahead, behind = (
            np.array(kernel_of(kernel).probe(0.1, w + s * rates, mu + s * x[n:], x)[1])
            for s in (step, -step)
        )
        # truncation step^2 times third derivatives of order 10, rounding 1e-16/step
        scale = np.max(np.abs(tangent))
        assert (ahead - behind) / (2.0 * step) == pytest.approx(tangent, abs=1e-8 * scale)
