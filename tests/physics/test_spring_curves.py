"""Springs by a curve: a force of the elongation, a torque of the angle, with the energy of it.

A mass of 1 kg moves along the x axis on a spring of free length 1 m, or a disc of 1 kg.m2 turns
about its hinge: one equation, s'' = -F(s) - c s', which SciPy's DOP853 and closed forms solve.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.special import ellipk

import holonom
import solver
from solver.runtime import Integrator
from tests.support.mechanisms.problems import observed_order

ROUND_OFF = 1e-12
"""Of an energy balance, over the energies that are exchanged, after hundreds of steps."""
PAD = "x = [-0.4, -0.1, 0, 0.1, 0.4], y = [-120, -10, 0, 10, 120]"
THREE = "x = [0, 1, 2, 4], y = [0, 1, 0.5, 2]"
PROFILES = f"""
[profiles]
pad = {{ {PAD}, interpolation = "monotone" }}
soft = {{ {PAD} }}
bent = {{ {PAD}, interpolation = "linear" }}
even = {{ x = [-0.1, 0, 0.1], y = [-10, 0, 10], interpolation = "linear", extrapolate = "hold" }}
cubic = {{ {THREE} }}
monotone = {{ {THREE}, interpolation = "monotone" }}
linear = {{ {THREE}, interpolation = "linear" }}
detent = {{ x = [0, 0.1, 0.3, 0.4], y = [0, 3, -1, 0], periodic = true }}
"""
PLACES, FORCES = [-0.4, -0.1, 0.0, 0.1, 0.4], [-120.0, -10.0, 0.0, 10.0, 120.0]
PCHIP, SPLINE = PchipInterpolator(PLACES, FORCES), CubicSpline(PLACES, FORCES, bc_type="natural")
CUBIC = "100*elongation + 400*elongation**3"

LAWS = {
    # formula: the force by hand, and whether it has all derivatives
    "100*elongation + 400*elongation**3": (lambda s: 100 * s + 400 * s**3, True),
    "stiff*elongation*(1 + elongation)**2": (lambda s: 80 * s * (1 + s) ** 2, True),
    "200*(elongation + 0.1)**5 - 0.002": (lambda s: 200 * (s + 0.1) ** 5 - 0.002, True),
    "30*(exp(2*elongation) - 1)": (lambda s: 30 * (np.exp(2 * s) - 1), True),
    "50*(1 - (1 + elongation)**-1.4)": (lambda s: 50 * (1 - (1 + s) ** -1.4), True),
    "50*(1 - 1/length)": (lambda s: 50 * (1 - 1 / (1 + s)), True),
    "40*tanh(5*elongation)": (lambda s: 40 * np.tanh(5 * s), True),
    "90*elongation/sqrt(1 + elongation**2)": (lambda s: 90 * s / np.sqrt(1 + s * s), True),
    "60*elongation*cos(elongation)": (lambda s: 60 * s * np.cos(s), True),
    "pad(elongation)": (PCHIP, False),
    "2*pad(0.5*elongation) + 10*elongation": (lambda s: 2 * PCHIP(s / 2) + 10 * s, False),
    "soft(elongation - 0.05) + 3": (lambda s: SPLINE(s - 0.05) + 3, False),
    "bent(elongation)": (lambda s: np.interp(s, PLACES, FORCES), False),
    "even(elongation)": (lambda s: np.clip(100 * s, -10, 10), False),
    "max(min(10*stiff*elongation, 40), -stiff/2)": (lambda s: np.clip(800 * s, -40, 40), False),
    "300*elongation*abs(elongation)": (lambda s: 300 * s * abs(s), False),
    "min(max(1000*elongation, -30), 60)": (lambda s: np.clip(1000 * s, -30, 60), False),
    "500*max(elongation - 0.03, 0)**1.5 + 50*elongation":
        (lambda s: 500 * np.maximum(s - 0.03, 0) ** 1.5 + 50 * s, False),
    "50*elongation if elongation < 0 else 300*elongation":
        (lambda s: np.where(s < 0, 50 * s, 300 * s), False),
}  # fmt: skip


def scene(law: str, s: float, v: float = 0.0, settings: str = "", damping: float = 0.0) -> str:
    """A mass at the elongation s."""
    return f"""
