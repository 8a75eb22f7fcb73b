"""`python -m examples.clearance`: a worn wrist pin, conserving beside a penalty contact.

The slider-crank of Flores, without gravity and drive: its pin of the connecting rod has 0.5 mm of
play in the slider and rebounds elastically, so that no energy may be lost. It runs as an FMU with
located impacts, and beside it with what most codes do: the midpoint rule and a stiff spring that
pushes where the pin has left its clearance, in three coordinates, both with the same steps.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np

from build_fmu import build
from build_fmu.printing import print_table
from build_fmu.run import run_fmu

CRANK, ROD, PLAY = 0.05, 0.12, 0.5e-3
"""Lengths and radial clearance [m]."""
MASSES, INERTIAS = (0.30, 0.21, 0.14), (1e-4, 2.5e-4)
"""Of crank, rod and slider [kg]; of crank and rod about their centres of mass [kg m2]."""
SPEED = 100.0
"""Of the crank at the start [rad/s]; the slider is at rest, the pin in the middle of its play."""
STOP, STEPS = 0.2, (1e-4, 2.5e-5)
STIFFNESS = 1e7
"""Of the penalty [N/m]: its contacts last some 20 times the longest step."""

SCENE = f"""
name = "worn_slider_crank"
dimension = 2
gravity = [0, 0]

[bodies.crank]
mass = {MASSES[0]}
inertia = {INERTIAS[0]}
position = [{CRANK / 2}, 0]
velocity = [0, {SPEED * CRANK / 2}]
angular_velocity = {SPEED}

[bodies.rod]
mass = {MASSES[1]}
inertia = {INERTIAS[1]}
position = [{CRANK + ROD / 2}, 0]
velocity = [0, {SPEED * CRANK / 2}]
angular_velocity = {-SPEED * CRANK / ROD}
points = {{ pin = [{ROD / 2}, 0] }}

[bodies.slider]
mass = {MASSES[2]}
inertia = 1e-4
position = [{CRANK + ROD}, 0]

[joints]
bearing = {{ type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }}
knee = {{ type = "revolute", bodies = ["crank", "rod"], position = [{CRANK}, 0] }}
guide = {{ type = "prismatic", bodies = ["ground", "slider"], position = [{CRANK + ROD}, 0], axis = [1, 0] }}

[contacts]
wrist = {{ type = "clearance", points = ["rod.pin", "slider"], radius = {PLAY}, restitution = 1.0 }}

[solver]
step_size = {STEPS[0]}
max_events = 1000

[experiment]
stop_time = {STOP}
step_size = 1e-3
"""  # noqa: E501


def main() -> int:
    """Build the FMU, run both, and print what each keeps; exit code 0 if the FMU keeps it."""
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder, "worn_slider_crank.toml")
        scene.write_text(SCENE, encoding="utf-8")
        fmu = build(scene, scene.with_suffix(".fmu"))
        runs = [(f"holonom, {1e6 * h:g} us", *with_impacts(fmu, h)) for h in STEPS]
    runs += [(f"midpoint and penalty, {1e6 * h:g} us", *with_a_penalty(h)) for h in STEPS]
    rows = [
        (name, f"{count}", f"{energy[-1]:.12f}", f"{np.ptp(energy) / energy[0]:.1e}")
        for name, energy, count in runs
    ]
    title = f"slider-crank with {1e3 * PLAY:g} mm of play, elastic, after {STOP:g} s"
    print_table(title, ("", "impacts", "energy [J]", "its range over the first"), rows)
    drift = max(np.ptp(energy) / energy[0] for name, energy, _ in runs if "holonom" in name)
    return 0 if drift <= 1e-12 else 1


def with_impacts(fmu: Path, h: float) -> tuple[np.ndarray, int]:
    """Energy at the communication points [J] and number of impacts of a run of the FMU."""
    values = run_fmu(fmu, settings={"solver.step_size": h}).values
    return values["energy.total"], round(values["wrist.impacts"][-1])


def with_a_penalty(h: float) -> tuple[np.ndarray, int]:
    """Return the same of the implicit midpoint rule with a stiff spring beyond the clearance."""
    q = np.array([0.0, 0.0, CRANK + ROD])  # angles of crank and rod, place of the slider
    v = np.array([SPEED, -SPEED * CRANK / ROD, 0.0])
    momentum, energies, hits, inside = mass(q) @ v, [], 0, True
    for _ in range(round(STOP / h)):
        middle, rate = q + 0.5 * h * v, v
        for _ in range(30):  # fixed point in the middle of the step
            rate = np.linalg.solve(mass(middle), momentum + 0.5 * h * push(middle, rate))
            middle = q + 0.5 * h * rate
        momentum = momentum + h * push(middle, rate)
        q = 2.0 * middle - q
        v = np.linalg.solve(mass(q), momentum)
        hits += inside and depth(q) > 0.0
        inside = depth(q) <= 0.0
        energies.append(0.5 * v @ mass(q) @ v + 0.5 * STIFFNESS * max(depth(q), 0.0) ** 2)
    return np.array(energies), hits


def mass(q: np.ndarray) -> np.ndarray:
    """Mass matrix of crank, rod and slider."""
    (m1, m2, m3), (J1, J2) = MASSES, INERTIAS
    coupling = 0.5 * m2 * CRANK * ROD * np.cos(q[0] - q[1])
    crank = J1 + (0.25 * m1 + m2) * CRANK**2
    return np.array([[crank, coupling, 0], [coupling, J2 + 0.25 * m2 * ROD**2, 0], [0, 0, m3]])


def depth(q: np.ndarray) -> float:
    """How far the pin is beyond its clearance [m]."""
    x = CRANK * np.cos(q[0]) + ROD * np.cos(q[1]) - q[2]
    return float(np.hypot(x, CRANK * np.sin(q[0]) + ROD * np.sin(q[1]))) - PLAY


def push(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Rate of the momenta dT/dv: the force of the spring, and dT/dq."""
    turning = -0.5 * MASSES[1] * CRANK * ROD * np.sin(q[0] - q[1]) * v[0] * v[1]
    inertial = np.array([turning, -turning, 0.0])
    if depth(q) <= 0.0:
        return inertial
    x = CRANK * np.cos(q[0]) + ROD * np.cos(q[1]) - q[2]
    y = CRANK * np.sin(q[0]) + ROD * np.sin(q[1])
    reach = np.hypot(x, y)
    gradient = np.array(
        [
            (-x * CRANK * np.sin(q[0]) + y * CRANK * np.cos(q[0])) / reach,
            (-x * ROD * np.sin(q[1]) + y * ROD * np.cos(q[1])) / reach,
            -x / reach,
        ]
    )
    return inertial - STIFFNESS * depth(q) * gradient


if __name__ == "__main__":
    sys.exit(main())
