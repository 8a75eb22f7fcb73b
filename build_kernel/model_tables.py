"""Write the core's picture of a model and a state from their declaration in Python, and tables.

`solver/runtime/layout.py` has the fields, ``solver/kernel/scratch.py`` the scratch of a call,
``solver/options.py`` and ``solver/runtime/errors.py`` the codes of settings and failures. What
stands in a comment behind a field there is its comment here.

    model_tables.h      structures and enumerations
    section_tables.h    where sections begin
    check_tables.h      how long tables are, and between what their numbers lie
    ..._tables.h        of elementary functions
"""

from __future__ import annotations

import ast
import os
import re
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import groupby
from pathlib import Path
from threading import Lock
from typing import Any

from build_kernel import elementary_tables

ONE_AT_A_TIME = Lock()
"""Python up to 3.11 at times refuses a text that it parses while another thread parses as well."""
INTEGERS = {"i": "int32_t", "I": "uint32_t", "Q": "uint64_t", "B": "uint8_t", "d": "double"}


class Declaration:
    """The values of a Python file, and the comments and lines of the names in them.

    Only statements that define one of the names `wanted` are run, or all of them.
    """

    def __init__(self, path: Path, *wanted: str) -> None:
        text = path.read_text("utf-8")
        self.values: dict[str, Any] = {"__name__": path.stem}
        self._line: dict[tuple[str, str], int] = {}
        self._comments = _comments(text.splitlines())
        for node in ast.parse(text).body:
            name = getattr(node, "name", "") or _target(node)
            if not wanted or name in wanted or isinstance(node, ast.ImportFrom):
                exec(compile(ast.Module([node], []), path, "exec"), self.values)
            for part in ast.walk(node):
                if isinstance(part, ast.Constant) and isinstance(part.value, str):
                    self._line.setdefault((name, part.value), part.lineno)
                elif isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store):
                    self._line.setdefault((name, part.id), part.lineno)

    def lines(self, table: str, names: Iterable[str]) -> Iterator[tuple[list[str], str]]:
        """Yield the names that stand in one line, and the comment behind them."""
        for line, group in groupby(names, lambda name: self._line.get((table, name), 0)):
            yield list(group), self._comments.get(line, "")


def _target(node: ast.stmt) -> str:
    """Return the name that a statement gives a value; "" if there are several."""
    targets = node.targets if isinstance(node, ast.Assign) else []
    return "".join(target.id for target in targets if isinstance(target, ast.Name))


def _comments(lines: list[str]) -> dict[int, str]:
    """Comments by the lines that they stand in; one on a line of its own goes on."""
    found, last = {}, 0
    for number, line in enumerate(lines, start=1):
        code, _, comment = line.partition("  # ")
        if comment and code.strip():
            found[number], last = comment.strip(), number
        elif line.lstrip().startswith("# ") and last == number - 1:
            found[last] += " " + line.strip(" #")
            last = number
    return found


def headers(solver: Path) -> dict[str, str]:
    """Return the text of each header by its name; `solver` is the folder of that package."""
    layout = Declaration(solver / "runtime" / "layout.py")
    scratch = Declaration(solver / "kernel" / "scratch.py")
    options = Declaration(solver / "options.py", "FORMULATIONS")
    errors = Declaration(solver / "runtime" / "errors.py", "Status")
    structures = *_structures(layout, scratch), *_enumerations(layout, options, errors)
    sections = _sections(layout.values, scratch.values)
    found = (
        ("model_tables", "<stdint.h>", structures),
        ("section_tables", '"internal.h"', sections),
        ("check_tables", '"model_file.h"', _checks(layout.values)),
        *((name, '"double_double.h"', x) for name, x in elementary_tables.tables().items()),
    )
    return {f"{name}.h": _header(name, include, parts) for name, include, parts in found}


def write_headers(solver: Path) -> None:
    """Write the headers that are not there or have another text, each at once."""
    with ONE_AT_A_TIME:
        for name, text in headers(solver).items():
            path = solver / "kernel" / name
            if not path.exists() or path.read_text("utf-8") != text:
                mine = path.with_suffix(f".{os.getpid()}")  # other processes may write it as well
                mine.write_text(text, "utf-8")
                mine.replace(path)


