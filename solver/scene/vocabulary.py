"""The words of a scene: what the reader hands out, checked and with every default filled in.

Lengths in m, masses in kg, times in s, forces in N, angles in rad. A vector has as many numbers as
the scene has dimensions. A ``Number`` that is not a float depends on parameters or, where
``numbers`` allows it, on inputs, the time ``t`` and the mechanism's own quantities.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal, NoReturn

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


@dataclass(frozen=True, slots=True, kw_only=True)
class SolverSettings:
    """The method and its settings; each is a parameter of the FMU as well."""

    formulation: str = "conserving-al"
    algorithm: str = "nested"
    multiplier_update: str = "end"
    order: int = 0
    """2, 4, 6 or 8: a step is a symmetric composition of 1, 5, 9 or 15 pairs; 0: chosen by the
    tolerance, and 2 without one."""
    paired: bool = True
    """Advance by pairs of half steps, which smooths velocities and multipliers."""
    step_size: float = 0.01
    """Internal step in s without a tolerance; at most the communication step."""
    tolerance: float = 0.0
    """Relative error of a run that orders and steps are chosen for, from 1e-14 to 0.1; 0: steps of
    `step_size`."""
    absolute_tolerance: float = 0.0
    """Error in m that is small enough, besides the relative one."""
    longest_step: float = 1e6
    """Longest internal step in s where the tolerance chooses."""
    newton_tolerance: float = 1e-12
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
    assemble: bool = False
    """Close a mechanism that is drawn inexactly, and make its velocities consistent."""
    start: str = "drawn"
    """"drawn", or "equilibrium": begin at rest in the static equilibrium next to it."""


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