name = "curve"
dimension = 2
gravity = [0, 0]
{"[parameters]" if "stiff" in law else ""}
{"stiff = 80" if "stiff" in law else ""}
{PROFILES}
[points]
A = {{ mass = 1, position = [{1 + s}, 0], velocity = [{v}, 0] }}
[forces]
law = {{ type = "spring", points = ["ground", "A"], at = [0, 0], {law}, free_length = 1 }}
slow = {{ type = "damper", points = ["ground", "A"], at = [0, 0], damping = {damping} }}
[solver]
{settings}
"""


def force_law(force: str) -> str:
    return f'force = "{force}"'


def run(text: str, stop: float):
    return holonom.simulate(solver.loads(text), stop_time=stop)


def reference(force, s: float, v: float, stop: float, damping: float = 0.0):
    """Place, speed and what the damper took, by DOP853; pieces that meet in kinks, too."""
    found = solve_ivp(
        lambda _, y: [y[1], -float(force(y[0])) - damping * y[1], damping * y[1] ** 2],
        (0.0, stop), [s, v, 0.0], method="DOP853", rtol=1e-13, atol=1e-14, max_step=stop / 2000,
    )  # fmt: skip
    return found.y[:, -1]


# ------------------------------------------------------------------------------ force and energy


@pytest.mark.parametrize("s", [-0.35, -0.02, 0.0, 0.04, 0.3])
@pytest.mark.parametrize("law", LAWS)
def test_the_force_is_the_formula_and_its_energy_the_integral_from_the_free_length(law, s):
    force, _ = LAWS[law]
    first = run(scene(force_law(law), s, 1.0, "step_size = 1e-3"), 1e-3)
    kinks = (-0.2, -0.1, -0.05, -0.03, 0.0, 0.03, 0.05, 0.06, 0.1, 0.15, 0.2)
    ends = sorted({0.0, s, *(k for k in kinks if min(0, s) < k < max(0, s))})
    parts = [quad(force, a, b, epsabs=1e-14)[0] for a, b in pairwise(ends)]
    by_hand = sum(parts) * (1 if s > 0 else -1)
    assert first["law.force"][0] == pytest.approx(float(force(s)), abs=1e-12 * 100)
    assert first["energy.potential"][0] == pytest.approx(by_hand, abs=ROUND_OFF)


@pytest.mark.parametrize(
    ("profile", "values", "integral"),
    [
        ("linear", (0.5, 0.75, 1.25), 2.125),
        ("monotone", (0.71875, 0.75, 0.854166666667), 2.012152777778),
        ("cubic", (0.667119565217, 0.811141304348, 0.826086956522), 1.959239130435),
    ],
)
def test_profiles_pull_with_their_values_and_store_their_integrals(profile, values, integral):
    # The numbers are SciPy's interp, PchipInterpolator and natural CubicSpline, to 12 digits.
    law = force_law(f"{profile}(elongation)")
    for s, value in zip((0.5, 1.5, 3.0), values, strict=True):
        first = run(scene(law, s, settings="step_size = 1e-3"), 1e-3)
        assert first["law.force"][0] == pytest.approx(value, abs=1e-12)
    assert first["energy.potential"][0] == pytest.approx(integral, abs=1e-12)


@pytest.mark.parametrize("h", [0.01, 0.1])
@pytest.mark.parametrize("law", LAWS)
def test_energy_is_kept_to_round_off_at_any_step(law, h):
    moved = run(scene(force_law(law), 0.3, 0.5, f"step_size = {h}"), 100 * h)
    exchanged = np.ptp(moved["energy.kinetic"]) + moved["energy.kinetic"].max()
    assert np.ptp(moved["A.x"]) > 0.1
    assert np.abs(moved["energy.balance"]).max() < ROUND_OFF * exchanged


# ----------------------------------------------------------------------------------- the motion


@pytest.mark.parametrize(("order", "limit"), [(2, 3e-3), (4, 3e-7), (6, 3e-10), (8, 1e-12)])
def test_a_cubic_spring_moves_as_its_equation_says_at_every_order(order, limit):
    exact = reference(LAWS[CUBIC][0], 0.3, 0.0, 1.0)
    errors, steps = [], [0.02, 0.01]
    for h in steps:
        moved = run(scene(force_law(CUBIC), 0.3, 0.0, f"step_size = {h}\norder = {order}"), 1.0)
        errors.append(abs(moved["A.x"][-1] - 1 - exact[0]) + 1e-16)
    assert errors[-1] < limit
    if order < 8:  # there round-off is near
        assert observed_order(steps, errors) == pytest.approx(order, abs=0.35)


def test_a_cubic_spring_swings_in_the_period_of_the_elliptic_integral():
    # x'' + a x + b x^3 = 0 from rest at x0: T = 4 K(m)/sqrt(a + b x0^2), m = b x0^2/2/(a + b x0^2).
    a, b, start = 100.0, 400.0, 0.3
    w2 = a + b * start**2
    period = 4 * ellipk(0.5 * b * start**2 / w2) / np.sqrt(w2)
    for settings in ("step_size = {}\norder = 8", "tolerance = 1e-10\nstep_size = {}"):
        text = scene(force_law(CUBIC), start, 0.0, settings.format(period / 60))
        moved = run(text, 10 * period)
        assert moved["A.x"][-1] - 1 == pytest.approx(start, abs=3e-9)
        assert moved["A.vx"][-1] == pytest.approx(0.0, abs=3e-8)


@pytest.mark.parametrize("method", ["conserving", "fastest"])
@pytest.mark.parametrize("law", LAWS)
def test_a_tolerance_finds_the_motion_of_every_law(law, method):
    force, is_smooth = LAWS[law]
    settings = f'step_size = 0.05\ntolerance = 1e-8\nmethod = "{method}"'
    moved = run(scene(force_law(law), 0.3, 0.0, settings), 1.0)
    exact = reference(force, 0.3, 0.0, 1.0)
    assert moved["A.x"][-1] - 1 == pytest.approx(exact[0], abs=2e-7)
    assert moved["A.vx"][-1] == pytest.approx(exact[1], abs=2e-6)
    assert np.abs(moved["energy.balance"]).max() < ROUND_OFF * moved["energy.kinetic"].max()
    explicit = bool((moved["solver.method_in_use"] == 2).any())
    assert explicit == (is_smooth and method == "fastest")


def test_a_measured_spring_with_a_damper_takes_what_the_design_page_says():
    # PCHIP spring, D = 0.2 r, m = 1, s0 = 0.3, at 1 s: NumPy and DOP853, of another program.
    text = scene(force_law("pad(elongation)"), 0.3, 0.0, "step_size = 0.01\ntolerance = 1e-9", 0.2)
    moved = run(text, 1.0)
    assert moved["A.x"][-1] - 1 == pytest.approx(0.0788571579, abs=1e-7)
    assert moved["A.vx"][-1] == pytest.approx(-3.3564254506, abs=1e-6)
    assert moved["energy.dissipated"][-1] == pytest.approx(1.5056077427, abs=1e-7)
    assert np.abs(moved["energy.balance"]).max() < ROUND_OFF * 10


def test_a_spring_without_a_free_length_is_free_as_drawn():
    text = scene(force_law(CUBIC), 0.3, 2.0, "step_size = 0.01").replace(", free_length = 1 ", "")
    moved = run(text, 0.1)
    assert moved["law.force"][0] == 0.0
    stretch = moved["law.length"] - 1.3
    assert moved["law.force"] == pytest.approx(100 * stretch + 400 * stretch**3, abs=1e-12)


@pytest.mark.parametrize("settings", ["order = 4", "tolerance = 1e-8"])
@pytest.mark.parametrize("law", [CUBIC, "pad(elongation)", "300*elongation*abs(elongation)"])
def test_a_free_length_that_moves_does_work(law, settings):
    # An end that is pulled away: s = x - 1 - 0.2 t; DOP853 tells motion and work, -0.2 F.
    text = scene(force_law(law), 0.2, 0.0, f"step_size = 0.002\n{settings}")
    moved = run(text.replace("free_length = 1 ", 'free_length = "1 + 0.2*t" '), 1.0)
    force = LAWS[law][0]
    exact = solve_ivp(
        lambda t, y: [y[1], -float(force(y[0] - 0.2 * t)), -0.2 * float(force(y[0] - 0.2 * t))],
        (0.0, 1.0), [0.2, 0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-14, max_step=5e-4,
    ).y[:, -1]  # fmt: skip
    assert moved["A.x"][-1] - 1 == pytest.approx(exact[0], abs=1e-6)
    assert moved["energy.work"][-1] == pytest.approx(exact[2], abs=1e-5)
    assert np.abs(moved["energy.balance"]).max() < ROUND_OFF * moved["energy.kinetic"].max()


def test_a_spring_of_the_time_moves_beside_an_energy_with_a_kink():
    # Under a tolerance, whose steps end at the kink; DOP853 of the equation.
    text = scene('stiffness = "30 + 20*t"', 0.3, 0.0, "step_size = 0.05\ntolerance = 1e-8")
    text = text.replace(
        "[solver]", 'rest = { type = "potential", value = "50*max(A.x - 1.1, 0)**2" }\n[solver]'
    )
    moved = run(text, 1.0)
    exact = solve_ivp(
        lambda t, y: [y[1], -(30 + 20 * t) * y[0] - 100 * max(y[0] - 0.1, 0.0)],
        (0.0, 1.0), [0.3, 0.0], method="DOP853", rtol=1e-13, atol=1e-14, max_step=5e-4,
    ).y[:, -1]  # fmt: skip
    assert moved["A.x"][-1] - 1 == pytest.approx(exact[0], abs=1e-7)
    assert moved["A.vx"][-1] == pytest.approx(exact[1], abs=1e-6)
    assert np.abs(moved["energy.balance"]).max() < ROUND_OFF * moved["energy.kinetic"].max()


# -------------------------------------------------------------------------------------- torsion


def hinge(law: str, rate: float, settings: str) -> str:
    return f"""