def _header(name: str, include: str, parts: Iterable[str]) -> str:
    guard = f"HOLONOM_{name.upper()}_H"
    first = f"/* Written by build_kernel/model_tables.py. */\n#ifndef {guard}\n#define {guard}\n"
    return "\n".join([first, f"#include {include}\n", *parts, "#endif\n"])


def _noted(code: str, note: str, width: int = 118) -> str:
    """Return a line of C and its comment, behind it if there is room."""
    if not note:
        return code
    together = f"{code} /* {note} */"
    return together if len(together) <= width else f"    /* {note} */\n{code}"


# ------------------------------------------------------------------------------ structures


def _structure(name: str, fields: Iterable[str]) -> str:
    return "\n".join([f"typedef struct {name} {{", *fields, f"}} {name};\n"])


def _structures(layout: Declaration, scratch: Declaration) -> Iterator[str]:
    values = layout.values
    for name in ("ABI", "MOST_SAMPLING"):
        yield f"#define HOLONOM_{name} {values[name]}\n"
    yield _structure("holonom_elimination", _tables(layout, "ELIMINATION"))
    lean = [name for name in values["TABLES"] if name.startswith("lean_")]
    own = [x for x in values["TABLES"] if x not in values["ELIMINATION"] and x not in lean]
    split = own.index("load_slot_ptr")
    yield _structure("holonom_model", [
        *(
            _noted(f"    int32_t {', '.join(names)};", note)
            for names, note in layout.lines("SIZES", values["SIZES"])
        ),
        *_tables(layout, "TABLES", own[:split]), "    holonom_elimination full, lean;",
        *_tables(layout, "TABLES", own[split:]),
        *(
            _noted("    int32_t " + ", ".join(f"{name}_at" for name in names) + ";",
                   _lengths(values["OFFSETS"], names, note))
            for names, note in layout.lines("OFFSETS", values["OFFSETS"])
        ),
    ])  # fmt: skip
    yield _structure("hm_registers", ["    double *r0, *r1, *dr, *adjoint, *slope;"])
    yield _structure("hm_state", ["    double *head;", *_vectors(layout, "STATE")])
    yield _structure("hm_work", _vectors(scratch, "WORK"))
    yield _structure("hm_measured", _vectors(layout, "MEASURED"))
    for name in ("HEADER", "VARIABLE", "RULE", "ROW"):
        size = struct.calcsize("<" + "".join(values[name].values()))
        yield _structure(f"hm_{name.lower()}", _record(layout, name))
        yield f'_Static_assert(sizeof(hm_{name.lower()}) == {size}, "bytes of a model");\n'


def _lengths(lengths: Mapping[str, str], names: Iterable[str], note: str) -> str:
    """Return the lengths of some sections and their comment."""
    found = list(dict.fromkeys(lengths[name] for name in names))
    return ": ".join(filter(None, ["; ".join(filter(None, found)), note]))


def _tables(layout: Declaration, table: str, names: Iterable[str] | None = None) -> Iterator[str]:
    tables = layout.values[table]
    for group, note in layout.lines(table, names or tables):
        length = getattr(tables[group[0]], "length", None)
        if length is None:
            length = f"{tables[group[0]].count} + 1"
        pointers = ", ".join(f"*{name}" for name in group)
        yield _noted(f"    const int32_t {pointers};", ": ".join(filter(None, [length, note])))


def _vectors(declaration: Declaration, table: str) -> Iterator[str]:
    lengths = declaration.values[table]
    for names, note in declaration.lines(table, lengths):
        fields = [f"*{_field(name)}" for name in names if not name.endswith("_second")]
        fields = [name.replace("[0]", "[2]") for name in fields]
        note = _lengths(lengths, names, note)
        if not names[0].startswith("r."):
            yield _noted(f"    double {', '.join(fields)};", note)
        elif names[0] == "r.r0":
            yield "    hm_registers r; /* of one function */"


def _field(name: str) -> str:
    """Return what a vector is called in C: a first and a second one are an array."""
    return name.replace("_first", "[0]").replace("_second", "[1]")


