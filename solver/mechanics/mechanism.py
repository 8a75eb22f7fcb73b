"""A mechanism as equations: nodes, masses, forms, quantities, rows, forces - all by index.

s = u . w,      sigma = s, sqrt(s) or atan2(s_2, s_1),      Phi(sigma, b(t)) = 0

Bodies, joints, forces and drivers add to it; ``Structure`` turns it into the arrays of a model.
Nodes are counted as they come; the order of a model (free, driven, fixed) is made at the end.

Most records are named tuples: a large mechanism has a million of them, and a frozen dataclass takes
three times as long to make.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from solver.mechanics.combination import Combination, node
from solver.mechanics.vectors import Vector, add, dot, perpendicular, scale, turned
from solver.runtime import layout
from solver.runtime.model import Row, Rule
from solver.scene import Expr, Number, evaluate
from solver.scene.expression import atan2, sqrt

FREE, DRIVEN, FIXED = 0, 1, 2
"""How a node moves."""
GIVEN = 2.0**26
"""Weight of a velocity that the scene gives, against 1, when velocities are made consistent.

The square of a power of 2, so that masses times it and back are what they were.
"""


@dataclass(slots=True)
class Node:
    """A point or direction: position as drawn [m or 1], velocity, shares of mass [kg]."""

    motion: int
    kind: int
    position: Vector
    velocity: Vector
    mass: Number = 0.0
    """Share in norms."""
    weight: Number = 0.0
    """Mass that gravity acts on."""
    velocity_weight: float = 1.0


class Form(NamedTuple):
    """s = u . w."""

    u: Combination
    w: Combination


class Quantity(NamedTuple):
    """A form, the length of one, or the angle of two (cosine, sine)."""

    kind: int
    forms: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Leaf:
    """What a formula depends on: a quantity's value or rate, or a signal."""

    kind: int
    index: int


class Formula(NamedTuple):
    """A number over leaves, which stand in it as the symbols of `leaf_symbol`."""

    value: Number
    leaves: tuple[Leaf, ...]
    damping: Number | None = None
    """Of the energy of a compliant contact, a power of its depth: share of the force per speed."""
    role: int = layout.STORES
    """Of a potential: whether it is an energy, or a force along its first leaf, and its account."""


class Kink(NamedTuple):
    """An operation on sensors that has a kink, and whose value over a step reads no side of it."""

    operation: Expr
    name: str
    """What it is called in a sentence."""
    is_of_energy: bool
    """Whether slopes over a step are exact across it."""


class Scale(NamedTuple):
    """A row's size, base extent^power: what its residual is compared with."""

    base: Number
    power: int


class FormRow(NamedTuple):
    """s - constant = 0."""

    form: int
    constant: Number
    scale: Scale
    row: Row


class Coincidence(NamedTuple):
    """u = 0."""

    form: int
    row: Row
    scale: Scale = Scale(1.0, 1)


class FunctionRow(NamedTuple):
    """A formula that is zero."""

    formula: Formula
    scale: Scale
    row: Row


class Element(NamedTuple):
    """Force k (sigma - rest) + c dsigma/dt - drive along a quantity."""

    quantity: int
    stiffness: Number = 0.0
    rest: Number = 0.0
    damping: Number = 0.0
    drive: Number = 0.0
    sampled: str = ""
    """What it is called in a sentence, if the drive reads the mechanism; likewise of loads."""

    @property
    def numbers(self) -> tuple[Number, ...]:
        """All that its law contains."""
        return self.stiffness, self.rest, self.damping, self.drive


class Load(NamedTuple):
    """A force on a link, in global axes (None) or in those of the body with this first director."""

    form: int
    value: Vector
    axes: int | None
    sampled: str = ""


class Moment(NamedTuple):
    """A moment that turns a link: a bar, or a body in the plane."""

    form: int
    value: Vector
    sampled: str = ""


class BodyMoment(NamedTuple):
    """A moment on a spatial body with this first director, in global axes or its own."""

    node: int
    value: Vector
    body_axes: bool
    sampled: str = ""


