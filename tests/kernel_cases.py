"""Mechanisms and methods on which the kernel is tried, and the settings of each method."""

from __future__ import annotations

from tests.joint_scenes import train
from tests.twins import EVERYTHING, FORMULATIONS, SCENES, model_of
from tests.zoo import PLANE, SPACE

SOURCES = {path.stem: path for path in SCENES}
SOURCES |= {f"everything in {dim}-D": text for dim, text in EVERYTHING.items()}
SOURCES["gears and a cam in the plane"] = (
    train(2, "gear", 0.01)
    + """
[constraints]
cam = { value = "frame.y + 0.3*exp(first.angle) - 0.5" }
"""
)
ZOO = {"zoo in the plane": PLANE, "zoo in space": SPACE}

LADDER = (
    *(f"{formulation} nested" for formulation in FORMULATIONS),
    "conserving-al simultaneous",
    "midpoint-al simultaneous",
    "conserving-al paper",
    "conserving-al unpaired",
)
"""For mechanisms of points and rods alone, which every formulation knows."""

METHODS = ("conserving-al nested", "conserving-al simultaneous", "conserving-al-beta nested")
"""For all others."""


def is_plain(source):
    """Whether a mechanism has no other rows than those of rods."""
    sizes = model_of(source).sizes
    return sizes["n_rows"] == sizes["n_form_rows"] and not sizes["n_bodies"]


PENALTY = 1e3
"""Of the penalty formulations. It multiplies what rounding leaves in Phi_n."""


def settings(method):
    """Settings of a method by its name in `METHODS`."""
    formulation, variant = method.split()
    chosen = {"formulation": formulation}
    if not formulation.endswith("-al"):
        chosen["penalty"] = PENALTY
    if variant == "simultaneous":
        chosen["algorithm"] = variant
    if variant == "paper":
        chosen["multiplier_update"] = variant
    if variant == "unpaired":
        chosen["paired"] = False
    return chosen
