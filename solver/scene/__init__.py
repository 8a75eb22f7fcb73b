"""What a user writes: scene files, read and checked, with errors like a compiler's.

scene = load("double_pendulum.toml", {"length": 2.0, "points.A.mass": 3.0})
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from typing import Any, Literal

from solver.scene.expression import Expr, ExpressionError, Number, evaluate, parse, symbols
from solver.scene.report import Given, Problem, SceneError, SceneWarning, Source
from solver.scene.vocabulary import Experiment, Output, Scene, SolverSettings
from solver.scene.vocabulary_forces import (
    Damper,
    DistanceDriver,
    Driver,
    Force,
    ForceElement,
    Gravitation,
    JointDriver,
    JointTorque,
    PositionDriver,
    Potential,
    Spring,
    Torque,
    TorsionDamper,
    TorsionSpring,
)
from solver.scene.vocabulary_joints import (
    BodyJoint,
    ConstantAngle,
    Constraint,
    Distance,
    Gear,
    Joint,
    PointOn,
    Rack,
    Rolling,
)
from solver.scene.vocabulary_parts import (
    Bar,
    Body,
    Input,
    Parameter,
    Point,
    PointReference,
    Rigid,
    Vector,
)

__all__ = [
    "Bar", "Body", "BodyJoint", "ConstantAngle", "Constraint", "Damper", "Distance",
    "DistanceDriver", "Driver", "Experiment", "Expr", "ExpressionError", "Force",
    "ForceElement", "Gear", "Given", "Gravitation", "Input", "Joint", "JointDriver",
    "JointTorque", "Number", "Output", "Parameter", "Point", "PointOn", "PointReference",
    "PositionDriver", "Potential", "Problem", "Rack", "Rigid", "Rolling", "Scene", "SceneError",
    "SceneWarning", "SolverSettings", "Source", "Spring", "Torque", "TorsionDamper",
    "TorsionSpring", "Vector", "evaluate", "json_schema", "load", "loads", "parse", "symbols",
]  # fmt: skip


def load(path: str | os.PathLike[str], overrides: Mapping[str, object] | None = None) -> Scene:
    """Read a scene file.

    Parameters
    ----------
    path : path-like
        A ``.toml`` or ``.json`` file.
    overrides : mapping, optional
        New values by name: a parameter or input, ``"length"``, or any field of the scene,
        ``"points.A.mass"``. A value is a number or a text as it would stand in the file, or one of
        these as ``Given`` with the place that reports of mistakes in it shall name.

    Raises
    ------
    SceneError
        With every mistake in the file and the overrides.

    Warns
    -----
    SceneWarning
        Of what is legal and seldom meant; the scene keeps these as its `warnings`.
    """
    from solver.scene.reader import read_file  # pydantic takes a third of a second to import

    return _with_warnings(read_file(os.fspath(path), overrides or {}))


def loads(
    text: str,
    *,
    name: str = "scene.toml",
    format: Literal["toml", "json"] = "toml",
    overrides: Mapping[str, object] | None = None,
) -> Scene:
    """Read a scene from text; `name` stands for the file in reports. See ``load``."""
    from solver.scene.reader import read_text

    return _with_warnings(read_text(text, name, format, overrides or {}))


def _with_warnings(scene: Scene) -> Scene:
    """Give the warnings of a scene to Python, at the line that called this package's function."""
    for sentence in scene.sentences():
        warnings.warn(sentence, SceneWarning, stacklevel=3)
    return scene


def json_schema() -> dict[str, Any]:
    """JSON Schema of a scene file, for completion and checks in an editor."""
    from solver.scene.schema import json_schema

    return json_schema()
