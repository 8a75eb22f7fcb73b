"""Types of the fields of a scene file: numbers or expressions, vectors, tables, names (pydantic).

A number is a finite float or the text of an expression, and arrives as a ``Reading``. A field whose
mistake has been reported holds ``BROKEN``.
"""

# pyright: reportInvalidTypeForm=false
from __future__ import annotations

import math
from typing import Annotated, Any, TypeAlias, Union

from pydantic import Discriminator, Field, PlainValidator, Tag, WithJsonSchema
from pydantic_core import PydanticCustomError

from solver.scene.expression import ExpressionError, read
from solver.scene.grammar import Reading
from solver.scene.units import in_si

BROKEN: Any = object()
"""Value of a field whose mistake has been reported; everything accepts it."""


def shown(value: object) -> str:
    """Write a value the way it stands in the file."""
    if value is None or isinstance(value, bool):
        return "null" if value is None else str(value).lower()
    if isinstance(value, list):
        return f"[{', '.join(shown(item) for item in value)}]"
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, int) and abs(value) >= 10**20:  # Python refuses to write long ones
        power = round(math.log10(abs(value)))
        return f"an integer of {power + (abs(value) >= 10**power)} digits"
    return repr(value) if isinstance(value, (str, int, float)) else str(value)


def mistake(about: dict[str, Any]) -> PydanticCustomError:
    """Describe a mistake in our own words: `message`, and perhaps `help` and `mark`."""
    return PydanticCustomError("number", "not a number of the scene", about)


def _number(value: object) -> Reading:
    """Read a number or the text of an expression."""
    if type(value) is float and math.isfinite(value):  # most are
        return Reading(value, value)
    if isinstance(value, str):
        try:
            return read(value)
        except ExpressionError as error:
            about = {
                "message": f"{error.message}, column {error.column} of '{value}'",
                "help": error.help or in_si(value),
                "mark": (value, error.column),
            }
            raise mistake(about) from None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        about = {"message": f"must be a number or an expression, got {shown(value)}"}
        raise mistake(about)
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        about = {"message": f"must be a finite number, got {shown(value)}"}
        raise mistake(about)
    return Reading(value, number)


Expression = Annotated[
    Reading,
    PlainValidator(_number),
    WithJsonSchema(
        {"type": ["number", "string"], "description": "a number, or an expression as text"}
    ),
]
Vector = Annotated[list[Expression], WithJsonSchema(
    {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 3}
)]  # fmt: skip


def shape_of(value: object) -> str:
    """Say whether a value is a number, a vector, a list of vectors or a table."""
    if isinstance(value, dict):
        return "table"
    if not isinstance(value, list):
        return "number"
    return "vectors" if any(isinstance(item, list) for item in value) else "vector"


def by_shape(number: Any, table: Any, vector: Any, vectors: Any) -> Any:
    """Type of a field that is read as one of these, by the shape of its value."""
    types = {"number": number, "table": table, "vector": vector, "vectors": vectors}
    tagged = tuple(Annotated[kind, Tag(shape)] for shape, kind in types.items())
    return Annotated[Union[tagged], Discriminator(shape_of)]  # noqa: UP007


NumberOrVector: TypeAlias = by_shape(Expression, Expression, Vector, Vector)
VectorOrVectors: TypeAlias = by_shape(Vector, Vector, Vector, list[Vector])
NumberToMatrix: TypeAlias = by_shape(Expression, Expression, Vector, list[Vector])


def _two(*example: object) -> Any:
    return Field(min_length=2, max_length=2, examples=[list(example)])


Two = Annotated[list[str], _two("A", "B")]
TwoBodies = Annotated[list[str], _two("ground", "rod")]
TwoJoints = Annotated[list[str], _two("first", "second")]
TwoNumbers = Annotated[list[Expression], _two(1.0, 1.0)]
TwoVectors = Annotated[list[Vector], _two([1, 0, 0], [0, 1, 0])]
