"""Where steps stay of order 2 though a higher order is wanted, and the sentence that says so."""

from __future__ import annotations

from collections.abc import Mapping

from .model import Model
from .options import decode

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .engine import Doubles

CONSERVING = ("conserving-al", "conserving-al-beta")
LIMITED = (
    "{}, but steps are of order 2: where dampers take energy out a higher order "
    "needs solver.formulation conserving-al, a mechanism of one part (build-fmu info counts the "
    "separate ones: export each by itself), and {}"
)
COSTLY = "; a tight solver.tolerance takes many steps of order 2"


def order_limit(model: Model, head: Mapping[str, float], numbers: Doubles) -> tuple[str, bool]:
    """Return what is said after a step that dampers kept at order 2; nothing where none is due.

    And whether it is so for all steps, by what the mechanism is and its settings, and not for one
    that was too long, or at rest. `head` has the scalars of the state, `numbers` those of the model
    at present.
    """
    asked, chosen = head["order"], head["tolerance"] > 0.0 and head["order"] == 0.0
    if not chosen and not asked > head["order_in_use"]:
        return "", False
    lasting = model.sizes["n_islands"] > 1 or decode("formulation", head) not in CONSERVING
    if not chosen:
        needs = "steps in which the motion changes little"
        costs = COSTLY if head["tolerance"] > 0.0 else ""
        return LIMITED.format(f"solver.order is {asked:g}", needs) + costs, lasting
    # Order 2 may be the choice of the tolerance, unless it has none.
    begin = model.offsets["damping"]
    damped = any(numbers[begin : begin + model.sizes["n_elements"]])
    if not damped or not (lasting or model.sizes["sensing"]):
        return "", False
    needs = "no load that reads the mechanism"
    return LIMITED.format("solver.tolerance is to choose the order", needs) + COSTLY, True
