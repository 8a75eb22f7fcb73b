"""Checks of a mechanism when its parameters have arrived: numbers, drawn places, velocities."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from .layout import PLACE, state_sections
from .options import GENERAL

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .kernel import Doubles, Kernel
    from .model import Model, Rule

DRAWN = 1e-9
"""Largest residual of a drawn mechanism against the size of its row: the first step would turn a
larger one into a jolt."""
PRESCRIBED = 1e-6
"""Largest relative error of a velocity that a formula prescribes: rates of signals are differences,
which leaves of a signal at rest what rounding makes, less than DRAWN in a second."""
ROUNDING = 1e-13
"""What solving for velocities leaves, against the size of a row and the fastest motion."""

ASSEMBLE = ", or set [solver] assemble = true"

SENTENCES = {
    "apart": "its places{detail} are drawn {gap:.6g} m apart; move one",
    "off": "its places{detail} are drawn {gap:.6g} m off its line or plane; move one",
    "height": "the centre of the disc is drawn {gap:.6g} m off its height; move it",
    "turned": "its axes{detail} are drawn {gap:.6g} rad off; turn a body",
    "angle": "the cosine of its angle is {gap:.6g} off as drawn; turn a body, or correct the value",
    "axes": "its axes are {gap:.6g} off perpendicular unit vectors; correct its orientation",
    "value": "its value is {gap:.6g} as drawn and must be 0; move or turn a part",
    "driver": "the drawing is {gap:.6g} off its value at the start; move a part, "
    "correct the formula",
}
"""What is said about the drawn positions, by the kind of the row."""

UNITS = {"length": " m", "apart": " m", "off": " m", "height": " m", "turned": " rad"}

VELOCITIES = (
    "the velocities of its parts contradict it, by {rate:.6g}{unit}; correct the velocities"
)


def rules_of_laws(model: Model) -> tuple[Rule, ...]:
    """Return the rules that inputs and tunable parameters can break in motion, unnoticed.

    A law that is not finite is noticed: the step fails. So plain loads need no check.
    """
    sizes, offsets = model.sizes, model.offsets
    start = 5 * sizes["n_tape_parameters"]  # an operation is code, target and three arguments
    laws = model.tables["tape"][start : start + 5 * sizes["n_tape_laws"]]
    moved = {*laws[1::5], *range(offsets["input"], offsets["input"] + sizes["n_inputs"])}
    for variable in model.variables:
        if variable.kind == "parameter" and variable.variability == "tunable":
            moved.add(offsets["parameter"] + variable.place)
    return tuple(rule for rule in model.rules if rule.number in moved and rule.relation != "finite")


def broken_rules(rules: Iterable[Rule], numbers: Doubles) -> list[str]:
    """Return one sentence for each rule that the numbers break."""
    return [
        f"{rule.name}: {rule.message.format(value=numbers[rule.number])}"
        for rule in rules
        if not rule.holds(numbers[rule.number])
    ]


def formulation_problems(model: Model, formulation: str) -> list[str]:
    """Return a sentence if the formulation does not know the mechanism's rows."""
    sizes = model.sizes
    general = sizes["n_function_rows"] + sizes["n_velocity_rows"]
    if formulation in GENERAL or not general:
        return []
    name = model.rows[sizes["n_rows"] - general].name
    return [
        f"solver.formulation: {formulation!r} takes only quadratic rows, and that of {name} is "
        f"not; use {' or '.join(map(repr, GENERAL))}"
    ]


def equilibrium_problems(model: Model, equilibrium: float) -> list[str]:
    """Return a sentence if an equilibrium is sought of loads that would be held as drawn."""
    if not (equilibrium and model.sizes["sensing"]):
        return []
    names = ", ".join(dict.fromkeys(model.sampled)) or "a force"
    return [
        f"solver.start: no equilibrium is sought, because {names} reads the motion; write it as a "
        "spring, damper, torsion_spring, torsion_damper or potential, or begin as drawn"
    ]


