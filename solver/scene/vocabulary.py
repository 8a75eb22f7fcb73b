"""The words of a scene: what the reader hands out, checked and with every default filled in.

Lengths in m, masses in kg, times in s, forces in N, angles in rad. A vector has as many numbers as
the scene has dimensions. A ``Number`` that is not a float depends on parameters or, where
``numbers`` allows it, on inputs, the time ``t`` and the mechanism's own quantities.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, make_dataclass
from typing import TYPE_CHECKING, Any, Literal, NoReturn

from solver.options import OPTIONS
from solver.scene.expression import Number
from solver.scene.report import Problem, SceneError, Source
from solver.scene.vocabulary_forces import Driver, ForceElement
from solver.scene.vocabulary_joints import Constraint, Joint
from solver.scene.vocabulary_parts import Body, Input, Parameter, Point, Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Output:
    """An expression over the mechanism, computed at every communication point."""

    value: Number
    unit: str = ""
    description: str = ""


if TYPE_CHECKING:

    class SolverSettings:
        """The settings of `solver.options`."""

        def __init__(self, **settings: Any) -> None: ...
        def __getattr__(self, name: str) -> Any: ...

else:
    SolverSettings = make_dataclass(
        "SolverSettings",
        [(name, type(o.default), field(default=o.default)) for name, o in OPTIONS.items()],
        frozen=True,
        kw_only=True,
    )
    SolverSettings.__module__ = __name__
    SolverSettings.__doc__ = """The settings of `solver.options`; each is a parameter of the FMU."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Experiment:
    """Default run of the FMU."""

    start_time: float = 0.0
    stop_time: float = 1.0
    step_size: float = 0.1
    """Communication step in s."""
    tolerance: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """A mechanism as its author describes it: complete, and free of contradictions in words."""

    name: str
    description: str = ""
    dimension: Literal[2, 3] = 3
    gravity: Vector = (0.0, 0.0, 0.0)
    parameters: dict[str, Parameter] = field(default_factory=dict)
    inputs: dict[str, Input] = field(default_factory=dict)
    points: dict[str, Point] = field(default_factory=dict)
    bodies: dict[str, Body] = field(default_factory=dict)
    joints: dict[str, Joint] = field(default_factory=dict)
    constraints: dict[str, Constraint] = field(default_factory=dict)
    forces: dict[str, ForceElement] = field(default_factory=dict)
    drivers: dict[str, Driver] = field(default_factory=dict)
    outputs: dict[str, Output] = field(default_factory=dict)
    solver: SolverSettings = field(default_factory=SolverSettings)
    experiment: Experiment = field(default_factory=Experiment)
    source: Source = field(default_factory=Source, repr=False, compare=False)
    """The text it was read from, so that later findings can name file and line."""
    warnings: tuple[Problem, ...] = field(default=(), repr=False, compare=False)
    """What is legal in that text and seldom meant."""

    def sentences(self) -> tuple[str, ...]:
        """Each warning as it is reported, with its line and help."""
        return tuple(map(self.source.report, self.warnings))

    def error(self, location: str, message: str, help: str | None = None) -> Problem:
        """Describe a mistake found later, such as a rod of zero length, with its line."""
        return self.source.problem(location, message, help)

    def fail(self, problems: Iterable[Problem]) -> NoReturn:
        """Raise ``SceneError`` with all these mistakes, each with its source line."""
        raise SceneError(problems, self.source)
