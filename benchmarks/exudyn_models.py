"""Mechanisms of `scenes/` as an engineer would write them for Exudyn.

Nothing of holonom is used here, so that the models serve as an oracle and as a peer, in any
interpreter that has `exudyn`. Where a scene has a redundant row, its joint lacks that row here.
"""

from __future__ import annotations

import math

import numpy as np
from exudyn.utilities import (
    InertiaCuboid,
    InertiaMassPoint,
    RigidBodyInertia,
    RotationMatrixX,
    RotationMatrixY,
)

from benchmarks.exudyn_system import Drawing, Vector


def _compact(mass: float, moments: Vector, com: Vector = (0.0, 0.0, 0.0)) -> RigidBodyInertia:
    """Principal moments [kg m2] about the centre of mass."""
    tensor = np.diag(np.array(moments, dtype=float))
    return RigidBodyInertia(mass, tensor, np.array(com, dtype=float), inertiaTensorAtCOM=True)


def _box(mass: float, a: float, b: float, c: float) -> RigidBodyInertia:
    return InertiaCuboid(mass / (a * b * c), [a, b, c])


# ------------------------------------------------------------------------------------- mechanisms

X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]


def bricard() -> Drawing:
    """`scenes/bricard.toml`; the sixth hinge leaves one rotation across its axis to the others."""
    drawing = Drawing((0.0, -9.81, 0.0))
    long = {"x": (1.0, 0.1, 0.1), "y": (0.1, 1.0, 0.1), "z": (0.1, 0.1, 1.0)}
    middles = [(0.5, 0, 0), (1, -0.5, 0), (1, -1, 0.5), (0.5, -1, 1), (0, -0.5, 1)]
    rods = [
        drawing.body(middle, _box(1.0, *long[axis]))
        for middle, axis in zip(middles, "xyzxy", strict=True)
    ]
    corners = [(0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1)]
    for i, (corner, axis) in enumerate(zip(corners, [Y, Z, X, Y, Z], strict=True)):
        before = rods[i - 1] if i else drawing.ground
        drawing.joint("Revolute", [before, rods[i]], corner, axis=axis)
    loose = [1, 1, 1, 0, 1, 0]
    drawing.joint("Generic", [rods[4], drawing.ground], (0, 0, 1), constrainedAxes=loose)
    drawing.watch("rod3.end", rods[2], (0, 0, 0.5))
    return drawing


def heavy_top() -> Drawing:
    """`scenes/heavy_top.toml`, its origin in the centre of mass."""
    drawing = Drawing((0.0, 0.0, -20.0))
    turn = RotationMatrixX(0.05)
    spin = turn @ np.array([0.0, 0.0, 50.0])
    top = drawing.body(
        turn @ np.array([0.0, 0.0, 1.0]),
        _compact(1.0, (4, 4, 1)),
        referenceRotationMatrix=turn,
        initialVelocity=[0.0, 0.0, 0.0],
        initialAngularVelocity=list(spin),
    )
    drawing.joint("Spherical", [drawing.ground, top], (0, 0, 0))
    drawing.watch("top.nose", top)
    drawing.watch("top.side", top, (1, 0, -1))
    return drawing


def _slider_crank(driven: bool) -> Drawing:
    drawing = Drawing()
    ground, speed = drawing.ground, 150.0
    crank = drawing.body(
        (0.075, 0, 0),
        InertiaCuboid(7870, [0.15, 0.01, 0.01]),
        initialVelocity=[0, 0.075 * speed, 0],
        initialAngularVelocity=[0, 0, speed],
    )
    rod = drawing.body(
        (0.3, 0, 0),
        _compact(0.151104, (1e-6, 0.0045339259, 0.0045339259)),
        initialVelocity=[0, 0.075 * speed, 0],
        initialAngularVelocity=[0, 0, -0.5 * speed],
    )
    slider = drawing.body((0.45, 0, 0), _compact(0.075552, (1e-5, 1e-5, 1e-5)))
    if driven:
        motor = drawing.joint(
            "Generic",
            [ground, crank],
            (0, 0, 0),
            offsetUserFunction=lambda _mbs, t, _item, _parameters: [0, 0, 0, 0, 0, speed * t],
        )
        drawing.watch_torque("motor", motor)
    else:
        drawing.joint("Revolute", [ground, crank], (0, 0, 0), axis=Z)
    # The hinge at the wrist already holds the rod in its plane.
    drawing.joint("Spherical", [crank, rod], (0.15, 0, 0), constrainedAxes=[1, 1, 0])
    drawing.joint("Revolute", [rod, slider], (0.45, 0, 0), axis=Z)
    drawing.joint("Prismatic", [ground, slider], (0.45, 0, 0), axis=X)
    drawing.system.CreateSpringDamper(
        itemNumbers=[ground, slider],
        localPosition0=[0.7, 0, 0],
        referenceLength=0.2,
        stiffness=500.0,
    )
    drawing.watch("slider", slider)
    drawing.watch("crank.pin", crank, (0.075, 0, 0))
    return drawing


def spatial_slider_crank() -> Drawing:
    """`scenes/spatial_slider_crank.toml`, driven at a constant 150 rad/s."""
    return _slider_crank(driven=True)


