"""Pendulums and open chains of unequal data under gravity."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tests.truth.minimal import Body, Number, Parts, cos, motion, sin
from tests.truth.system import Array, System, Values

G = 9.81


def _chain(
    name: str, lengths: Sequence[float], masses: Sequence[float], inertias: Sequence[float],
    angles: Sequence[float], stop: float, fails: dict[str, int] | None = None,
) -> System:  # fmt: skip
    """Bars hinged end to end, mass centres in their middles; angles [rad] are from +x."""
    ends = np.cumsum([[0.0, 0.0]] + [
        [a * np.cos(b), a * np.sin(b)] for a, b in zip(lengths, angles, strict=True)
    ], axis=0)  # fmt: skip
    lines = [f'name = "{name}"', "dimension = 2", f"gravity = [0, {-G}]", "[bodies]"]
    for i, (a, m, J, b) in enumerate(zip(lengths, masses, inertias, angles, strict=True)):
        x, y = ((ends[i] + ends[i + 1]) / 2).tolist()
        lines.append(
            f"b{i} = {{ position = [{x!r}, {y!r}], orientation = {b!r}, mass = {m}, inertia = {J}, "
            f"points = {{ a = [{-a / 2}, 0], e = [{a / 2}, 0] }} }}"
        )
    lines.append("[joints]")
    lines.append('j0 = { type = "revolute", points = ["ground", "b0.a"], at = [0, 0] }')
    lines += [
        f'j{i} = {{ type = "revolute", points = ["b{i - 1}.e", "b{i}.a"] }}'
        for i in range(1, len(lengths))
    ]

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        bodies, energy = [], 0.0
        x, y = 0.0, 0.0
        for a, m, J, b in zip(lengths, masses, inertias, q, strict=True):
            half = (a / 2 * cos(b), a / 2 * sin(b))
            bodies.append(Body(m, (x + half[0], y + half[1]), J, b))
            energy = energy + m * G * (y + half[1])
            x, y = x + 2 * half[0], y + 2 * half[1]
        return Parts(bodies, energy)

    def right(t: Array) -> Values:
        q, v = motion(mechanism, angles, [0.0] * len(angles), t)
        found = {f"b{i}.angle": q[:, i] for i in range(len(angles))}
        return found | {f"b{i}.angular_velocity": v[:, i] for i in range(len(angles))}

    return System(
        name=name, kind="pendulums", origin="DOP853 in the angles", scene="\n".join(lines),
        stop=stop, right=right, fails=fails or {},
    )  # fmt: skip


SYSTEMS = (
    _chain("compound_pendulum", [0.8], [1.5], [0.02], [0.4], 5.0, {"default": 46}),
    _chain(
        "double_pendulum_of_bars",
        [1.0, 0.3],
        [2.0, 0.5],
        [0.1, 0.01],
        [-1.0, -0.2],
        3.0,
        {"default": 46},
    ),
)
