"""The manifest of a family of FMUs: which of them has which values, as CSV or JSON."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from build_fmu.errors import UsageError
from build_fmu.printing import json_text
from build_fmu.study.csv_tables import cell, column_name
from solver.files import read_whole, why_unwritable

OWN_COLUMNS = ("variant", "fmu", "error")
LARGEST_WHOLE = 2**53
"""Beyond it not every whole number is one of double precision."""


@dataclass(frozen=True)
class Variant:
    """One row of a manifest."""

    number: int
    """From 1, in the order of the grid or table."""
    fmu: str
    """Name of the file beside the manifest; empty where there is none."""
    parameters: dict[str, object]
    mistakes: tuple[str, ...] = field(default=(), repr=False)
    lost: bool = field(default=False, repr=False)
    """Whether the process that wrote it died."""
    warnings: tuple[str, ...] = field(default=(), repr=False)
    """Of its scene."""

    @property
    def error(self) -> str:
        """Why there is no FMU."""
        return "\n".join(self.mistakes)


def manifest_path(folder: Path, name: str) -> Path:
    """Path of a manifest that may be written, before anything else is.

    Raises
    ------
    UsageError
        If the name is none of a manifest, or of a file that is something else.
    """
    path = folder / name
    if path.suffix not in (".csv", ".json"):
        text = f"{path}: a manifest is a .csv or .json file"
        raise UsageError(text)
    if path.name != name:
        text = f"{name}: a manifest stands beside the FMUs; write {path.name}"
        raise UsageError(text)
    if reason := why_unwritable(path):
        text = f"{path}: {reason}"
        raise UsageError(text)
    if path.exists() and not _is_manifest(path):
        text = f"{path} is there and is no manifest of variants; name another with --manifest"
        raise UsageError(text)
    return path


def _is_manifest(path: Path) -> bool:
    try:
        text = read_whole(path).decode()
        if path.suffix == ".json":
            document = json.loads(text)
            return isinstance(document, dict) and "variants" in document
    except (OSError, ValueError, RecursionError):
        return False
    return text.startswith(",".join(OWN_COLUMNS[:2]))


def manifest_text(variants: Sequence[Variant], kind: str, scene: str) -> str:
    """Text of a manifest, of the kind ".csv" or ".json"."""
    if kind == ".json":
        rows = [
            {"variant": v.number, "fmu": v.fmu, "parameters": v.parameters, "error": v.error}
            for v in variants
        ]
        return json_text({"scene": scene, "variants": rows}, indent=1) + "\n"
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    names = list(dict.fromkeys(name for v in variants for name in v.parameters))
    varied = [column_name(name, OWN_COLUMNS) for name in names]
    writer.writerow([*OWN_COLUMNS[:2], *varied, OWN_COLUMNS[2]])
    for v in variants:
        cells = [cell(v.parameters.get(name, "")) for name in names]
        writer.writerow([v.number, v.fmu, *cells, v.error.partition("\n")[0]])
    return file.getvalue()


def in_one_form(variants: Sequence[Variant]) -> list[Variant]:
    """Variants with the numbers of a parameter all with a point, or all whole: not 1 and 1.5."""
    broken = {n for v in variants for n, x in v.parameters.items() if isinstance(x, float)}

    def form(name: str, value: object) -> object:
        if type(value) is int and name in broken and abs(value) <= LARGEST_WHOLE:
            return float(value)
        return value

    return [
        replace(v, parameters={name: form(name, value) for name, value in v.parameters.items()})
        for v in variants
    ]