def contradicted_rows(model: Model, engine: Kernel) -> list[str]:
    """Return one sentence for each part whose rows the drawn mechanism contradicts.

    With the setting `assemble` positions and velocities have been made consistent, so that a row
    which is still violated cannot be met at all: one sentence names the parts that fight.
    """
    drawn = _Drawn(model, engine)
    rows = range(len(model.rows))
    parts = _by_part(model, {row: drawn.gap(row) for row in rows})
    if engine.state[PLACE["assemble"]]:
        return _fighting(model, drawn, parts)
    sentences = []
    for found in parts.values():
        alike = [gap for gap, row in found if model.rows[row].kind == model.rows[found[0][1]].kind]
        sentences.append(drawn.about_positions(found[0][1], math.hypot(*alike)))
    open_rows = (row for row in rows if model.rows[row].name not in parts)
    for found in _by_part(model, {row: drawn.speed(row) for row in open_rows}).values():
        rate = math.hypot(*(rate for rate, _ in found))
        sentences.append(drawn.about_velocities(found[0][1], rate))
    return sentences


def _by_part(model: Model, values: dict[int, float]) -> dict[str, list[tuple[float, int]]]:
    """Values that are not 0 with their rows, by the name of the part; the largest first."""
    parts: dict[str, list[tuple[float, int]]] = {}
    for row, value in values.items():
        if value != 0.0:
            parts.setdefault(model.rows[row].name, []).append((value, row))
    return {name: sorted(rows, reverse=True) for name, rows in parts.items()}


def _fighting(
    model: Model, drawn: _Drawn, parts: dict[str, list[tuple[float, int]]]
) -> list[str]:  # fmt: skip
    """One sentence with the parts that cannot be closed, each with what is missing."""
    if not parts:
        return []
    sizes = []
    for name, rows in parts.items():
        kind = model.rows[rows[0][1]].kind
        gap = drawn.length_gap(rows[0][1]) if kind == "length" else rows[0][0]
        sizes.append(f"{name} ({gap:.3g}{UNITS.get(kind, '')})")
    return [f"the mechanism cannot be closed: joints contradict each other: {', '.join(sizes)}"]


