"""Rotors: bodies that turn fast about a fixed axis or by themselves."""

from __future__ import annotations

import numpy as np

from tests.truth.system import Array, System, Values


def _driven(torque: float, inertia: float, brake: float) -> System:
    """Rotor with a torque and a brake of viscous friction: J w' = T - b w."""
    text = f"""
        dimension = 2
        [bodies]
        r = {{ position = [0, 0], mass = 1, inertia = {inertia} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "r"], position = [0, 0] }}
        [forces]
        m = {{ type = "joint_torque", joint = "j", value = {torque} }}
        b = {{ type = "torsion_damper", joint = "j", damping = {brake} }}
    """

    def right(t: Array) -> Values:
        rate, settled = brake / inertia, torque / brake
        w = settled * -np.expm1(-rate * t)
        return {"r.angular_velocity": w, "j.angle": settled * t - w / rate}

    return System(
        name="rotor_with_brake", kind="rotors", origin="closed form: w = T/b (1 - exp(-b t/J))",
        scene=text, stop=1.0, right=right,
    )  # fmt: skip


def _unbalanced(speed: float, offset: float, inertia: float) -> System:
    """Rotor whose mass centre is off the axis: it turns evenly and pulls with m e w^2."""
    mass = 2.0
    text = f"""
        dimension = 2
        [bodies.r]
        position = [0, 0]
        mass = {mass}
        inertia = {inertia}
        center_of_mass = [{offset}, 0]
        angular_velocity = {speed}
        [joints]
        b = {{ type = "revolute", bodies = ["ground", "r"], position = [0, 0] }}
    """

    def right(t: Array) -> Values:
        pull = mass * offset * speed**2
        return {
            "b.angle": speed * t,
            "b.force.x": -pull * np.cos(speed * t),
            "b.force.y": -pull * np.sin(speed * t),
        }

    return System(
        name=f"unbalanced_rotor_{speed:g}", kind="rotors",
        origin="closed form: even turning, force m e w^2",
        scene=text, stop=2.0, right=right, internal_step=0.2 / speed,
    )  # fmt: skip


SYSTEMS = (_driven(2.4, 0.01, 0.02), _unbalanced(30.0, 0.02, 0.05), _unbalanced(200.0, 0.1, 0.5))
