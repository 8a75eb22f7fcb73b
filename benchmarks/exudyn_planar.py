"""Planar mechanisms and mechanisms of any size, as an engineer would write them for Exudyn."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from exudyn.itemInterface import (
    LoadMassProportional,
    LoadTorqueVector,
    MarkerBodyMass,
    MarkerBodyPosition,
    MarkerBodyRigid,
    NodeRigidBody2D,
    ObjectJointRevolute2D,
    ObjectRigidBody2D,
)
from exudyn.utilities import InertiaCuboid

from benchmarks.exudyn_system import Drawing

Place = tuple[int, Sequence[float]]
"""A body and a place in its axes [m], from its centre of mass."""


def _body(
    drawing: Drawing,
    position: Sequence[float],
    mass: float,
    inertia: float,
    angle: float = 0.0,
    velocity: Sequence[float] = (0.0, 0.0, 0.0),
) -> int:
    """Planar body with its centre of mass at a position; velocities vx, vy [m/s], omega [rad/s]."""
    drawing.bodies += 1
    system = drawing.system
    node = system.AddNode(
        NodeRigidBody2D(referenceCoordinates=[*position, angle], initialVelocities=list(velocity))
    )
    body = system.AddObject(ObjectRigidBody2D(mass=mass, inertia=inertia, nodeNumber=node))
    if any(drawing.gravity):
        marker = system.AddMarker(MarkerBodyMass(bodyNumber=body))
        system.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=drawing.gravity))
    return body


def _pin(drawing: Drawing, *places: Place) -> None:
    """Hinge between two bodies."""
    markers = [
        drawing.system.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=[*place, 0]))
        for body, place in places
    ]
    drawing.system.AddObject(ObjectJointRevolute2D(markerNumbers=markers))


def n_four_bar(n: int) -> Drawing:
    """IFToMM benchmark A02, as `scenes.generate.n_four_bar`."""
    drawing, moment = Drawing((0.0, -9.81, 0.0)), 1.0 / 12.0
    upright = math.pi / 2
    cranks = [
        _body(drawing, (i, 0.5), 1.0, moment, upright, (0.5, 0.0, -1.0)) for i in range(n + 1)
    ]
    for i, crank in enumerate(cranks):
        _pin(drawing, (drawing.ground, (i, 0)), (crank, (-0.5, 0)))
    for i in range(n):
        coupler = _body(drawing, (i + 0.5, 1), 1.0, moment, 0.0, (1.0, 0.0, 0.0))
        _pin(drawing, (cranks[i], (0.5, 0)), (coupler, (-0.5, 0)))
        _pin(drawing, (cranks[i + 1], (0.5, 0)), (coupler, (0.5, 0)))
    return drawing


def planar_chain(n: int) -> Drawing:
    """`scenes.generate.rigid_chain` in the plane."""
    drawing = Drawing((0.0, -9.81, 0.0))
    last, end = drawing.ground, (0.0, 0.0)
    for i in range(n):
        link = _body(drawing, (0.1 * i + 0.05, 0), 0.1, 0.1 * 0.1**2 / 12)
        _pin(drawing, (last, end), (link, (-0.05, 0)))
        last, end = link, (0.05, 0.0)
    return drawing


def spatial_chain(n: int) -> Drawing:
    """`scenes.generate.rigid_chain` in space, hinges about y, z, y, ..."""
    drawing = Drawing()
    last = drawing.ground
    box = InertiaCuboid(0.1 / (0.1 * 0.02 * 0.02), [0.1, 0.02, 0.02])
    for i in range(n):
        link = drawing.body((0.1 * i + 0.05, 0, 0), box)
        axis = [0, 0, 1] if i % 2 else [0, 1, 0]
        drawing.joint("Revolute", [last, link], (0.1 * i, 0, 0), axis=axis)
        last = link
    return drawing


# ------------------------------------------------------------------------------------------ Andrews

A, B, C = np.array([-0.06934, -0.00227]), np.array([-0.03635, 0.03273]), [0.014, 0.072, 0]


def _turned(angle: float, place: Sequence[float]) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * place[0] - s * place[1], s * place[0] + c * place[1]])


def andrews() -> Drawing:
    """`scenes/andrews.toml`: seven bodies, data of the Test Set for IVP Solvers."""
    drawing = Drawing((0.0, 0.0, 0.0))
    beta, gamma, phi = -0.0617138900142764496, 0.455279819163070380, 0.222668390165885885
    delta, epsilon = 0.487364979543842550, 1.23054744454982119
    origin = np.zeros(2)
    lower = A + _turned(epsilon - math.pi / 2, (0.04, 0))
    upper, tilt = A + _turned(delta, (0.04, 0)), phi + delta - math.pi / 2
    rows = {
        "K1": (origin, beta, 0.04325, 2.194e-6, (0.00092, 0)),
        "K2": (_turned(beta, (0.007, 0)), beta + math.pi, 0.00365, 4.410e-7, (0.0115, 0)),
        "K3": (B, gamma - math.pi / 2, 0.02373, 5.255e-6, (0.01874, 0.01043)),
        "K4": (upper, tilt, 0.00706, 5.667e-7, (0.00579, 0)),
        "K5": (A, delta, 0.07050, 1.169e-5, (0.02308, 0.00916)),
        "K6": (lower, epsilon - phi, 0.00706, 5.667e-7, (0.00579, 0)),
        "K7": (A, epsilon - math.pi / 2, 0.05498, 1.912e-5, (0.01228, -0.00449)),
    }  # fmt: skip
    bodies = {
        name: _body(drawing, place + _turned(angle, com), mass, inertia, angle)
        for name, (place, angle, mass, inertia, com) in rows.items()
    }

    def at(name: str, x: float, y: float = 0.0) -> Place:
        """Place from the body's origin."""
        com = rows[name][4]
        return bodies[name], (x - com[0], y - com[1])

    for name, place in (("K1", origin), ("K3", B), ("K5", A), ("K7", A)):
        _pin(drawing, (drawing.ground, tuple(place)), at(name, 0))
    _pin(drawing, at("K1", 0.007), at("K2", 0))
    _pin(drawing, at("K5", 0.04), at("K4", 0))
    _pin(drawing, at("K7", 0.04), at("K6", 0))
    for name, x in (("K3", 0.035), ("K4", 0.02), ("K6", 0.02)):
        _pin(drawing, at("K2", 0.028), at(name, x))
    _drive(drawing, bodies["K1"], at("K3", 0.018, 0.02))
    drawing.watch("crank", bodies["K1"])
    return drawing


def _drive(drawing: Drawing, crank: int, spring: Place) -> None:
    """Motor of 0.033 N m on the crank, spring to the fixed point C."""
    system = drawing.system
    marker = system.AddMarker(MarkerBodyRigid(bodyNumber=crank))
    system.AddLoad(LoadTorqueVector(markerNumber=marker, loadVector=[0, 0, 0.033]))
    system.CreateSpringDamper(
        itemNumbers=[spring[0], drawing.ground],
        localPosition0=[*spring[1], 0],
        localPosition1=C,
        referenceLength=0.07785,
        stiffness=4530.0,
    )
