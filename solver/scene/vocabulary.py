"""The words of a scene: what the reader hands out, checked and with every default filled in.

Lengths in m, masses in kg, times in s, forces in N, angles in rad. A vector has as many numbers as
the scene has dimensions. A ``Number`` that is not a float depends on parameters or, in forces and
outputs, on inputs, the time ``t`` and the mechanism's own quantities.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal, NoReturn, TypeAlias

from solver.scene.expression import Number
from solver.scene.report import Problem, SceneError, Source

Vector: TypeAlias = tuple[Number, ...]
"""As many numbers as the scene has dimensions."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter:
    """A number with a name, settable in the FMU."""

    value: Number
    """Default; an expression in other parameters makes it a calculated parameter."""
    unit: str = ""
    description: str = ""
    minimum: float | None = None
    maximum: float | None = None
    variability: Literal["fixed", "tunable"] = "fixed"
    """A tunable one may change during a run. Calculated from a tunable one means tunable."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Input:
    """A number that arrives from outside at every communication step."""

    start: float = 0.0
    unit: str = ""
    description: str = ""
    minimum: float | None = None
    maximum: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Point:
    """A point of the mechanism, free or fixed to the ground."""

    position: Vector
    velocity: Vector
    mass: Number = 0.0
    fixed: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A uniform slender rigid bar between two points."""

    points: tuple[str, str]
    mass: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class PointReference:
    """An end of a joint or force: a point, or a place on the ground."""

    point: str | None
    """Name of the point; None is the ground."""
    at: Vector | None = None
    """Place on the ground; None for a point."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Distance:
    """A massless rod: two points keep their distance."""

    points: tuple[PointReference, PointReference]
    length: Number | None = None
    """None: as drawn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Spring:
    """A linear spring between two points."""

    points: tuple[PointReference, PointReference]
    stiffness: Number
    free_length: Number | None = None
    """None: as drawn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Damper:
    """A linear damper between two points."""

    points: tuple[PointReference, PointReference]
    damping: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class Force:
    """A force on a point, in global axes."""

    point: str
    value: Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Torque:
    """A torque on a bar: one number in 2-D, a vector in global axes in 3-D."""

    body: str
    value: Number | Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Output:
    """An expression over the mechanism, computed at every communication point."""

    value: Number
    unit: str = ""
    description: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class SolverSettings:
    """The method and its settings; each is a parameter of the FMU as well."""

    formulation: str = "conserving-al"
    algorithm: str = "nested"
    multiplier_update: str = "end"
    order: int = 2
    paired: bool = True
    """Advance by pairs of half steps, which smooths velocities and multipliers."""
    step_size: float = 0.01
    """Internal step in s; at most the communication step."""
    tolerance: float = 1e-12
    """What a step must be solved to: Newton's error relative to the energy (in the energy norm),
    constraints relative to length squared."""
    penalty: float = 1e8
    """Penalty relative to the inertia term of each row; scaled with the step by the method."""
    xi: float = 1.0
    """Damping ratio of the `penalty-velocity` formulation."""
    omega: float = 10.0
    """Frequency in rad/s of the `penalty-velocity` formulation."""
    max_newton: int = 20
    max_uzawa: int = 20


@dataclass(frozen=True, slots=True, kw_only=True)
class Experiment:
    """Default run of the FMU."""

    start_time: float = 0.0
    stop_time: float = 1.0
    step_size: float = 0.1
    """Communication step in s."""
    tolerance: float | None = None


Joint: TypeAlias = Distance
Body: TypeAlias = Bar
ForceElement: TypeAlias = Spring | Damper | Force | Torque


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
    forces: dict[str, ForceElement] = field(default_factory=dict)
    outputs: dict[str, Output] = field(default_factory=dict)
    solver: SolverSettings = field(default_factory=SolverSettings)
    experiment: Experiment = field(default_factory=Experiment)
    source: Source = field(default_factory=Source, repr=False, compare=False)
    """The text it was read from, so that later findings can name file and line."""

    def error(self, location: str, message: str, help: str | None = None) -> Problem:
        """Describe a mistake found later, such as a rod of zero length, with its line."""
        return self.source.problem(location, message, help)

    def fail(self, problems: Iterable[Problem]) -> NoReturn:
        """Raise ``SceneError`` with all these mistakes, each with its source line."""
        raise SceneError(problems, self.source)