name = "curve"
dimension = 2
gravity = [0, 0]
{PROFILES}
[bodies]
disc = {{ mass = 1, inertia = 1, position = [0, 0], angular_velocity = {rate} }}
[joints]
pin = {{ type = "revolute", bodies = ["ground", "disc"], position = [0, 0] }}
[forces]
law = {{ type = "torsion_spring", joint = "pin", {law} }}
[solver]
{settings}
"""


@pytest.mark.parametrize("free", [0.0, 0.2])
def test_a_torsion_spring_turns_back_with_its_torque(free):
    law = f'torque = "100*angle + 400*angle**3", free_angle = {free}'
    moved = run(hinge(law, 3.0, "step_size = 0.01\norder = 8"), 1.0)
    turned = moved["pin.angle"] - free
    exact = reference(LAWS[CUBIC][0], -free, 3.0, 1.0)
    assert turned[-1] == pytest.approx(exact[0], abs=1e-10)
    assert moved["law.torque"] == pytest.approx(100 * turned + 400 * turned**3, abs=1e-11)
    assert moved["energy.potential"] == pytest.approx(50 * turned**2 + 100 * turned**4, abs=1e-12)


def test_a_detent_repeats_and_gives_its_energy_back():
    # Over 3 and 25 periods; the mean torque of the periodic spline is 0 within 1e-2 N.m or not.
    moved = run(hinge('torque = "detent(angle)"', 5.0, "step_size = 0.01"), 2.0)
    spline = CubicSpline([0, 0.1, 0.3, 0.4], [0, 3, -1, 0], bc_type="periodic")
    energy = np.array([float(spline.integrate(0.0, x)) for x in moved["pin.angle"]])
    assert moved["pin.angle"][-1] > 8.0
    assert moved["law.torque"] == pytest.approx(spline(moved["pin.angle"]), abs=1e-11)
    assert moved["energy.potential"] == pytest.approx(energy, abs=1e-11)
    assert np.abs(moved["energy.balance"]).max() < ROUND_OFF * moved["energy.kinetic"].max()


def test_a_tunable_parameter_that_changes_does_the_work_that_energies_differ_by():
    text = scene('force = "hard*elongation + 400*elongation**3"', 0.3, 0.0, "step_size = 0.01")
    text = text.replace(
        "[profiles]", '[parameters]\nhard = { value = 100, variability = "tunable" }\n[profiles]'
    )
    moving = Integrator(solver.assemble(solver.loads(text)))
    moving.initialise()
    for k in range(30):
        if k == 11:
            stretch, work = moving["law.length"] - 1, moving["energy.work"]
            moving["hard"] = 250.0
        moving.advance(0.01 * k, 0.01)
    assert moving["energy.work"] - work == pytest.approx(0.5 * 150 * stretch**2, abs=ROUND_OFF)
    assert abs(moving["energy.balance"]) < ROUND_OFF * 20
    stretch = moving["law.length"] - 1
    assert moving["law.force"] == pytest.approx(250 * stretch + 400 * stretch**3, abs=1e-12)