class Friction(NamedTuple):
    """Coulomb friction: velocity rows that hold up to the cone, |T| <= coefficient N + preload."""

    rows: tuple[int, ...]
    """Indices of its 1 to 3 velocity rows, the slip rates."""
    normal: tuple[tuple[tuple[str, int], ...], ...]
    """Rows whose multipliers make the normal force: the sum of the norms of these groups."""
    sliding: Number
    static: Number
    preload: Number = 0.0
    smooth_speed: Number = 0.0
    """Slip over which the cone is smoothed; 0: it is not."""

    @property
    def numbers(self) -> tuple[Number, ...]:
        """All that its law contains."""
        return self.sliding, self.static, self.preload, self.smooth_speed


class Contact(NamedTuple):
    """A gap that never becomes negative: a row while it is closed."""

    row: int
    """Index of its function row; the gap is a distance or an angle."""
    restitution: Number
    friction: int = -1
    """Index among the frictions."""


class Held(NamedTuple):
    """A sampled state: what it takes at the ticks of its clock."""

    next: Number
    """Over sensors."""
    start: Number
    clock: Number
    """Counts the ticks: its whole part grows at each."""


Part = FormRow | Coincidence | FunctionRow | Element | Formula | Load | Moment | BodyMoment
"""What makes nodes depend on each other."""


