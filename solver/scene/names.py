"""Names of a scene: what a name looks like, which ones are taken, what each one stands for."""

from __future__ import annotations

import keyword
from collections.abc import Iterator
from typing import Any

from solver.files import is_reserved
from solver.scene.contact_laws import is_compliant
from solver.scene.draft import Draft
from solver.scene.expression import FUNCTIONS, MECHANISM_FUNCTIONS
from solver.scene.mistakes import Path
from solver.scene.numbers import Known
from solver.scene.quantities import MOTION, Offer
from solver.scene.scene import LONGEST, NAME, NOUNS, TABLES, TYPES
from solver.scene.words import a

RESERVED: dict[str, str] = {
    "ground": "the fixed body",
    "t": "the time",
    "time": "the time in result files",
    "pi": "the number pi",
    "energy": "the energies of the mechanism",
    "constraint": "the constraint residuals",
    "momentum": "the momentum of the mechanism",
    "angular_momentum": "the angular momentum of the mechanism",
    "solver": "the solver's settings",
    **dict.fromkeys([*FUNCTIONS.keys() - {"floor"}, *MECHANISM_FUNCTIONS], "the function"),
    **dict.fromkeys([word.lower() for word in keyword.kwlist], "the language of expressions"),
    **dict.fromkeys(keyword.kwlist, "the language of expressions"),
}
"""Names with a meaning of their own: what each is reserved for. Many scenes have a floor, which the
bracket behind the function tells apart."""
_OF_CONTACTS = frozenset({"friction", "backlash"})
"""Fields of joints that make them touch or rub."""


def check_name(draft: Draft, path: Path, name: str) -> None:
    """Report a name that is none, or that means something else."""
    if not NAME.fullmatch(name):
        draft.error(path, f"'{name}' is not a name: a letter, then letters, digits or _")
    elif name in RESERVED:
        draft.error(path, f"the name '{name}' is reserved for {RESERVED[name]}")


def check_scene_name(draft: Draft, name: str) -> None:
    """Report the name of a scene that is none, or that no file of an FMU can have."""
    check_name(draft, ("name",), name)
    if len(name) > LONGEST:
        message = f"must have at most {LONGEST} letters, got {len(name)}"
        draft.error(("name",), message, "put the rest into 'description'")
    elif is_reserved(name):
        message = f"the name '{name}' is reserved by Windows: no file of an FMU can have it"
        draft.error(("name",), message)


def check_names(draft: Draft) -> None:
    """Report names that cannot be used and names used twice."""
    taken: dict[str, Path] = {}
    for table in draft.data:  # in the order of the file: the second use is the mistake
        entries = draft.data[table] if table in NOUNS else None
        for name in entries if isinstance(entries, dict) else ():
            path = (table, name)
            check_name(draft, path, name)
            if name in taken:
                first = taken[name]
                line = draft.source.problem(first, "").line
                where = f" in line {line}" if line else ""
                owner = NOUNS[str(first[0])]
                draft.error(path, f"the name '{name}' is already that of {a(owner)}{where}")
            taken.setdefault(name, path)


def check_body_points(draft: Draft, known: Known) -> None:
    """Report points of bodies whose names cannot be used after the name of their body."""
    for body, point in body_points(draft):
        path = ("bodies", body, "points", point)
        if not NAME.fullmatch(point):
            draft.error(path, f"'{point}' is not a name: a letter, then letters, digits or _")
        elif keyword.iskeyword(point):
            draft.error(path, f"the name '{point}' is reserved for {RESERVED[point]}")
        elif f"{body}.{point}" in known.quantities:
            draft.error(path, f"the name '{body}.{point}' is that of a quantity of the body")


def known_names(draft: Draft) -> Known:
    """What each name stands for, and which quantities there are; the first use of a name counts."""
    kinds: dict[str, str] = {}
    for table, noun in NOUNS.items():
        for name in draft.names(table):
            bar = table == "bodies" and draft.part_class(table, name) is TYPES["bodies"]["bar"]
            kinds.setdefault(name, "bar" if bar else noun)
    joints = (draft.data["joints"][name] for name in draft.names("joints"))
    rubs = any(isinstance(x, dict) and not x.keys().isdisjoint(_OF_CONTACTS) for x in joints)
    contacts = (draft.data["contacts"][name] for name in draft.names("contacts"))
    rigid = [x for x in contacts if not (isinstance(x, dict) and is_compliant(x))]
    touches = rubs or bool(rigid)
    known = Known(kinds, dimension=draft.dimension or 3, offered=offered(draft), touches=touches)
    within = (f"{body}.{point}" for body, point in body_points(draft))
    known.ends = dict.fromkeys((*draft.names("points"), *known.of("body"), *within))
    return known


def offered(draft: Draft) -> dict[str, tuple[Offer, ...]]:
    """What each part of a scene that is being read offers; one of unknown type may offer all."""
    offers: dict[str, tuple[Offer, ...]] = {}
    for table in NOUNS:
        for name in draft.names(table):
            part, data = draft.part_class(table, name), draft.data[table][name]
            before = offers.get(name, ())  # of a name that is taken twice
            if part is None:
                kinds = TABLES[table].types
                offers[name] = (*before, *(offer for kind in kinds for offer in kind.offers))
            else:
                given = data if isinstance(data, dict) else {}
                offers[name] = before + part.offered(given.keys())
    return offers | {f"{body}.{point}": MOTION for body, point in body_points(draft)}


def body_points(draft: Draft) -> Iterator[tuple[str, str]]:
    """Name of each body and of each of its points."""
    for body in draft.names("bodies"):
        data: Any = draft.data["bodies"][body]
        points = data.get("points") if isinstance(data, dict) else None
        for point in points if isinstance(points, dict) else ():
            yield body, point
