"""Springs and dampers in joints, as fields of what has an angle or a displacement.

    hinge = { type = "revolute", ..., stiffness = 20, damping = 0.3 }

means a torsion spring and a torsion damper at the joint; of a joint that slides, a spring and a
damper along it. A joint that does both says with `of` which one its fields mean.
"""

from typing import TYPE_CHECKING, Any

from solver.scene import fields as kind
from solver.scene.fields import BROKEN
from solver.scene.forces import not_negative, read_free_angle
from solver.scene.mistakes import Path
from solver.scene.quantities import Offer
from solver.scene.rules import FORCE

if TYPE_CHECKING:
    from solver.scene.references import Reader

SPRING_ALONG = (
    Offer("spring", "N", "force of the spring in {name}, positive against its displacement"),
    Offer("damper", "N", "force of the damper in {name}, positive against its velocity"),
)
"""Of a joint that slides; each, if the field is given that makes it."""
SPRING_ABOUT = (
    Offer("spring", "N.m", "torque of the spring in {name}, positive against its angle"),
    Offer("damper", "N.m", "torque of the damper in {name}, positive against its rate"),
)
"""Of a joint that turns."""
FIELD_OF = {"spring": "stiffness", "damper": "damping"}
"""Field that makes what is offered."""


STIFFNESS_ABOUT = not_negative("N.m/rad", 20.0, "of a torsion spring in the joint")
DAMPING_ABOUT = not_negative("N.m.s/rad", 0.3, "of a torsion damper in the joint")
STIFFNESS_ALONG = not_negative("N/m", 100.0, "of a spring along the joint")
DAMPING_ALONG = not_negative("N.s/m", 1.0, "of a damper along the joint")
STIFFNESS_OF = not_negative("N.m/rad or N/m", 20.0, "of a spring about or along the joint")
DAMPING_OF = not_negative("N.m.s/rad or N.s/m", 0.3, "of a damper about or along the joint")
FREE_ANGLE = kind.Quantity("rad", "of the spring; as drawn unless given", None, FORCE, 0.1,
                           reading=read_free_angle)  # fmt: skip
FREE_DISPLACEMENT = kind.Quantity("m", "of the spring; as drawn unless given", None, FORCE, 0.01)
OF = kind.Choice(text="what spring and damper act on", words=("angle", "displacement"))
_UNITS = {
    "angle": {"stiffness": "N.m/rad", "damping": "N.m.s/rad"},
    "displacement": {"stiffness": "N/m", "damping": "N.s/m"},
}
"""Of a joint that turns and slides, by what its spring and damper act on."""
_FIELDS = ("stiffness", "damping", "free_angle", "free_displacement", "of")


def given_fields(given: Any) -> list[str]:
    """Fields of springs and dampers that are given for a joint, as they were parsed."""
    return [field for field in _FIELDS if getattr(given, field, None) is not None]


def check_springs(reader: "Reader", path: Path, given: Any, *, both: bool) -> None:
    """Check that the fields of a joint fit each other; `both` says that it turns and slides."""
    draft, found = reader.draft, given_fields(given)
    acts = [field for field in found if field in ("stiffness", "damping")]
    for field in found:
        needs = acts[:1] if field == "of" else [x for x in acts if x == "stiffness"]
        if field.startswith(("free", "of")) and not needs:
            message = "has no effect without 'stiffness'" + (" or 'damping'" * (field == "of"))
            draft.error((*path, field), message, "write stiffness = ..., or leave it out")
    if both and acts and "of" not in found:
        message = "'of' is missing: whether they act on the angle or on the displacement"
        draft.error(path, message, 'write of = "angle", or of = "displacement"')
    if both and "of" in found and given.of is not BROKEN:
        for field, unit in _UNITS[given.of].items():
            reader.in_unit((*path, field), getattr(given, field), unit)
        other = {"angle": "free_displacement", "displacement": "free_angle"}[given.of]
        if other in found:
            message = f'the spring acts on the {given.of}, by of = "{given.of}"'
            draft.error((*path, other), message, f"write free_{given.of}")