def _record(layout: Declaration, table: str) -> Iterator[str]:
    letters = layout.values[table]
    for names, note in layout.lines(table, letters):
        for letter, alike in groupby(names, letters.__getitem__):
            fields = ", ".join(alike)
            text = letter.endswith("s")
            kind, size = ("char", f"[{letter[:-1]}]") if text else (INTEGERS[letter], "")
            yield _noted(f"    {kind} {fields}{size};", note)


# ---------------------------------------------------------------------------- enumerations


def _enumeration(
    declaration: Declaration, table: str, prefix: str, names: Iterable[str], last: str = "",
    values: Mapping[str, int] | None = None,
) -> str:  # fmt: skip
    """Return an enumeration with the names of a table, upper case, behind a prefix."""
    lines = [
        _noted("    " + " ".join(
            f"{prefix}{_constant(name)}{f' = {values[name]}' if values else ''}," for name in group
        ), note)
        for group, note in declaration.lines(table, names)
    ]  # fmt: skip
    return "\n".join(["enum {", *lines, *([f"    {prefix}{last}"] if last else []), "};\n"])


def _constant(name: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])|-", "_", name).upper()


def _enumerations(layout: Declaration, options: Declaration, errors: Declaration) -> Iterator[str]:
    values = layout.values
    sizes = {f"N_{name}": len(values[name]) for name in ("SIZES", "TABLES", "OFFSETS")}
    yield "enum { " + ", ".join(f"{name} = {size}" for name, size in sizes.items()) + " };\n"
    whole = [name for name, x in values.items() if name.isupper() and type(x) is int]
    codes = [name for name in whole if name not in ("ENTRY_POINTS", "ABI")]
    yield _enumeration(layout, "", "", codes, values=values)
    for table, prefix, last in (
        ("HEAD", "S_", "HEAD"), ("ISLAND", "I_", "SIZE"), ("ISLAND_PARTS", "ISLAND_", "COLUMNS"),
        ("CONTACT", "C_", "SIZE"), ("FRICTION", "F_", "SIZE"), ("NORMAL_SUMS", "NORMAL_", "SUMS"),
        ("FRICTION_MODES", "FRICTION_", "MODES"),
        ("ROW_KINDS", "ROW_", "KINDS"), ("CODES", "T_", "END"),
    ):  # fmt: skip
        yield _enumeration(layout, table, prefix, values[table], last)
    for field, words in values["WORDS"].items():
        yield _enumeration(layout, "WORDS", f"{field.upper()}_", words, "END")
    for table, prefix in (("FLAGS", ""), ("RESULTS", "HOLONOM_")):
        yield _enumeration(layout, table, prefix, values[table], values=values[table])
    yield _enumeration(layout, "RELATIONS", "", values["RELATIONS"].values())
    formulations = options.values["FORMULATIONS"]
    yield _enumeration(options, "FORMULATIONS", "HOLONOM_", formulations)
    codes = {name: int(code) for name, code in errors.values["Status"].__members__.items()}
    yield _enumeration(errors, "Status", "HOLONOM_", codes, values=codes)


# -------------------------------------------------------------------------------- sections


def _in_c(formula: str, sizes: Iterable[str]) -> str:
    """Return a formula of sizes and counts in C."""
    known = set(sizes)
    return re.sub(
        r"\b[a-z]\w*\b(?!\()",
        lambda match: f"(int64_t)m->{match[0]}" if match[0] in known else match[0],
        formula,
    )


def _counts(counts: dict[str, str], formulas: Iterable[str], sizes: Iterable[str]) -> list[str]:
    """Return definitions of the counts that formulas need, each after those it needs itself."""
    needed = set(re.findall(r"\w+", " ".join(formulas)))
    for name in reversed(counts):
        if name in needed:
            needed |= set(re.findall(r"\w+", counts[name]))
    return [
        f"    const int64_t {name} = {_in_c(formula, sizes)};"
        for name, formula in counts.items()
        if name in needed
    ]


TAKE = """static double *take(double *block, int64_t *used, int64_t count)
{
    double *start = block ? block + *used : 0;
    *used += count;
    return start;
}
"""


