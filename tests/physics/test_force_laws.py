"""Dampers with a law of their rate: against closed forms, and DOP853 on equations by hand."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import holonom
import solver
from solver.scene import SceneError

CURVE = """
name = "curve"
dimension = 2
[points]
A = { position = [1.3, 0], mass = 1.0 }
[forces.rubber]
type = "spring"
points = ["ground", "A"]
at = [0, 0]
energy = "50*(length - 1)**2 + 100*(length - 1)**4"
[forces.shock]
type = "damper"
points = ["ground", "A"]
at = [0, 0]
force = "0.2*rate + 0.5*rate*abs(rate)"
"""
PRINTED = (-0.013921438067, -2.872720557403, 1.174044221552)
"""Elongation, rate and energy taken at 0.15 s, calculated elsewhere to so many digits."""
SHOT = """
name = "shot"
dimension = 2
[points]
A = {{ position = [5, 0], velocity = [1, 0], mass = 1.0 }}
[forces]
brake = {{ type = "damper", points = ["ground", "A"], at = [0, 0], force = "{law}" }}
"""
PENDULUM = """
name = "pendulum"
dimension = 2
gravity = [0, -9.81]
[bodies]
rod = { mass = 1.0, inertia = 0.3, position = [1, 0] }
[joints]
hinge = { type = "revolute", bodies = ["ground", "rod"], position = [0, 0] }
[forces]
brake = { type = "torsion_damper", joint = "hinge", torque = "valve(rate) + 0.3*rate*angle**2" }
[profiles]
valve = { x = [-4, -1, 0, 1, 4], y = [-2.5, -1, 0, 1.5, 3], interpolation = "monotone" }
"""


def run(text: str, stop: float, points: int = 1, **settings: Any) -> dict[str, np.ndarray]:
    outputs = ["energy.error", "energy.dissipated", "energy.work", *names(text)]
    return solver.simulate(
        solver.loads(text), stop_time=stop, step_size=stop / points, outputs=outputs, **settings
    )


def names(text: str) -> list[str]:
    return ["hinge.angle", "hinge.angular_velocity"] if "hinge" in text else ["A.x", "A.vx"]


@cache
def right() -> np.ndarray:
    """Elongation, rate and energy taken of the curve at 0.15 s, by DOP853."""

    def motion(_: float, y: np.ndarray) -> list[float]:
        s, v, _ = y
        force = 0.2 * v + 0.5 * v * abs(v)
        return [v, -(100.0 * s + 400.0 * s**3) - force, force * v]

    found = solve_ivp(motion, (0.0, 0.15), [0.3, 0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15)
    assert found.y[:, -1] == pytest.approx(PRINTED, abs=2e-12)
    return found.y[:, -1]


def errors(found: dict[str, np.ndarray]) -> np.ndarray:
    ends = [found[x][-1] for x in ("A.x", "A.vx", "energy.dissipated")]
    return np.abs(np.array(ends) - [1.0, 0.0, 0.0] - right())


@pytest.mark.parametrize("order", [2, 4, 6, 8])
def test_a_curve_and_its_damper_hold_every_order(order: int) -> None:
    """Errors fall with that power of the step, within 0.3; the ledger closes."""
    long, short = (run(CURVE, 0.15, order=order, internal_step=0.15 / n) for n in (4, 7))
    observed = np.log(errors(long) / errors(short)) / math.log(7.0 / 4.0)
    assert np.all(np.abs(observed - order) < 0.3)
    for found in (long, short):
        assert found["energy.error"][-1] < 1e-14
        assert found["energy.work"][-1] == 0.0


@pytest.mark.parametrize("method", ["conserving", "fastest"])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
def test_a_curve_and_its_damper_keep_a_tolerance(tolerance: float, method: str) -> None:
    found = run(CURVE, 0.15, tolerance=tolerance, method=method)
    assert np.all(errors(found) < 3.0 * tolerance * np.array([0.3, 3.4, 5.4]))


@pytest.mark.parametrize(
    ("settings", "within"),
    [
        ({"order": 2, "internal_step": 0.05}, 2e-5),  # 0.3 % of the way, in ten times its time
        ({"order": 8, "internal_step": 0.05}, 2e-7),
        ({"tolerance": 1e-4}, 3e-4 * 0.005), ({"tolerance": 1e-8}, 3e-8 * 0.005),
        ({"tolerance": 1e-8, "method": "fastest"}, 3e-8 * 0.005),
    ],
)  # fmt: skip
def test_a_strong_damper_takes_all_of_a_shot_at_any_step(
    settings: dict[str, Any], within: float
) -> None:
    """M v' = -a v - b v^3 stops after m atan(v sqrt(b/a))/sqrt(a b), and takes m v^2/2."""
    a, b = 200.0, 3.0
    found = run(SHOT.format(law=f"{a}*rate + {b}*rate**3"), 1.0, 20, **settings)
    way = math.atan(math.sqrt(b / a)) / math.sqrt(a * b)
    assert found["A.x"][-1] - 5.0 == pytest.approx(way, abs=within)
    assert found["energy.dissipated"][-1] == pytest.approx(0.5, abs=1e-14)
    assert np.all(np.diff(found["energy.dissipated"]) >= 0.0)
    assert np.all(found["energy.work"] == 0.0)


