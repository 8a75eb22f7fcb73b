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


def order_limit(model: Model, head: Mapping[str, float], numbers: Doubles) -> str:
    """Return what is said after a step that dampers kept at order 2; nothing where none is due.

    `head` has the scalars of the state, `numbers` those of the model at present.
    """
    if head["order"] > 0.0 or not head["tolerance"] > 0.0:
        if not head["order"] > head["order_in_use"]:
            return ""
        needs = "steps in which the motion changes little"
        asked = f"solver.order is {head['order']:g}"
        return LIMITED.format(asked, needs) + COSTLY * (head["tolerance"] > 0.0)
    # The tolerance chooses: order 2 is its choice, unless there is none.
    whole = model.sizes["n_islands"] == 1 and not model.sizes["sensing"]
    begin = model.offsets["damping"]
    if (whole and decode("formulation", head) in CONSERVING) or not any(
        numbers[begin : begin + model.sizes["n_elements"]]
    ):
        return ""
    needs = "no load that reads the mechanism"
    return LIMITED.format("solver.tolerance is to choose the order", needs) + COSTLY