def free_slider_crank() -> Drawing:
    """The same without its motor, let go at 150 rad/s."""
    return _slider_crank(driven=False)


def flyball_governor() -> Drawing:
    """`scenes/flyball_governor.toml`; each ball is a part of its rod."""
    drawing = Drawing()
    ground, speed, alpha, density = drawing.ground, 2 * math.pi, math.pi / 6, 3000.0
    turning = {"initialAngularVelocity": [0, 0, speed]}
    post = InertiaCuboid(density, [0.01, 0.01, 1])
    shaft = drawing.body((0, 0, 0.5), post, **turning)
    slider = drawing.body((0, 0, 0.5), InertiaCuboid(density, [0.1, 0.1, 0.1]), **turning)
    x, z = 0.05 + 0.5 * math.cos(alpha), 1 - 0.5 * math.sin(alpha)
    drawing.joint("Revolute", [ground, shaft], (0, 0, 0), axis=Z)
    drawing.joint("Prismatic", [shaft, slider], (0, 0, 0.5), axis=Z)
    for side in (1, -1):
        ball = InertiaMassPoint(5.0).Translated([0.5 * side, 0, 0])
        rod = drawing.body(
            (side * x, 0, z),
            InertiaCuboid(density, [1, 0.01, 0.01]) + ball,
            referenceRotationMatrix=RotationMatrixY(side * alpha),
            initialVelocity=[0, side * speed * x, 0],
            **turning,
        )
        drawing.joint("Revolute", [shaft, rod], (0.05 * side, 0, 1), axis=Y)
        drawing.system.CreateSpringDamper(
            itemNumbers=[slider, rod],
            localPosition0=[0.05 * side, 0, 0],
            referenceLength=0.5,
            stiffness=8e5,
            damping=4e4,
        )
        if side == 1:
            drawing.watch("right_ball", rod, (0.5, 0, 0))
    drawing.watch("slider", slider)
    return drawing


ROAD = "0.03*(1 - cos(6*t))"
"""Height of the road [m] in `double_wishbone`."""


def _road(_system: object, t: float, _item: int, _offset: float) -> float:
    return 0.03 * (1 - math.cos(6 * t))


def double_wishbone(wavy: bool = True) -> Drawing:
    """`scenes/double_wishbone.toml` on the road `ROAD` or on a flat one.

    The axle is a part of the upright.
    """
    drawing = Drawing()
    system, ground = drawing.system, drawing.ground
    car = drawing.body((0, 0, 0.5), _compact(400, (40, 40, 40)))
    lower = drawing.body((0, -0.5, 0.21), _compact(4, (0.04, 0.03, 0.06)))
    upper = drawing.body((-0.01, -0.52, 0.43), _compact(2, (0.01, 0.01, 0.02)))
    axle = InertiaMassPoint(5.0).Translated([0, -0.05, 0])
    upright = drawing.body((0, -0.7, 0.31), _compact(20, (0.5, 0.7, 0.5)) + axle)
    drawing.joint("Prismatic", [ground, car], (0, 0, 0.5), axis=Z)
    drawing.joint("Revolute", [car, lower], (0, -0.35, 0.22), axis=X)
    drawing.joint("Revolute", [car, upper], (0, -0.4, 0.44), axis=[1, 0, 0.05])
    drawing.joint("Spherical", [lower, upright], (0, -0.7, 0.2))
    drawing.joint("Spherical", [upper, upright], (-0.02, -0.65, 0.43))
    rack, steer = [-0.15, -0.35, -0.28], [-0.15, 0.02, -0.08]
    system.CreateDistanceConstraint(
        itemNumbers=[car, upright], localPosition0=rack, localPosition1=steer
    )
    patch = system.CreateMassPoint(referencePosition=[0, -0.75, 0], mass=1.0)
    for axis in range(3):
        system.CreateCoordinateConstraint(
            itemNumbers=[None, patch],
            coordinates=[None, axis],
            offsetUserFunction=_road if wavy and axis == 2 else 0,
        )
    _struts(drawing, (lower, car), (patch, upright))
    drawing.watch("car", car)
    drawing.watch("axle", upright, (0, -0.05, 0))
    drawing.watch("upright", upright)
    return drawing


def _struts(drawing: Drawing, coil: tuple[int, int], tyre: tuple[int, int]) -> None:
    """Coil spring with damper between arm and car, and the tyre on its patch."""
    drawing.system.CreateSpringDamper(
        itemNumbers=list(coil),
        localPosition0=[0, -0.1, 0],
        localPosition1=[0, -0.45, 0.2],
        referenceLength=math.hypot(0.15, 0.49) + 5.9e3 / 60e3,
        stiffness=60e3,
        damping=5e3,
    )
    drawing.system.CreateSpringDamper(
        itemNumbers=list(tyre),
        localPosition1=[0, -0.05, 0],
        referenceLength=0.31 + 9.81 * 431 / 200e3,
        stiffness=200e3,
        damping=500.0,
    )


def flat_double_wishbone() -> Drawing:
    """Double wishbone on a flat road: without calls into Python."""
    return double_wishbone(wavy=False)
