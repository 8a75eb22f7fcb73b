"""Named expressions of a scene: formulas that other formulas mention by name.

A name stands for its text, in brackets; ``solver.scene.substitution`` puts it there. So a name may
stand wherever its text may, and the place of the name decides what the text may mention.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any

from solver.scene import fields as kind
from solver.scene.expression import Number
from solver.scene.fields import BROKEN, Part
from solver.scene.mistakes import Path
from solver.scene.parameters import TEXT, UNIT, settle_units
from solver.scene.rules import ANYWHERE
from solver.scene.substitution import ReportedError

if TYPE_CHECKING:
    from solver.scene.draft import Draft
    from solver.scene.references import Reader


class _Formula(kind.Quantity):
    """The text of a named expression, which is read once."""

    def parse(self, draft: "Draft", path: Path, value: Any, unit: str = "") -> Any:  # noqa: ARG002
        """Read it, and what it mentions before it."""
        return draft.expressions.parsed(str(path[1]))


def _read(reader: "Reader", path: Path, value: Any, _: Any) -> Number:
    """Report what is unknown everywhere; whether it fits a place is asked where it is used."""
    if value is BROKEN:
        return 0.0
    own = [mention for mention in value.mentions if not mention.within]
    place = replace(ANYWHERE, own=tuple(x for x in ANYWHERE.own if x not in reader.known.parts))
    if not reader.mentions_are_allowed(path, value._replace(mentions=tuple(own)), place):
        reader.known.reported.add(str(path[1]))
    return value.number


@dataclass(frozen=True, slots=True, kw_only=True)
class Expression(Part):
    """A formula with a name, which stands for it in other formulas."""

    short = "value"

    value: Annotated[
        Number, _Formula(text="what the name stands for", example="A.x - B.x", reading=_read)
    ]
    unit: Annotated[str, UNIT] = ""
    description: Annotated[str, TEXT] = ""

    @classmethod
    def read(cls, reader: "Reader", path: Path, given: Any) -> Any:
        """Settle its unit."""
        values = reader.fields(cls, path, given)
        settle_units(reader, path, given, values)
        return cls(**values)


class Expressions(Mapping[str, str]):
    """Texts of the named expressions of a scene, each read when it is first asked for."""

    def __init__(self, draft: "Draft") -> None:
        self._draft = draft
        self._values = {
            name: _value(draft.data["expressions"][name]) for name in draft.names("expressions")
        }
        self._parsed: dict[str, Any] = {}
        self._open: list[str] = []
        """Those that are being read, each mentioned by the one before it."""
        self.used: set[str] = set()
        """Names that some text mentions."""

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __contains__(self, name: object) -> bool:
        return name in self._values

    def __getitem__(self, name: str) -> str:
        """Text of an expression; raises ReportedError for one with a mistake."""
        self.used.add(name)
        parsed = self.parsed(name)
        if parsed is BROKEN:
            message = f"the expression '{name}' has a mistake"
            raise ReportedError(message)
        is_text = isinstance(parsed.given, str) and not parsed.unit
        return parsed.given if is_text else repr(parsed.number)

    def parsed(self, name: str) -> Any:
        """Reading of an expression, or BROKEN; circles are reported."""
        if name in self._open:
            self._report_circle(self._open[self._open.index(name) :])
            return BROKEN
        if name not in self._parsed:
            self._open.append(name)
            path, value = self._path(name), self._values[name]
            usual = kind.OfAnyUnit()
            found = BROKEN if value is None else usual.parse(self._draft, path, value)
            self._parsed.setdefault(name, found)
            self._open.pop()
        return self._parsed[name]

    def _report_circle(self, circle: list[str]) -> None:
        """Report expressions that mention each other, once, at the first of the file."""
        start = circle.index(min(circle, key=list(self._values).index))
        names = [*circle[start:], *circle[:start], circle[start]]
        message = f"made of itself: {' -> '.join(names)}"
        self._draft.error(self._path(names[0]), message, "write one of them without the others")
        self._parsed |= dict.fromkeys(circle, BROKEN)

    def _path(self, name: str) -> Path:
        """Place of the text of an expression."""
        given = self._draft.data["expressions"][name]
        path = ("expressions", name)
        return (*path, "value") if isinstance(given, dict) else path


def _value(given: Any) -> Any:
    """What a file gives for an expression; None where its table has none."""
    return given.get("value") if isinstance(given, dict) else given
