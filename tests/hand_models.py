"""Models written by hand, entry by entry: what no scene has at once, and what it would refuse."""

from __future__ import annotations

from array import array
from collections.abc import Mapping, Sequence

import numpy as np

from solver.options import DEFAULTS
from solver.runtime import Model
from solver.runtime.layout import OFFSETS, SIZES, TABLES, measured_size
from solver.runtime.model import Experiment, Row
from solver.runtime.operations import CODES as NAMES
from tests.hand_factors import (
    SEGMENTS,
    Factors,
    are_free,
    composites,
    sizes_of,
    write_island,
    write_sizes,
)

Node = tuple[str, int]
Place = tuple[str, int]
Entry = float | tuple[float, float]
"""Factor of a node in a link, or that and the factor of its quarter turn."""


class Hand:
    """A model under construction. Nodes are ("free", i), ("driven", i), ("fixed", i)."""

    def __init__(self, dim: int, gravity: Sequence[float] | None = None) -> None:
        self.dim = dim
        self.numbers: dict[str, list[float]] = {name: [] for name in OFFSETS}
        self.tables: dict[str, list] = {name: [] for name in TABLES}
        self.numbers["gravity"] = list(gravity or [0.0] * dim)
        self.nodes: dict[str, list] = {"free": [], "driven": [], "fixed": []}
        self.masses: dict[tuple[Node, Node], float] = {}
        self.forms: list[tuple[dict[Node, Entry], dict[Node, Entry] | None]] = []
        self.elements: list[int] = []
        self.functions: dict[str, list] = {"row": [], "velocity": [], "potential": []}
        self.operations: dict[str, list] = {segment: [] for segment in SEGMENTS}
        self.constants: list[float] = []
        self.inputs: list[float] = []
        self.flags: dict[str, int] = {}
        self.given: set[Node] = set()

    # ------------------------------------------------------------------------------- nodes

    def free(self, position, velocity=None, mass=1.0, *, direction=False, light=False) -> Node:
        """A node that moves; `light`: its mass has no weight."""
        return self._node("free", position, velocity, mass, direction, light)

    def driven(self, mass=1.0, *, direction=False) -> Node:
        """A node whose coordinates are signals."""
        return self._node("driven", [0.0] * self.dim, None, mass, direction, direction)

    def fixed(self, position, *, direction=False) -> Node:
        """A node that does not move."""
        self.nodes["fixed"].append((position, None, 0.0, direction, True))
        return "fixed", len(self.nodes["fixed"]) - 1

    def _node(self, kind, position, velocity, mass, direction, light) -> Node:
        node = kind, len(self.nodes[kind])
        still = [0.0] * self.dim
        self.nodes[kind].append((position, velocity or still, mass, direction, light or direction))
        self.masses[node, node] = mass
        return node

    def body(self, r, inertia, *, mass=1.0, R=None, velocity=None, rate=None) -> list[Node]:
        """A rigid body with its rows: r and its directors; `inertia` are the E_i of d_i."""
        R = np.eye(self.dim) if R is None else np.asarray(R)
        center = self.free(r, velocity, mass)
        rate = rate if rate is not None else (0.0 if self.dim == 2 else [0.0] * 3)
        directors = []
        for i, E in enumerate(inertia):
            d = R[:, i]
            v = rate * np.array([-d[1], d[0]]) if self.dim == 2 else np.cross(rate, d)
            directors.append(self.free(d.tolist(), v.tolist(), E, direction=True))
        for i, a in enumerate(directors):
            for b in directors[i:]:
                self.row(self.form({a: 1.0}, None if a == b else {b: 1.0}), float(a == b), 1.0)
        return [center, *directors]

    def disturb(self, size: float) -> None:
        """Change drawn positions at random, and velocities ten times as much."""
        random = np.random.default_rng(1)
        for i, (position, velocity, *rest) in enumerate(self.nodes["free"]):
            moved = np.array(position) + size * random.normal(size=self.dim)
            pushed = np.array(velocity) + 10.0 * size * random.normal(size=self.dim)
            self.nodes["free"][i] = (moved.tolist(), pushed.tolist(), *rest)

    # ------------------------------------------------------------------------------- forms, rows

    def form(self, u: Mapping[Node, Entry], w: Mapping[Node, Entry] | None = None) -> int:
        """Form u . w, or u . u."""
        self.forms.append((dict(u), None if w is None else dict(w)))
        return len(self.forms) - 1

    def row(self, form: int, constant: float, base: float, power: int = 0) -> None:
        """Row s = constant."""
        assert not self.numbers["row_base"] or len(self.tables["row_power"]) == len(
            self.tables["row_form"]
        ), "form rows come first"
        self.tables["row_form"].append(form)
        self.numbers["row_constant"].append(constant)
        self._scale(base, power)

    def coincidence(self, form: int) -> None:
        """Vector row u = 0."""
        self.tables["coincidence_form"].append(form)
        for _ in range(self.dim):
            self._scale(1.0, 1)

    def _scale(self, base: float, power: int) -> None:
        self.numbers["row_base"].append(base)
        self.tables["row_power"].append(power)

    def quantity(self, kind: int, form: int, second: int = -1) -> int:
        """Quantity 0 form, 1 length, 2 angle."""
        self.tables["quantity_kind"].append(kind)
        self.tables["quantity_form"].extend((form, second))
        return len(self.tables["quantity_kind"]) - 1

    def element(self, quantity, stiffness=0.0, rest=0.0, damping=0.0, drive=0.0) -> None:
        """Spring, damper and drive."""
        self.elements.append(quantity)
        law = {"stiffness": stiffness, "rest": rest, "damping": damping, "drive": drive}
        for name, value in law.items():
            self.numbers[name].append(value)

    def function(self, kind: str, leaves, operations, power: int = 0) -> None:
        """Function ("row", "velocity", "potential") of leaves (kind, index)."""
        self.functions[kind].append((list(leaves), list(operations)))
        if kind != "potential":
            self._scale(1.0, power)

    def load(self, form: int, force, axes: Node | None = None) -> None:
        """Force on a place."""
        self.tables["load_form"].append(form)
        self.tables["load_axes"].append(axes)
        self.numbers["load"].extend(force)

    def place(self, form: int) -> int:
        """A measured place."""
        self.tables["place_form"].append(form)
        return len(self.tables["place_form"]) - 1

    # ------------------------------------------------------------------------------- tape

    def constant(self, value: float) -> Place:
        """A number for tapes and functions."""
        self.constants.append(value)
        return "constant", len(self.constants) - 1

    def let(self, segment: str, name: str, target: Place, *arguments: Place) -> Place:
        """Append an operation to a segment of the tape."""
        self.operations[segment].append((name, target, arguments))
        return target

    def signal(self, value: Place) -> int:
        """A prescribed value."""
        index = len(self.numbers["signal"])
        self.numbers["signal"].append(0.0)
        self.let("signals", "copy", ("signal", index), value)
        return index

    # ------------------------------------------------------------------------------- model

    def model(self) -> Model:
        """The model."""
        starts = np.cumsum([0, *(len(self.nodes[kind]) for kind in self.nodes)])
        first = dict(zip(self.nodes, starts.tolist(), strict=False))

        def at(node: Node) -> int:
            return first[node[0]] + node[1]

        self._write_nodes(at)
        self._write_forms(at)
        groups = [[(0, quantity)] for quantity in self.elements]
        tables, counts = self.tables, {name: len(given) for name, given in self.functions.items()}
        programs = [function for given in self.functions.values() for function in given]
        groups += [leaves for leaves, _ in programs]
        ends = np.cumsum([0, *map(len, groups)])
        tables["leaf_ptr"] = ends.tolist()
        tables["leaf"] = [x for leaves in groups for leaf in leaves for x in (*leaf, -1, -1)]
        tables["load_axes"] = [-1 if axes is None else at(axes) for axes in tables["load_axes"]]
        tables["body_node"] = [at(node) for node in tables["body_node"]]
        tables["body_moment"] = [x if isinstance(x, int) else at(x) for x in tables["body_moment"]]
        tables["input_ramp"] = tables["input_ramp"] or [0] * len(self.inputs)
        sizes = sizes_of(self, counts)
        self._fill(sizes)
        offsets, start = {}, 0
        for name in OFFSETS:
            offsets[name] = start
            start += len(self.numbers[name])

        def place(reference: Place) -> int:
            name, index = reference
            return start + index if name == "constant" else offsets[name] + index

        tables["function_ptr"] = np.cumsum([0, *(len(ops) for _, ops in programs)]).tolist()
        tables["operation"] = [
            x
            for _, operations in programs
            for name, *args in operations
            for x in (
                NAMES.index(name),
                *_three([a if isinstance(a, int) else -1 - place(a) for a in args]),
            )
        ]
        tables["tape"] = [
            x
            for segment in SEGMENTS
            for name, target, args in self.operations[segment]
            for x in (NAMES.index(name), place(target), *_three([place(a) for a in args]))
        ]
        composites(tables, sizes["n_free"])
        write_sizes(tables, sizes)
        Factors(tables, sizes).write(sizes)
        write_island(tables, sizes)
        sizes["n_numbers"] = start + len(self.constants)
        numbers = [x for name in OFFSETS for x in self.numbers[name]] + self.constants
        return Model(
            name="hand", description="", sizes={name: sizes[name] for name in SIZES},
            tables={name: array("i", tables[name]) for name in TABLES}, offsets=offsets,
            numbers=array("d", numbers), variables=(), rules=(),
            rows=(Row("", "row", ""),) * sizes["n_rows"], forces={}, sampled=(),
            settings=dict(DEFAULTS), experiment=Experiment(),
        )  # fmt: skip

    def _write_nodes(self, at) -> None:
        moving = self.nodes["free"] + self.nodes["driven"]
        numbers, tables = self.numbers, self.tables
        for position, velocity, mass, _, light in moving:
            numbers["initial_position"].extend(position)
            numbers["initial_velocity"].extend(velocity)
            numbers["node_mass"].append(mass)
            numbers["node_weight"].append(0.0 if light else mass)
        for position, *_ in self.nodes["fixed"]:
            numbers["support"].extend(position)
        names = [(kind, i) for kind in ("free", "driven") for i in range(len(self.nodes[kind]))]
        numbers["velocity_weight"] = [1e8 if name in self.given else 1.0 for name in names]
        tables["node_kind"] = [int(node[3]) for node in moving + self.nodes["fixed"]]
        free = {pair: mass for pair, mass in self.masses.items() if are_free(pair)}
        for (a, b), mass in (free | self.masses).items():
            tables["mass_node"].extend((at(a), at(b)))
            numbers["mass"].append(mass)

    def _write_forms(self, at) -> None:
        tables, numbers = self.tables, self.numbers
        tables["form_ptr"] = [0]
        for u, w in self.forms:
            nodes = sorted({*u, *(w or {})}, key=at)
            moving = [node for node in nodes if node[0] != "fixed"]
            square, w = w is None, u if w is None else w
            linear = not square and all(node[0] == "fixed" for node in w)
            turned = any(isinstance(x, tuple) for x in (*u.values(), *w.values()))
            tables["form_kind"].append(square + 2 * linear + 4 * turned)
            tables["form_free"].append(sum(node[0] == "free" for node in nodes))
            tables["form_moving"].append(len(moving))
            tables["form_node"].extend(at(node) for node in nodes)
            tables["form_ptr"].append(len(tables["form_node"]))
            for name, link in (("alpha", u), ("beta", w)):
                pairs = [_pair(link.get(node, 0.0)) for node in nodes]
                numbers[name].extend(plain for plain, _ in pairs)
                numbers[f"{name}_turn"].extend(turn for _, turn in pairs)

    def _fill(self, sizes: dict[str, int]) -> None:
        numbers = self.numbers
        for name in ("row_scale", "row_sigma"):
            numbers[name] = [0.0] * sizes["n_rows"]
        numbers["input"], numbers["time"], numbers["extent"] = list(self.inputs), [0.0], [0.0] * 2
        numbers["sensor"] = [0.0] * sizes["n_quantities"]
        numbers["sensor_rate"] = [0.0] * sizes["n_quantities"]
        numbers["measured"] = [0.0] * measured_size(sizes)
        if self.dim == 3 or not any(kind & 4 for kind in self.tables["form_kind"]):
            numbers["alpha_turn"], numbers["beta_turn"] = [], []


def _pair(entry: Entry) -> tuple[float, float]:
    return entry if isinstance(entry, tuple) else (entry, 0.0)


def _three(places: list[int]) -> list[int]:
    return (places + places[-1:] * 2)[:3]