def _sections(layout: Mapping[str, Any], scratch: Mapping[str, Any]) -> Iterator[str]:
    """Yield functions that lay the vectors of a structure over a block, and return its length."""
    yield TAKE
    counts = layout["COUNTS"] | scratch["COUNTS"]
    for name, lengths in (
        ("state", {"head": "S_HEAD"} | layout["STATE"]), ("work", scratch["WORK"]),
        ("measured", layout["MEASURED"]),
    ):  # fmt: skip
        yield "\n".join([
            f"int64_t hm_map_{name}(const holonom_model *m, double *block, hm_{name} *x)\n{{",
            *_counts(counts, lengths.values(), layout["SIZES"]), "    int64_t used = 0;",
            *(
                f"    x->{_field(field)} = take(block, &used, {_in_c(length, layout['SIZES'])});"
                for field, length in lengths.items()
            ),
            "    return used;\n}\n",
        ])  # fmt: skip


# ---------------------------------------------------------------------------------- checks

FUNCTION = "static int {}(const holonom_model *m, const hm_counts *k{})\n{{\n{}}}\n"


def _checks(layout: Mapping[str, Any]) -> Iterator[str]:
    """Yield what sizes make up, and whether tables, sections and islands are as declared."""
    counts, tables = layout["COUNTS"], layout["TABLES"]
    names = set(layout["SIZES"])

    def in_c(formula: str) -> str:
        return re.sub(r"(?<!->)\b(" + "|".join(counts) + r")\b", r"k->\1", _in_c(formula, names))

    yield _structure("hm_counts", [f"    int64_t {name};" for name in counts])
    yield "\n".join([
        "static hm_counts counts_of(const holonom_model *m)\n{", *_counts(counts, counts, names),
        f"    return (hm_counts){{{', '.join(counts)}}};\n}}\n",
    ])  # fmt: skip

    def of_factors(formula: str) -> str:
        # Full and lean factors are checked alike: how many values they store is an argument.
        return "n_values" if formula == "n_lu_values" else in_c(formula)

    rules = _rules(layout["ELIMINATION"], "e->", _places(layout["ELIMINATION"]), of_factors)
    arguments = ", const holonom_elimination *e, const int32_t *length, int64_t n_values"
    yield FUNCTION.format("has_factors", arguments, rules)
    own = {x: y for x, y in tables.items() if x.removeprefix("lean_") not in layout["ELIMINATION"]}
    rules = _rules(own, "m->", _places(tables), in_c)
    yield FUNCTION.format("has_tables", ", const int32_t *length", rules)
    sections = {name: in_c(length) for name, length in layout["OFFSETS"].items() if length}
    held = [f"hm_holds(m, m->{name}_at, {length})" for name, length in sections.items()]
    yield FUNCTION.format("has_sections", "", "    return " + " &&\n           ".join(held) + ";\n")
    bounds = [
        f"        {{{in_c(low)}, {in_c(end)}}}, /* {name} */\n"
        for name, (low, end) in layout["ISLAND_PARTS"].items()
    ]
    array = "    const int64_t bound[ISLAND_COLUMNS][2] = {\n" + "".join(bounds) + "    };\n"
    yield FUNCTION.format("has_islands", "", f"{array}    return hm_divides(m, bound);\n")


def _places(tables: Iterable[str]) -> dict[str, str]:
    return {name: f"length[{i}]" for i, name in enumerate(tables)}


def _rules(
    tables: Mapping[str, Any], owner: str, place: Mapping[str, str], in_c: Callable[[str], str]
) -> str:
    """Return C that tells whether tables, with their lengths at these places, are as declared."""
    found = []
    for name, table in tables.items():
        own, given = place[name], f"{owner}{name}, {place[name]}"
        if hasattr(table, "total"):
            total = table.total
            total = f"{place[total]} / {tables[total].width}" if total in tables else in_c(total)
            most = in_c(table.most) or "INT32_MAX"
            found.append(f"hm_rises({given}, {in_c(table.count)}, {total}, {most})")
            continue
        length = in_c(table.length)
        if table.low is not None:
            end = "INT64_MAX" if table.end is None else in_c(str(table.end))
            found.append(f"hm_has({given}, {length or own}, {table.low}, {end})")
        elif length:
            found.append(f"{own} == {length} /* {name} */")
        elif table.width > 1:
            found.append(f"{own} % {table.width} == 0 /* {name} */")
    return "    return " + " &&\n           ".join(found) + ";\n"