def test_a_sign_of_the_rate_rubs() -> None:
    """M v' = -c stops at m v/c and stays; the rest of the law is a damper."""
    found = run(SHOT.format(law="2*sign(rate)"), 1.0, 10, tolerance=1e-8)
    assert found["A.x"][-1] == pytest.approx(5.25, abs=1e-9)
    assert found["A.vx"][-1] == pytest.approx(0.0, abs=1e-20)
    both = run(SHOT.format(law="2*sign(rate) + 3*rate"), 1.0, 10, tolerance=1e-8)
    # v = (v0 + c/d) exp(-d t) - c/d until v = 0
    stop = math.log(1.0 + 1.5) / 3.0
    way = (1.0 + 2.0 / 3.0) * (1.0 - math.exp(-3.0 * stop)) / 3.0 - 2.0 / 3.0 * stop
    assert both["A.x"][-1] - 5.0 == pytest.approx(way, abs=1e-8)


def by_hand() -> np.ndarray:
    """Angle, rate and energy taken of the braked pendulum at 2 s, by DOP853."""
    from scipy.interpolate import PchipInterpolator

    valve = PchipInterpolator([-4, -1, 0, 1, 4], [-2.5, -1, 0, 1.5, 3])

    def law(angle: float, rate: float) -> float:
        return float(valve(rate)) + 0.3 * rate * angle**2

    def motion(_: float, y: np.ndarray) -> list[float]:
        return [
            y[1], (-9.81 * math.cos(y[0]) - law(y[0], y[1])) / 1.3, law(y[0], y[1]) * y[1]
        ]  # fmt: skip

    found = solve_ivp(motion, (0.0, 2.0), [0.0, 0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-14)
    assert np.abs(found.y[1]).max() < 4.0  # within the points
    return found.y[:, -1]


@pytest.mark.parametrize("method", ["conserving", "fastest"])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
def test_a_measured_brake_at_a_hinge_keeps_a_tolerance(tolerance: float, method: str) -> None:
    found = run(PENDULUM, 2.0, 10, tolerance=tolerance, method=method)
    right = by_hand()
    assert abs(found["hinge.angle"][-1] - right[0]) < 3.0 * tolerance * 2.0
    assert abs(found["hinge.angular_velocity"][-1] - right[1]) < 3.0 * tolerance * 4.0
    assert abs(found["energy.dissipated"][-1] - right[2]) < 3.0 * tolerance * 10.0
    assert found["energy.error"][-1] < 1e-13


SLOW = """
name = "slow"
dimension = 2
[bodies]
wheel = {{ mass = 1, inertia = 0.05, position = [0, 0], angular_velocity = 0.1256 }}
[joints]
hinge = {{ type = "revolute", bodies = ["ground", "wheel"], position = [0, 0] }}
[forces]
spring = {{ type = "torsion_spring", joint = "hinge", stiffness = 11 }}
push = {{ type = "joint_torque", joint = "hinge", value = "13.6*sin(0.7*t) + 2.2" }}
brake = {{ type = "torsion_damper", joint = "hinge", torque = "45*rate{kink}" }}
"""


@pytest.mark.parametrize("tolerance", [1e-4, 1e-8])
@pytest.mark.parametrize("kink", ["", " + max(rate - 50, 0)"], ids=["smooth", "kink"])
def test_a_kink_that_is_never_reached_changes_no_error(kink: str, tolerance: float) -> None:
    """What a strong brake slows down to follows the push: an estimate must know that it is slow."""
    times = np.linspace(0.0, 2.0, 21)
    right = solve_ivp(
        lambda t, y: [y[1], (-11 * y[0] + 13.6 * math.sin(0.7 * t) + 2.2 - 45 * y[1]) / 0.05],
        (0.0, 2.0), [0.0, 0.1256], method="Radau", rtol=1e-12, atol=1e-14, t_eval=times,
    ).y  # fmt: skip
    found = run(SLOW.format(kink=kink), 2.0, 20, order=4, tolerance=tolerance)
    for name, row in zip(["hinge.angle", "hinge.angular_velocity"], right, strict=True):
        assert np.abs(found[name] - row).max() < 3.0 * tolerance * np.abs(row).max()


def test_no_law_gives_energy_in_any_step() -> None:
    """Random laws, masses, springs and steps: what dampers take never falls, and all is booked."""
    rng = np.random.default_rng(5)
    for _ in range(60):
        a, b, c = 10.0 ** rng.uniform(-3, 3, 3)
        law = f"{a}*rate + {b}*rate*abs(rate) + {c}*tanh(10*rate)*length"
        mass, stiffness = 10.0 ** rng.uniform(-2, 2), 10.0 ** rng.uniform(0, 4)
        text = f"""
name = "random"
dimension = 2
[points]
A = {{ position = [1, 0], velocity = {rng.normal(size=2).tolist()}, mass = {mass} }}
[forces]
s = {{ type = "spring", points = ["ground", "A"], at = [0, 0.3], stiffness = {stiffness} }}
d = {{ type = "damper", points = ["ground", "A"], at = [0.5, 1], force = "{law}" }}
"""
        found = run(text, 1.0, 20, order=int(rng.choice([2, 4, 6, 8])), internal_step=0.05)
        assert np.all(np.diff(found["energy.dissipated"]) >= 0.0)
        # Springs that turn by 16 rad in a step have round-off of 2e-12; with linear dampers, too.
        assert found["energy.error"].max() < 5e-12


def test_a_law_that_pushes_is_refused_with_the_place() -> None:
    with pytest.raises(SceneError, match=r"0\.03\d* at a rate of -?0\.3\d+, and would push"):
        solver.assemble(solver.loads(SHOT.format(law="rate**3 - 0.2*rate")))


def test_a_law_that_jumps_with_the_motion_is_refused() -> None:
    with pytest.raises(SceneError, match="it would jump where a condition"):
        solver.assemble(solver.loads(SHOT.format(law="rate*(2 if length > 5.2 else 1)")))


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ("", "'damping' is missing"),
        ('damping = 1.0, force = "rate"', "a damper has a damping or a force, not both"),
        ('force = "2.0"', "mentions no 'rate'"),
        ('force = "2.0*rte"', "unknown"),
    ],
)
def test_a_damper_is_written_one_way(fields: str, words: str) -> None:
    text = SHOT.format(law="rate").replace(', force = "rate"', f", {fields}" if fields else "")
    with pytest.raises(SceneError, match=words):
        solver.loads(text)


@pytest.mark.parametrize("settings", ["step_size = 0.01", "step_size = 0.01\norder = 4"])
def test_dampers_before_an_energy_of_another_quantity_book_what_they_take(settings: str) -> None:
    """Each reads its own quantity, in whatever order they stand; all that is lost is taken."""
    damper = (
        'shock = { type = "damper", points = ["ground", "lever.end"], at = [2.8, 0.4], '
        'force = "400*rate + 10*rate**3" }\n'
    )
    well = 'well = { type = "potential", value = "30*hinge.angle**2" }\n'
    text = """
name = "lever"
dimension = 2
gravity = [0, -9.81]
[bodies]
lever = { mass = 4, inertia = 0.2, position = [2.4, 0], points = { end = [0.4, 0] } }
[joints]
hinge = { type = "revolute", bodies = ["ground", "lever"], position = [2, 0] }
[forces]
"""
    for forces in (damper + well, well + damper):
        scene = solver.loads(f"{text}{forces}[solver]\n{settings}\n")
        found = holonom.simulate(scene, stop_time=0.2)
        assert found["energy.dissipated"][-1] > 0.1
        assert np.abs(found["energy.balance"]).max() < 1e-13
