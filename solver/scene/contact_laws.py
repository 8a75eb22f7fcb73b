"""What all contacts of a scene have: the law of the normal force, how it rebounds and how it rubs.

A gap is a distance, or the angle that is left to a stop: positive while a contact is open, zero
while it is closed. The normal force pushes the two sides apart and is never negative.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from solver.scene import fields as kind
from solver.scene.expression import Number
from solver.scene.fields import BROKEN, Part
from solver.scene.friction import SMOOTH_SPEED, check_sticking
from solver.scene.mistakes import Path
from solver.scene.quantities import COMPLIANT, CONTACT, FRICTION, Offer
from solver.scene.rules import NOT_NEGATIVE, POSITIVE, PROPERTY, SHARE, Rule

if TYPE_CHECKING:
    from collections.abc import Collection

    from solver.scene.references import Reader

AT_LEAST_ONE = Rule(lambda x: x >= 1.0, ">= 1", relation=">=")
"""``solver.mechanics.contacts`` checks it again where the exponent is a parameter."""
LAWS = {
    "rigid": (),
    "hertz": ("stiffness",),
    "hunt-crossley": ("stiffness", "damping"),
    "lankarani-nikravesh": ("stiffness", "impact_speed"),
}
"""Laws of a contact, and the fields that they need."""
COMPLIANT_FIELDS = ("stiffness", "exponent", "damping", "impact_speed")
"""Fields of compliant laws."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact(Part):
    """Two parts that touch and come apart: what all types have."""

    offers = CONTACT
    may_be_compliant: ClassVar[bool] = True
    """Whether its law may be compliant: its gap must be one, and of one quantity."""

    restitution: Annotated[
        Number,
        kind.Quantity("", "normal speed after an impact over that before it", SHARE, PROPERTY),
    ] = 0.0
    law: Annotated[
        Literal["rigid", "hertz", "hunt-crossley", "lankarani-nikravesh"],
        kind.Choice(words=tuple(LAWS)),
    ] = "rigid"
    stiffness: Annotated[
        Number | None,
        kind.Quantity("N/m^exponent", "of a compliant law: force over depth^exponent", POSITIVE),
    ] = None
    exponent: Annotated[
        Number, kind.Quantity("", "of a compliant law, of its depth", AT_LEAST_ONE)
    ] = 1.5
    damping: Annotated[
        Number | None,
        kind.Quantity("s/m", "of hunt-crossley: share of the force per speed", NOT_NEGATIVE),
    ] = None
    impact_speed: Annotated[
        Number | None,
        kind.Quantity("m/s", "of lankarani-nikravesh: at which the restitution holds", POSITIVE),
    ] = None

    @classmethod
    def offered(cls, given: "Collection[str]") -> tuple[Offer, ...]:
        """A compliant one is a force: it has no mode and no impacts."""
        return COMPLIANT if is_compliant(given) else cls.offers

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that what is given is what the law needs."""
        if given.law is BROKEN:
            return
        needed, draft = LAWS[self.law], reader.draft
        if needed and not self.may_be_compliant:
            message = f'must be "rigid" for a contact of type "{self.type}"'
            draft.error((*path, "law"), message, "leave it out")
            return
        for name in needed:
            if getattr(given, name) is None:
                message = f"'{name}' is missing: law = \"{self.law}\" needs it"
                draft.error(path, message, f"write {name} = ...")
        possible = (*needed, *(("exponent",) if needed else ()))
        for name in COMPLIANT_FIELDS:
            if getattr(given, name) is not None and name not in possible:
                laws = [f'"{law}"' for law in LAWS if law != "rigid"]
                if name in ("damping", "impact_speed"):
                    laws = [f'"{law}"' for law, fields in LAWS.items() if name in fields]
                help = f"leave it out, or write law = {' or '.join(laws)}"
                draft.error((*path, name), f'has no effect with law = "{self.law}"', help)
        refused = {"friction": bool(needed), "restitution": self.law in ("hertz", "hunt-crossley")}
        for name, refuse in refused.items():
            if refuse and getattr(given, name, None) is not None:
                message = f'is not possible with law = "{self.law}"'
                help = 'leave it out; law = "rigid" has it'
                draft.error((*path, name), message, help)


def is_compliant(given: "Collection[str]") -> bool:
    """Whether a contact with these fields is compliant: it has a stiffness, which others cannot."""
    return "stiffness" in given


@dataclass(frozen=True, slots=True, kw_only=True)
class RubbingContact(Contact):
    """A contact whose sides may rub; without `friction` they slide freely."""

    friction: Annotated[
        Number | None, kind.Quantity("", "coefficient while it slides", NOT_NEGATIVE, PROPERTY)
    ] = None
    static_friction: Annotated[
        Number | None,
        kind.Quantity(
            "", "coefficient while it sticks; `friction` unless given", NOT_NEGATIVE, PROPERTY
        ),
    ] = None
    smooth_speed: Annotated[
        Number | None, kind.Quantity("m/s", SMOOTH_SPEED, POSITIVE, PROPERTY, example=0.001)
    ] = None

    @classmethod
    def offered(cls, given: "Collection[str]") -> tuple[Offer, ...]:
        """One without friction has no slip."""
        if is_compliant(given):
            return COMPLIANT
        return (*cls.offers, *(FRICTION if "friction" in given else ()))

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that friction has a coefficient while it slides, and none larger than at rest."""
        Contact.check(self, reader, path, given)
        if given.smooth_speed is not None and given.friction is None:
            message = "has no effect without friction"
            help = "write friction = ..., or leave it out"
            reader.draft.error((*path, "smooth_speed"), message, help)
        check_sticking(reader, self, given, (*path, "static_friction"), "friction")
        if given.static_friction is not None and given.friction is None:
            message = "'friction' is missing: the coefficient while it slides"
            reader.draft.error(path, message, "write friction = ...")