@dataclass
class Mechanism:
    """Everything a model consists of, by index."""

    dim: int
    defaults: Mapping[str, float]
    """Values of the parameters and inputs, and the time, as the scene gives them."""
    varying: frozenset[str] = frozenset()
    """Symbols of formulas that change while it moves: time, inputs, tunable parameters."""
    nodes: list[Node] = field(default_factory=list)
    masses: dict[tuple[int, int], Number] = field(default_factory=dict)
    forms: list[Form] = field(default_factory=list)
    quantities: list[Quantity] = field(default_factory=list)
    active: dict[int, None] = field(default_factory=dict)
    """Quantities that rows, forces and sensors use, in the order of their use."""
    driven_signals: list[Number] = field(default_factory=list)
    """Coordinates of the driven nodes."""
    signals: list[Number] = field(default_factory=list)
    """Other prescribed values that rows contain."""
    form_rows: list[FormRow] = field(default_factory=list)
    coincidences: list[Coincidence] = field(default_factory=list)
    function_rows: list[FunctionRow] = field(default_factory=list)
    velocity_rows: list[FunctionRow] = field(default_factory=list)
    potentials: list[Formula] = field(default_factory=list)
    kinks: list[Kink] = field(default_factory=list)
    """Of the potentials."""
    elements: list[Element] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)
    moments: list[Moment] = field(default_factory=list)
    body_moments: list[BodyMoment] = field(default_factory=list)
    contacts: list[Contact] = field(default_factory=list)
    frictions: list[Friction] = field(default_factory=list)
    held: list[Held] = field(default_factory=list)
    rigid: list[tuple[int, ...]] = field(default_factory=list)
    """Nodes of each rigid body: its centre of mass and directors."""
    bodies: dict[int, int] = field(default_factory=dict)
    """Number of each body by its first director."""
    places: list[int] = field(default_factory=list)
    """Forms of measured places."""
    reactions: list[list[tuple[int, int, int]]] = field(default_factory=list)
    """Entries (kind, row, sign) of each joint."""
    rules: list[Rule] = field(default_factory=list)
    rule_numbers: list[Number] = field(default_factory=list)
    accelerates: bool = False
    """Whether accelerations are measured."""
    sensing: bool = False
    sensed: dict[str, str] = field(default_factory=dict)
    """Names of the quantities that sensors read, by the symbols of these."""
    _forms: dict[tuple[Combination, Combination], int] = field(default_factory=dict)
    _quantities: dict[Quantity, int] = field(default_factory=dict)
    _fixed: dict[tuple[int, Vector], int] = field(default_factory=dict)
    _signals: dict[Number, int] = field(default_factory=dict)

    # -------------------------------------------------------------------------------- nodes

    def default(self, number: Number) -> float:
        """Value of a number with the default parameters; branches are decided with these."""
        return evaluate(number, self.defaults) if isinstance(number, Expr) else float(number)

    def add_node(self, new: Node) -> int:
        """Add a node and return its index."""
        self.nodes.append(new)
        return len(self.nodes) - 1

    def fixed(self, kind: int, position: Vector) -> Combination:
        """Return a place or direction that does not move."""
        if (kind, position) not in self._fixed:
            rest = (0.0,) * self.dim
            self._fixed[kind, position] = self.add_node(Node(FIXED, kind, position, rest))
        return node(self._fixed[kind, position])

    def moves(self, combination: Combination) -> bool:
        """Whether any node of a combination moves."""
        return any([self.nodes[n].motion != FIXED for n, _, _ in combination.terms])

    def add_mass(self, a: int, b: int, mass: Number) -> None:
        """Couple two nodes by a mass, in both triangles; to nodes that stay it does nothing."""
        if FIXED in (self.nodes[a].motion, self.nodes[b].motion) or mass == 0.0:
            return
        for pair in {(a, b): None, (b, a): None}:
            self.masses[pair] = self.masses.get(pair, 0.0) + mass

    def drawn(self, combination: Combination) -> Vector:
        """Return the vector of a combination as drawn."""
        total: Vector = (0.0,) * self.dim
        for n, straight, turn in combination.terms:
            position = self.nodes[n].position
            total = tuple([x + straight * y for x, y in zip(total, position, strict=True)])
            if turn != 0.0:
                total = add(total, scale(turn, turned(position)))
        return total

    @cached_property
    def _columns(self) -> list[tuple[float, ...]]:
        """Coordinates of all points as drawn [m], by direction."""
        points = [node.position for node in self.nodes if node.kind == layout.NODE_POINT]
        return [*zip(*([self.default(x) for x in position] for position in points), strict=True)]

    @cached_property
    def round_off(self) -> float:
        """Distance of places that the round-off of a drawing explains [m]."""
        return layout.ONE_PLACE * (1.0 + max(abs(x) for column in self._columns for x in column))

    @cached_property
    def extent(self) -> float:
        """Diagonal of the box around all points as drawn [m]; 1 for a mechanism of one place."""
        sides = [max(column) - min(column) for column in self._columns]
        found = sum(side * side for side in sides) ** 0.5
        return found if found > self.round_off else 1.0

    def drawn_into(self, unit: str) -> float:
        """Return the penetration of a drawing that counts as none [m or rad]."""
        if unit == "rad":
            return layout.DRAWN_INTO
        return layout.DRAWN_INTO * self.extent + self.round_off

    def normals(self, axis: Vector) -> tuple[Vector, ...]:
        """Return the unit vectors perpendicular to one: two in space, one in the plane."""
        return (turned(axis),) if self.dim == 2 else perpendicular(axis, self.default)

    # ------------------------------------------------------------------- forms and quantities

    def form(self, u: Combination, w: Combination) -> tuple[int, int]:
        """Return the index of the form u . w, and -1 if u and w changed places, else 1.

        A side that does not move is w, so that the form is linear.
        """
        swapped = self.moves(w) and not self.moves(u)
        key = (w, u) if swapped else (u, w)
        index = self._forms.setdefault(key, len(self.forms))
        if index == len(self.forms):
            self.forms.append(Form(*key))
        return index, -1 if swapped else 1

    def link(self, u: Combination) -> int:
        """Return the form whose link is u: where a force acts, or what is measured."""
        return self.form(u, Combination())[0]

    def value(self, form: int) -> Number:
        """Return a form as drawn."""
        u, w = self.forms[form]
        drawn = self.drawn(u)
        return dot(drawn, drawn if w is u else self.drawn(w))

    def quantity(self, kind: int, *forms: int) -> int:
        """Return the index of a quantity."""
        key = Quantity(kind, forms)
        if key not in self._quantities:
            self._quantities[key] = len(self.quantities)
            self.quantities.append(key)
        return self._quantities[key]

    def length(self, u: Combination) -> int:
        """Return the quantity |u|."""
        return self.quantity(layout.QUANTITY_LENGTH, self.form(u, u)[0])

    def component(self, u: Combination, w: Combination) -> int:
        """Return the quantity u . w."""
        return self.quantity(layout.QUANTITY_FORM, self.form(u, w)[0])

    def angle(
        self, cosine: tuple[Combination, Combination], sine: tuple[Combination, Combination]
    ) -> int:
        """Return the angle whose cosine and sine are proportional to two forms."""
        return self.quantity(layout.QUANTITY_ANGLE, self.form(*cosine)[0], self.form(*sine)[0])

    def drawn_value(self, quantity: int) -> Number:
        """Return a quantity as drawn."""
        kind, forms = self.quantities[quantity].kind, self.quantities[quantity].forms
        values = [self.value(form) for form in forms]
        if kind == layout.QUANTITY_ANGLE:
            return atan2(values[1], values[0])
        return sqrt(values[0]) if kind == layout.QUANTITY_LENGTH else values[0]

    def length_power(self, quantity: int) -> int:
        """Return the power of length in a quantity's unit: 1 for m, 0 for rad."""
        kind, forms = self.quantities[quantity].kind, self.quantities[quantity].forms
        if kind != layout.QUANTITY_FORM:
            return int(kind == layout.QUANTITY_LENGTH)
        form = self.forms[forms[0]]
        return sum(
            any(self.nodes[n].kind == layout.NODE_POINT for n in side.nodes)
            for side in (form.u, form.w)
        )

    def use(self, quantity: int) -> int:
        """Say that a quantity takes part in the motion; return it."""
        self.active.setdefault(quantity)
        return quantity

    def leaf(self, quantity: int, kind: int = layout.LEAF_VALUE) -> Leaf:
        """Return a quantity, or its rate, as what a formula depends on."""
        return Leaf(kind, self.use(quantity))

    def signal(self, number: Number) -> int:
        """Return the index of a prescribed value among `signals`."""
        if number not in self._signals:
            self._signals[number] = len(self.signals)
            self.signals.append(number)
        return self._signals[number]

    # ------------------------------------------------------------------------ what joins nodes

    @property
    def parts(self) -> tuple[Sequence[Part], ...]:
        """All that makes nodes depend on each other: rows, then forces, each kind for itself."""
        rows = self.form_rows, self.coincidences, self.function_rows, self.velocity_rows
        return *rows, self.elements, self.potentials, self.loads, self.moments, self.body_moments

    def joined(self, part: Part) -> list[int]:
        """Return the moving nodes that depend on each other by a part."""
        match part:
            case FormRow() | Coincidence() | Moment():
                return self.moving(part.form)
            case Element():
                return self.moving(*self.quantities[part.quantity].forms)
            case Load():
                return [*self.moving(part.form), *self.directors(part.axes)]
            case BodyMoment():
                return self.directors(part.node)
        formula = part.formula if isinstance(part, FunctionRow) else part
        return self.moving(*self.forms_of(formula.leaves))

    def forms_of(self, leaves: Iterable[Leaf]) -> list[int]:
        """Return the forms of some leaves."""
        moving = [self.quantities[leaf.index] for leaf in leaves if leaf.kind != layout.LEAF_SIGNAL]
        return [form for quantity in moving for form in quantity.forms]

    def moving(self, *forms: int) -> list[int]:
        """Return the nodes of some forms that move."""
        nodes = self.nodes
        sides = [side for form in forms for side in self.forms[form]]
        return [n for side in sides for n, _, _ in side.terms if nodes[n].motion != FIXED]

    def directors(self, first: int | None) -> list[int]:
        """Return the nodes of the body with this first director."""
        return [] if first is None else [*range(first, first + (1 if self.dim == 2 else 3))]