class _Drawn:
    """Residuals of the rows of a mechanism at its start."""

    def __init__(self, model: Model, engine: Kernel) -> None:
        self.model, self.numbers, self.state = model, engine.numbers, engine.state
        self.phi, self.rate = engine.residuals()
        self.sections = state_sections(model.sizes)
        extent = self.numbers[model.offsets["extent"]]
        kinds = model.tables["node_kind"]
        self.fastest = max(
            (
                math.hypot(*self._moving(node, "v")) / (1.0 if kinds[node] else extent)
                for node in range(model.sizes["n_free"] + model.sizes["n_driven"])
            ),
            default=0.0,
        )
        """Largest angular velocity, and speed over the size of the mechanism [1/s]."""

    def _moving(self, node: int, vector: str) -> list[float]:
        """Coordinates or velocity of a moving node; of one that is fixed, its place or rest."""
        dim, sizes = self.model.sizes["dim"], self.model.sizes
        moving = sizes["n_free"] + sizes["n_driven"]
        if node < moving:
            start = self.sections[vector][0] + dim * node
            return list(self.state[start : start + dim])
        if vector == "v":
            return [0.0] * dim
        start = self.model.offsets["support"] + dim * (node - moving)
        return list(self.numbers[start : start + dim])

    def gap(self, row: int) -> float:
        """How far a row is from what it demands; 0 where rounding explains it."""
        size = self.numbers[self.model.offsets["row_scale"] + row]
        twice = 2.0 if self.model.rows[row].kind == "length" else 1.0  # of squared lengths
        return abs(self.phi[row]) if not abs(self.phi[row]) <= twice * DRAWN * size else 0.0

    def speed(self, row: int) -> float:
        """Rate of a row; 0 where rounding explains it."""
        sizes = self.model.sizes
        scale = self.numbers[self.model.offsets["row_scale"] + row]
        size = ROUNDING * scale * self.fastest  # of velocities that were made consistent
        if abs(self.rate[row]) <= size:  # then its bound, which takes long, need not be known
            return 0.0
        if row < sizes["n_form_rows"]:
            size += DRAWN * self._bound(self.model.tables["row_form"][row])
        elif row < sizes["n_form_rows"] + sizes["dim"] * sizes["n_coincidences"]:
            place = (row - sizes["n_form_rows"]) // sizes["dim"]
            size += DRAWN * self._bound(self.model.tables["coincidence_form"][place])
        else:
            size = scale * (PRESCRIBED * self.fastest + DRAWN)
        return abs(self.rate[row]) if not abs(self.rate[row]) <= size else 0.0

    def _entries(self, form: int) -> Iterator[tuple[int, float, float]]:
        """Node of each entry, and the sizes of its coefficients in u and w."""
        tables, offsets = self.model.tables, self.model.offsets
        turned = offsets["beta_turn"] > offsets["alpha_turn"]
        for e in range(tables["form_ptr"][form], tables["form_ptr"][form + 1]):
            sizes = [abs(self.numbers[offsets[name] + e]) for name in ("alpha", "beta")]
            if turned:
                for k, name in enumerate(("alpha_turn", "beta_turn")):
                    sizes[k] += abs(self.numbers[offsets[name] + e])
            yield tables["form_node"][e], *sizes

    def _bound(self, form: int) -> float:
        """Return what the rate of u . w, or of u alone, would be if nothing cancelled."""
        dim = self.model.sizes["dim"]
        entries = list(self._entries(form))
        u, w = [0.0] * dim, [0.0] * dim
        for node, a, b in self._signed(form):
            x = self._moving(node, "q")
            u = [y + a * z for y, z in zip(u, x, strict=True)]
            w = [y + b * z for y, z in zip(w, x, strict=True)]
        alone = all(b == 0.0 for _, _, b in entries)
        arm, other = (1.0 if alone else math.hypot(*w)), math.hypot(*u)
        return sum(
            (a * arm + b * other) * math.hypot(*self._moving(node, "v")) for node, a, b in entries
        )

    def _signed(self, form: int) -> Iterator[tuple[int, float, float]]:
        tables, offsets = self.model.tables, self.model.offsets
        for e in range(tables["form_ptr"][form], tables["form_ptr"][form + 1]):
            alpha, beta = (self.numbers[offsets[name] + e] for name in ("alpha", "beta"))
            yield tables["form_node"][e], alpha, beta

    # --------------------------------------------------------------------------------- sentences

    def about_positions(self, row: int, gap: float) -> str:
        """Return the sentence about a part that is drawn apart."""
        record = self.model.rows[row]
        if record.kind == "length":
            length, drawn = self._lengths(row)
            return (
                f"{record.name}: length is {length:.12g} m, but its points are drawn "
                f"{drawn:.12g} m apart; move a point, correct the length, or leave it out to take "
                f"it as drawn{ASSEMBLE}"
            )
        text = SENTENCES[record.kind].format(gap=gap, detail=record.detail)
        return f"{record.name}: {text}{ASSEMBLE}"

    def _lengths(self, row: int) -> tuple[float, float]:
        """Return the length that a rod must have and the one that it has."""
        length2 = self.numbers[self.model.offsets["row_constant"] + row]
        return math.sqrt(length2), math.sqrt(max(length2 + self.phi[row], 0.0))

    def length_gap(self, row: int) -> float:
        """By how much the length of a rod is wrong [m]."""
        length, drawn = self._lengths(row)
        return abs(length - drawn)

    def about_velocities(self, row: int, rate: float) -> str:
        """Return the sentence about a part whose velocities disagree."""
        record = self.model.rows[row]
        ends = self._along(row) if record.kind == "length" else []
        if len(ends) == 2:
            return (
                f"{record.name}: the velocities of its points contradict it: along it they are "
                f"{ends[0]:.12g} m/s and {ends[1]:.12g} m/s, and must be equal{ASSEMBLE}"
            )
        unit = f"{UNITS[record.kind]}/s" if record.kind in UNITS else " per second"
        return f"{record.name}: {VELOCITIES.format(rate=rate, unit=unit)}{ASSEMBLE}"

    def _along(self, row: int) -> list[float]:
        """Velocities of the two points of a rod along it."""
        entries = list(self._signed(self.model.tables["row_form"][row]))
        if sorted(a for _, a, _ in entries) != [-1.0, 1.0]:
            return []
        (first, _, _), (second, _, _) = sorted(entries, key=lambda entry: entry[1])
        places = [self._moving(node, "q") for node in (first, second)]
        link = [y - x for x, y in zip(*places, strict=True)]
        length = math.hypot(*link) or 1.0
        return [
            sum(v * u for v, u in zip(self._moving(node, "v"), link, strict=True)) / length
            for node in (first, second)
        ]
