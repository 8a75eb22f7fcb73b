"""Files that parts of a scene name: their content travels with the scene, as a text in base64.

    data:model/obj;name=bowl.obj;base64,...         (RFC 2397)

may stand wherever the name of a file stands.
"""

import base64
import binascii
import math
import re
from collections.abc import Sequence
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import quote, unquote

from solver.files import read_whole
from solver.scene.mistakes import Path

if TYPE_CHECKING:
    from solver.scene.draft import Draft

MEDIA = {"stl": "model/stl", "obj": "model/obj", "csv": "text/csv"}
_DATA = re.compile(r"data:(?:model|text)/(stl|obj|csv)(?:;name=([^;,]*))?;base64,")


class DataFile(NamedTuple):
    """A file and its content."""

    name: str
    form: str
    """Its suffix in small letters, a key of ``MEDIA``."""
    content: bytes

    @property
    def text(self) -> str:
        """What may stand for its name."""
        data = base64.b64encode(self.content).decode()
        return f"data:{MEDIA[self.form]};name={quote(self.name)};base64,{data}"


def read_file(
    draft: "Draft", path: Path, file: str, forms: Sequence[str], help: str
) -> DataFile | None:  # fmt: skip
    """Read a file with one of these suffixes, or a text that stands for it; report what is none."""
    given = _DATA.match(file)
    where = FilePath(draft.source.name).parent / file
    form = given[1] if given else where.suffix.lower().removeprefix(".")
    names = " or ".join(f".{x}" for x in forms)
    if form not in forms:
        shown = f"data of a .{form}" if given else f"'{file}'"
        return draft.error(path, f"must be a file {names}, got {shown}", help)
    if given:
        try:
            content = base64.b64decode(file[given.end() :], validate=True)
        except binascii.Error:
            return draft.error(path, "holds no data in base64", "write the name of a file")
        return DataFile(unquote(given[2] or f"{path[-2]}.{form}"), form, content)
    try:
        return DataFile(file, form, read_whole(where))
    except (OSError, ValueError) as problem:  # a ValueError: no name of a file has such characters
        reason = getattr(problem, "strerror", None) or str(problem)
        message = f"file '{where.as_posix()}' cannot be read: {reason.lower()}"
        help = f"name a file {names}, by its path from the folder of the scene"
        return draft.error(path, message, help)


def rows_of_table(text: str) -> list[tuple[int, list[str]]]:
    """Cells of the rows of a CSV file that have any, each with the number of its line."""
    lines = enumerate(text.splitlines(), 1)
    return [(n, re.split("[,;\t]", line)) for n, line in lines if line.strip(" ,;\t")]


def number(cell: str) -> float | None:
    """Return the finite number in a cell of a CSV file; None for anything else."""
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
