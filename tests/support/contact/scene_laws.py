"""What laws of contact ask of a run, found from outside: of its states, and of its outputs.

An event is enclosed between two states so close that forces do nothing in between. With rows G and
masses M of the NumPy model of ``tests/oracle`` at the first of them,

    M (v+ - v-) = G_b' lam + sum of G_N' p_N + G_T' p_T,    p_N >= 0,  |p_T| <= mu p_N

must have a solution for the contacts that touch, and gamma_N+ >= 0. If it is the only one, then
p_N is the impulse of the contact and -p.(gamma- + gamma+)/2 the loss. At rest forces lam must exist
with which rows of closed contacts do not accelerate, inside the static cones, and on the ray
(1, -mu t) of those that slide.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import nnls

from solver.runtime import Integrator
from tests.oracle.contacts import State, TooManyChoicesError
from tests.oracle.impacts import Law, restitutions
from tests.oracle.mechanism import OFF, STICKS, Array, Mechanism
from tests.oracle.start import Accelerations, rows_of

NARROW = 1e-8
"""Time between the states on either side of an event [s]."""
TOUCH = 1e-10
"""Gap over the size of the mechanism that counts as touching, beside the way in between."""
SLACK = 1e-7
"""Of rates, impulses and energies: what integration up to an event leaves."""
TURN = 0.02
"""Of impulses in a step: what directions turn while it lasts."""
DEPENDENT = 1e-8
"""Singular value, of columns of size 1, of rows that hold the same thing twice."""
FACETS = 32
"""Of the pyramids around cones in space."""


class LawError(AssertionError):
    """A run that breaks a law; the text says which, and by how much."""


def claim(holds: bool, law: str, *numbers: float) -> None:
    """Demand a law."""
    if not holds:
        message = f"{law}: {', '.join(f'{x:.6g}' for x in numbers)}"
        raise LawError(message)


def value(run: Integrator, name: str) -> float:
    """Value of a variable that is a number."""
    return float(run[name])


def enclose(run: Integrator, h: float) -> tuple[bytes, bytes] | None:
    """Take the run, by at most h [s], to just behind its next event; return the states around it.

    None, with the whole way covered, where there is no event.
    """
    begin, start = run.time, run.save()

    def passes(end: float) -> bool:
        run.restore(start)
        run.advance(begin, end - begin)
        return value(run, "solver.events") > 0.0

    if not passes(begin + h):
        return None
    low, high = begin, begin + h
    before, after = start, run.save()
    while high - low > max(NARROW, 4e-16 * abs(high)):
        middle = 0.5 * (low + high)
        if passes(middle):
            high, after = middle, run.save()
        else:
            low, before = middle, run.save()
    run.restore(after)
    return before, after


def cones(
    G: Array,
    normals: list[int],
    slips: list[list[int]],
    width: list[float],
    *,
    inside: bool = False,
) -> Array:
    """Columns (n, k) that span pyramids around the cones of contacts of these rows of G (r, n).

    `inside`: pyramids within the cones.
    """
    columns = []
    for k, tangents, mu in zip(normals, slips, width, strict=True):
        T = mu * G[tangents]
        if len(T) == 2:
            around = 2.0 * np.pi / FACETS * np.arange(FACETS)
            ways = np.array([np.cos(around), np.sin(around)]).T
            ways /= 1.0 if inside else np.cos(np.pi / FACETS)
        else:
            ways = np.array([[1.0], [-1.0]])[:, : len(T)]
        columns.append(G[k] + ways @ T)
    return np.concatenate(columns).T if columns else np.zeros((G.shape[1], 0))


def spread(rows: Array) -> tuple[Array, Array]:
    """Projector (n, n) onto what is perpendicular to rows (r, n), and their inverse (n, r)."""
    if not len(rows):
        return np.eye(rows.shape[1]), rows.T
    U, s, V = np.linalg.svd(rows, full_matrices=False)
    U, s, V = (x[..., s > DEPENDENT * s[0]] for x in (U, s, V.T))
    return np.eye(len(V)) - V @ V.T, V / s @ U.T


def misfit(columns: Array, wanted: Array) -> float:
    """Distance of a vector from what columns with factors >= 0 add up to."""
    sizes = np.linalg.norm(columns, axis=0)
    columns = columns[:, sizes > 0.0] / sizes[sizes > 0.0]
    return float(nnls(columns, wanted)[1]) if columns.size else float(np.linalg.norm(wanted))


class Around:
    """Two states of a run so close that impulses alone lie between them."""

    def __init__(self, run: Integrator, low: bytes, high: bytes, between: float = NARROW) -> None:
        run.restore(low)
        self.before = Mechanism.of(run.model, run.state)
        run.restore(high)
        self.after = Mechanism.of(run.model, run.state)
        x, n = self.before, self.before.n_free
        state = State(x)
        near = TOUCH * x.section["extent"][0] + 2.0 * between * np.abs(state.gap_rates)
        pushed = self.after.of_contacts[:, 4] > x.of_contacts[:, 4]
        self.touching = np.flatnonzero(pushed | (state.gaps <= near)).tolist()
        apart = ~pushed & (state.gaps > TOUCH * x.section["extent"][0]) & (state.gaps <= near)
        self.is_one = not np.any(apart & (state.gap_rates < 0.0))
        """Whether no contact lands between both states behind the impact."""
        self.normal = [x.contacts[i][0] for i in self.touching]
        of = [x.contacts[i][1] for i in self.touching]
        self.slips = [[] if f is None else x.frictions[f].rows for f in of]
        self.friction = [0.0 if f is None else float(x.section["sliding"][f]) for f in of]
        self.restitution = x.section["restitution"][self.touching]
        joints = [row for f in x.frictions if not f.pushes for row in f.rows]
        self.rubs = bool(joints)
        root = np.linalg.cholesky(x.M[:n, :n])
        G, _, psi = rows_of(x)
        self.A = np.linalg.solve(root, G[:, :n].T)  # rows in coordinates whose masses are 1
        held = np.flatnonzero(x.bilateral).tolist() + joints
        self.free, back = spread(self.A[:, held].T)
        self.jump = root.T @ (self.after.v - x.v)[:n]
        self.rates, self.rates_after = (
            y - self.A.T @ (back @ y[held]) for y in (state.rates, State(self.after).rates)
        )
        self.speed = max(float(np.linalg.norm(root.T @ x.v[:n])), float(np.linalg.norm(self.jump)))
        force = sum(np.linalg.norm(root.T @ y.vectors["a_second"][:n]) for y in (x, self.after))
        on = np.flatnonzero(x.rows_on())
        left = np.linalg.lstsq(self.A[:, on].T, state.rates[on], rcond=DEPENDENT)[0]
        self.noise = 4.0 * NARROW * float(force) + float(np.linalg.norm(left))
        later = np.linalg.solve(root, rows_of(self.after)[0][:, :n].T)
        turn = np.linalg.norm((later - self.A)[:, self.normal])
        self.noise += self.speed * float(turn / max(1e-300, np.linalg.norm(self.A[:, self.normal])))
        """Of the jump: what forces do between the states, what steps leave across rows, and how
        far normals turn."""
        surfaces = np.abs(psi - G @ x.v)[[r for rows in self.slips for r in rows]]
        self.driven = bool(len(x.vectors["signal"])) or bool(np.any(surfaces > 0.0))
        self.loss = self.after.head["impact"] - x.head["impact"]
        changes = (self.after.of_contacts - x.of_contacts)[self.touching]
        self.hits, self.impulses = float(np.sum(changes[:, 3])), changes[:, 4]

    @property
    def approach(self) -> float:
        """Largest speed of approach of what touches."""
        return float(-min(self.rates[self.normal], default=0.0))

    def unique_impulses(self) -> list[Array] | None:
        """Impulses of each contact, normal first, if there is one solution."""
        rows = [r for k, t in zip(self.normal, self.slips, strict=True) for r in (k, *t)]
        columns = self.free @ self.A[:, rows]
        sizes = np.linalg.norm(columns, axis=0)
        if self.rubs or not 0 < len(rows) <= len(columns) or min(sizes) < DEPENDENT * max(sizes):
            return None
        if np.linalg.svd(columns / sizes, compute_uv=False)[-1] < 1e-3:
            return None
        p = np.linalg.lstsq(columns / sizes, self.free @ self.jump, rcond=None)[0] / sizes
        ends = np.cumsum([1 + len(t) for t in self.slips])
        return np.split(p, ends[:-1])


def check_impact(x: Around) -> None:
    """Demand what an impact obeys, whatever the bodies are."""
    size = float(np.linalg.norm(x.jump))
    small, energy = SLACK * size + x.noise, SLACK * x.speed**2 + x.noise * x.speed
    energy += 1e-12 * x.before.head["energy_reference"]
    claim(x.loss >= -energy, "an impact makes energy", x.loss)
    if x.approach <= max(x.before.head["rest_speed"], SLACK * x.speed):
        return
    columns = x.free @ cones(x.A.T, x.normal, x.slips, x.friction)
    off = misfit(columns, x.free @ x.jump)
    claim(off <= small, "impulses are not in the cones of contacts", off, size)
    scale = np.linalg.norm(x.free @ x.A[:, x.normal], axis=0)
    gaps, extent = State(x.after).gaps[x.touching], x.before.section["extent"][0]
    after = np.where(gaps <= TOUCH * extent, x.rates_after[x.normal], 0.0)
    claim(bool(np.all(after >= -small * np.maximum(scale, 1e-3 * max(scale)))),
          "contacts approach after an impact", *after)  # fmt: skip
    kinetic = [0.5 * float(y.v @ y.M @ y.v) for y in (x.before, x.after)]
    if not x.driven:
        off = kinetic[0] - kinetic[1] - x.loss
        claim(abs(off) <= energy, "an impact loses other energy than it books", off, x.loss)
    check_restitution(x, energy, small)
    impulses = x.unique_impulses()
    if impulses is not None:
        check_impulses(x, impulses, energy, small)


def check_step(x: Around, h: float) -> None:
    """Demand that the impulses of a step of length h with impacts are in cones, up to its turns."""
    n = x.before.n_free
    x.before.forces_at(x.before.head["time"], 0.0, 0)
    root = np.linalg.cholesky(x.before.M[:n, :n])
    force = x.free @ np.linalg.solve(root, Accelerations(x.before).Q[:n])
    size, small = float(np.linalg.norm(x.jump)), 2.0 * h * float(np.linalg.norm(force))
    if size < 20.0 * small:
        return
    G = rows_of(x.after)[0][:, :n]
    ends = [cones(A.T, x.normal, x.slips, x.friction) for A in (x.A, np.linalg.solve(root, G.T))]
    off = misfit(x.free @ np.concatenate(ends, axis=1), x.free @ x.jump)
    claim(off <= TURN * size + small, "impulses of a step are not in the cones", off, size)


def check_restitution(x: Around, energy: float, small: float) -> None:
    """Demand what restitution promises without friction."""
    if any(x.friction) or x.rubs:
        return
    fast = [k for k, row in enumerate(x.normal) if x.rates[row] < -x.before.head["rest_speed"]]
    if x.hits != len(fast):
        return  # one after the other
    if not x.driven and np.all(x.restitution[fast] == 1.0):
        claim(abs(x.loss) <= energy, "an elastic impact loses energy", x.loss)
    if len(x.normal) == 1:
        e, row = x.restitution[0], x.normal[0]
        off = x.rates_after[row] + e * x.rates[row]
        scale = float(np.linalg.norm(x.free @ x.A[:, row]))
        claim(abs(off) <= 10.0 * small * scale, "a rebound is not e times the approach", off, e)


def check_impulses(x: Around, impulses: list[Array], energy: float, small: float) -> None:
    """Demand the laws of impulses that are the only ones."""
    loss = 0.0
    for k, p in enumerate(impulses):
        rows = [x.normal[k], *x.slips[k]]
        size = float(np.linalg.norm(x.free @ x.A[:, rows[0]]))
        most = 1e3 * small / size
        loss -= float(p @ (x.rates[rows] + x.rates_after[rows])) / 2.0
        claim(p[0] >= -most, "a contact pulls in an impact", p[0])
        force = float(np.linalg.norm(p[1:]))
        claim(force <= x.friction[k] * p[0] + most, "friction leaves its cone", force, *p)
        claim(abs(p[0] - x.impulses[k]) <= most, "an impulse is told wrong", p[0], x.impulses[k])
    claim(abs(loss - x.loss) <= 1e3 * energy, "impulses lose other energy", loss, x.loss)


def check_path(x: Around) -> bool:
    """Demand the rates to which the law of impact leads along its path; False where it is not told.

    The path is followed in NumPy, with W from the geometry: friction against the slip of each
    moment, and e^2 of the work of a compression given back.
    """
    head, state = x.before.head, State(x.before)
    parts = bool(np.any(x.rates[x.normal] > state.speed_tolerance))
    slow = x.approach <= max(head["rest_speed"], SLACK * x.speed)
    if slow or x.rubs or parts or head["impact_law"] or x.after.head["jams"] != head["jams"]:
        return False  # what touches and parts may hit a second time
    rows, places = [], []
    for row, slips in zip(x.normal, x.slips, strict=True):
        places.append(list(range(len(rows), len(rows) + 1 + len(slips))))
        rows += [row, *slips]
    A = x.free @ x.A[:, rows]
    A[:, np.linalg.norm(A, axis=0) < DEPENDENT * np.linalg.norm(x.A[:, rows], axis=0)] = 0.0
    e = restitutions(x.before, state)[x.touching]
    law = Law(A.T @ A, x.rates[rows], places, e, np.array(x.friction))
    try:
        p, unique = law.solve()
    except (ArithmeticError, TooManyChoicesError):
        return False
    if not unique:
        return False
    size = float(np.linalg.norm(x.jump))
    off = np.abs(x.rates_after[rows] - x.rates[rows] - law.W @ p)
    most = 10.0 * (SLACK * size + x.noise) * np.linalg.norm(x.A[:, rows], axis=0)
    claim(bool(np.all(off <= most)), "rates are not those of the law of impact", *off, *most)
    return True


def check_rest(run: Integrator) -> None:
    """Demand that closed contacts hold by forces inside their cones."""
    x = Mechanism.of(run.model, run.state)
    closed = [i for i, own in enumerate(x.of_contacts) if own[0]]
    if (
        not closed
        or x.head["unsettled"]
        or any(
            own[0] != OFF and not f.pushes
            for f, own in zip(x.frictions, x.of_frictions, strict=True)
        )
    ):
        return
    x.head["step_size"] = x.head["step_size"] or 1e-2
    modes, state, n = x.of_frictions.copy(), State(x), x.n_free
    x.forces_at(x.head["time"], 0.0, 0)
    at = Accelerations(x)
    root, driven = np.linalg.cholesky(x.M[:n, :n]), np.concatenate([np.zeros(n), at.driven])
    A = np.linalg.solve(root, at.G[:, :n].T)
    free, back = spread(A[:, x.bilateral].T)
    growth = at.bias + at.G @ driven
    a = free @ np.linalg.solve(root, (at.Q - x.M @ driven)[:n]) - back @ growth[x.bilateral]
    wanted, whole, A = -(A.T @ a + growth), np.linalg.norm(A, axis=0), free @ A
    rows, columns, begins = [], [], []
    for i in closed:
        row, f = x.contacts[i]
        rows.append(row)
        if f is None or modes[f, 0] == OFF:
            columns.append(A[:, [row]])
            continue
        slips, static = x.frictions[f].rows, float(x.section["static"][f])
        if modes[f, 0] == STICKS:
            columns.append(cones(A.T, [row], [slips], [static]))
            rows += slips
            continue
        size, along = state.slip(f)
        if size <= state.speed_tolerance:
            along = modes[f, 1 : 1 + len(slips)]
            begins.append((row, slips, static, len(columns)))
        columns.append(A[:, [row]] - x.section["sliding"][f] * (A[:, slips] @ along)[:, None])

    def unheld(rows: list[int], columns: list[Array]) -> tuple[float, float]:
        scale = np.linalg.norm(A[:, rows], axis=0)
        kept = scale > DEPENDENT * whole[rows]
        used, b = A[:, rows][:, kept] / scale[kept], wanted[rows][kept] / scale[kept]
        return misfit(used.T @ np.concatenate(columns, axis=1), b), float(np.linalg.norm(b)) + 1.0

    off, size = unheld(rows, columns)
    claim(off <= 1e-6 * size, "no admissible forces hold", off, size)
    if begins:  # and what begins to slide could not be held
        for row, slips, mu, k in begins:
            rows += slips
            columns[k] = cones(A.T, [row], [slips], [mu * (1.0 - 1e-6)], inside=True)
        off, size = unheld(rows, columns)
        claim(off > 1e-9 * size, "what slides could be held", off, size)


def check_outputs(run: Integrator, size: float, losses: dict[str, float]) -> dict[str, float]:
    """Demand what all outputs obey after a step; return the losses so far."""
    names = [v.name for v in run.model.variables if v.causality == "output"]
    found = dict(zip(names, map(float, run.get([run.model.index(n) for n in names])), strict=True))
    claim(all(map(math.isfinite, found.values())), "an output is not finite")
    claim(found["energy.error"] <= 1e-9, "the ledger does not close", found["energy.error"])
    words = ("kinetic", "potential", "work", "dissipated")
    total = sum(abs(found[f"energy.{word}"]) for word in words)
    now = {name: found[name] for name in ("energy.impact", "energy.friction")}
    for name, loss in now.items():
        before = losses.get(name, 0.0)
        claim(loss >= before - 1e-12 * (total + 1e-3), f"{name} falls", loss, before)
    for name in names:
        if name.endswith(".gap"):
            claim(found[name] >= -1e-9 * size, f"{name} is below 0", found[name])
        if name.endswith(".force") and f"{name.removesuffix('force')}gap" in found:
            claim(found[name] >= 0.0, f"{name} is below 0", found[name])
    return now
