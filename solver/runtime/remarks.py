"""Warnings of a run that goes on, each once.

Order 2 because of dampers, energy off by round-off, loads read too seldom, clipped inputs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from .errors import tell
from .model import Model
from .options import decode
from .state import State

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .kernel import Doubles

CONSERVING = ("conserving-al", "conserving-al-beta")
OPEN = 1e3
"""Error of the ledger, over `newton_tolerance`, that no run of solved steps comes to."""
LONG = 1e-9
"""Error of the ledger that round-off of a long run may come to."""
MOST_SAMPLING = 1.0
"""Largest `solver.sampling`: beyond it loads that read the mechanism drive it by their delay."""
COSTLY = "; a tight solver.tolerance takes many steps of order 2"


class Remarks:
    """Says what is noticed in one run, each once."""

    def __init__(self, model: Model, log: Callable[[str], None] | None) -> None:
        self._model, self._log = model, log
        self._said: set[str] = set()

    def look(self, state: State, numbers: Doubles) -> None:
        """Look at the state and the numbers of the model after a step."""
        head = state.head
        if "order" not in self._said:
            sentence, lasting = order_limit(self._model, head, numbers)
            if lasting or self._log:
                self.say("order", sentence)
        self.say("ledger", open_ledger(head))
        if self._model.sampled:
            self.say("sampling", missed_load(self._model, state))

    def say(self, about: str, sentence: str) -> None:
        """Say a sentence, if there is one and nothing was said about it."""
        if sentence and about not in self._said:
            self._said.add(about)
            tell(self._log, sentence)


def open_ledger(head: Mapping[str, float]) -> str:
    """Return what is said after a step when energies are off the ledger though steps are solved."""
    limit = max(OPEN * head["newton_tolerance"], LONG)
    if head["ledger_error"] <= limit or decode("formulation", head) not in CONSERVING:
        return ""
    return (
        f"the energy is off by {head['ledger_error']:.1e} of the reference energy at t = "
        f"{head['time']:g} s though steps are solved: round-off is too large for this mechanism; "
        "draw it closer to the origin, with sizes, masses and stiffnesses less far apart, or take "
        "longer steps"
    )


def missed_load(model: Model, state: State) -> str:
    """Return what is said after a step in which a load that reads the mechanism came too seldom."""
    ratios = state.vectors["sampled"][2::3]
    worst = max(range(len(ratios)), key=ratios.__getitem__)
    if not ratios[worst] > MOST_SAMPLING:
        return ""
    name, head = model.sampled[worst], state.head
    shorter = f"steps shorter than solver.step_size = {head['step_size']:g} s"
    if head["tolerance"] > 0.0:
        shorter = "a smaller solver.longest_step"
    return (
        f"{name} is evaluated too seldom, once in a half step: until t = {head['time']:g} s the "
        f"motion that it causes changed its work by {ratios[worst]:.1f} times the work foreseen; "
        "it alternates or reverses what it should stop; use a damper or torsion_damper instead, "
        f"make its formula smoother, or take {shorter}"
    )


def order_limit(model: Model, head: Mapping[str, float], numbers: Doubles) -> tuple[str, bool]:
    """Return what is said after a step that dampers kept at order 2; nothing where none is due.

    And whether it is so for all steps, by what the mechanism is and its settings, and not for one
    that was too long, or at rest. `head` has the scalars of the state, `numbers` those of the model
    at present.
    """
    asked, tight = head["order"], head["tolerance"] > 0.0
    chosen = tight and asked == 0.0
    if not chosen and not asked > head["order_in_use"]:
        return "", False
    lasting = _lasting_reason(model, head)
    if chosen:
        # Order 2 may be the choice of the tolerance, unless it has none.
        reason = lasting or (model.sizes["sensing"] and "a load reads the mechanism")
        if not reason or not _is_damped(model, numbers):
            return "", False
        wanted, lasting = "solver.tolerance chooses the order", reason
    else:
        wanted = f"solver.order is {asked:g}"
        reason = lasting or "the motion changes too much in a step of this length, or not at all"
    sentence = f"{wanted}, but steps are of order 2: dampers take energy out, and {reason}"
    return sentence + (COSTLY if tight else ""), bool(lasting)


def _lasting_reason(model: Model, head: Mapping[str, float]) -> str:
    parts, formulation = model.sizes["n_islands"], decode("formulation", head)
    if parts > 1:
        return (
            f"the mechanism has {parts} separate parts, which would exchange energy: "
            "build an FMU of each part"
        )
    if formulation not in CONSERVING:
        return f"solver.formulation {formulation} has no higher order; {CONSERVING[0]} has"
    return ""


def _is_damped(model: Model, numbers: Doubles) -> bool:
    begin = model.offsets["damping"]
    return any(numbers[begin : begin + model.sizes["n_elements"]])
