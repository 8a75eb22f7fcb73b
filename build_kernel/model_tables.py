"""Write the core's picture of a model and a state from their declaration in Python, and tables.

`solver/runtime/layout.py` has the fields, ``solver/kernel/scratch.py`` the scratch of a call,
``solver/runtime/errors.py`` the codes of failures, ``solver/options.py`` the settings. What stands
in a comment behind a field there is its comment here.

    model_tables.h      structures and enumerations
    section_tables.h    where sections begin
    check_tables.h      how long tables are, and between what their numbers lie
    ..._tables.h        of elementary functions
"""

from __future__ import annotations

import os
import re
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from runpy import run_path
from threading import Lock
from typing import Any, NamedTuple

from build_kernel import elementary_tables

ONE_AT_A_TIME = Lock()
"""Python up to 3.11 at times refuses a text that it parses while another thread parses as well."""
INTEGERS = {"i": "int32_t", "I": "uint32_t", "Q": "uint64_t", "B": "uint8_t", "d": "double"}


Values = Mapping[str, Any]
"""What a Python file declares, by name."""


class Declared(NamedTuple):
    """The values of a Python file, and the comments behind names in its tables and classes."""

    values: Values
    notes: Mapping[tuple[str, str], str]

    def note(self, table: str, name: str) -> str:
        """Comment behind a name in a table; empty if there is none."""
        return self.notes.get((table, name), "")


def declared(path: Path) -> Declared:
    """Run a Python file, and read its comments; one on a line of its own belongs to those above."""
    notes: dict[tuple[str, str], str] = {}
    table, names = "", []
    for line in path.read_text("utf-8").splitlines():
        code, _, comment = line.partition("# ")
        if begun := re.match(r"(?:class )?(\w+)(?: =|\()", code):
            table = begun[1]
        if code.strip():
            keys = re.findall(r'"(\w+)":', code) or re.findall(r'"([-\w]+)"', code)
            names = keys or re.findall(r"^ +(\w+) =", code)
        for name in names if comment else ():
            notes[table, name] = f"{notes.get((table, name), '')} {comment.strip()}".lstrip()
    return Declared(run_path(str(path)), notes)


def headers(solver: Path) -> dict[str, str]:
    """Return the text of each header by its name; `solver` is the folder of that package."""
    layout, scratch = (declared(solver / x) for x in ("runtime/layout.py", "kernel/scratch.py"))
    structures = (
        *_structures(layout, scratch, declared(solver / "options.py").values),
        *_enumerations(layout, declared(solver / "runtime/errors.py")),
    )
    found = (
        ("model_tables", "<stdint.h>", structures),
        ("section_tables", '"internal.h"', _sections(layout.values, scratch.values)),
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


def _noted(code: str, *notes: str) -> str:
    """Return a line of C and its comment."""
    note = ": ".join(filter(None, notes))
    return f"    {code} /* {note} */" if note else f"    {code}"


# ------------------------------------------------------------------------------ structures


def _structure(name: str, fields: Iterable[str]) -> str:
    return "\n".join([f"typedef struct {name} {{", *fields, f"}} {name};\n"])


def _structures(layout: Declared, scratch: Declared, options: Values) -> Iterator[str]:
    values = layout.values
    for name in ("ABI", "MOST_COARSENESS", "MOST_SAMPLING"):
        yield f"#define HOLONOM_{name} {values[name]}\n"
    for name in ("USUAL_STEP", "USUAL_TOLERANCE", "LEAST_TOLERANCE"):
        yield f"#define HOLONOM_{name} {options[name]}\n"
    for what, formula in options["CHOSEN"].items():
        usual = re.sub(r"\busual_\w+", lambda match: f"HOLONOM_{match[0].upper()}", formula)
        in_c = re.sub(r"\b[a-z]\w*", lambda match: f"(head)[S_{match[0].upper()}]", usual)
        yield f"#define HOLONOM_CHOSEN_{what.upper()}(head) ({in_c})\n"
    yield _structure("holonom_elimination", _tables(layout, "ELIMINATION"))
    yield _structure("holonom_model", [
        *(_noted(f"int32_t {name};", layout.note("SIZES", name)) for name in values["SIZES"]),
        *_tables(layout, "TABLES", _own_tables(values)),
        f"    holonom_elimination {', '.join(('full', *values['FACTORS']))};",
        *(
            _noted(f"int32_t {name}_at;", length, layout.note("OFFSETS", name))
            for name, length in values["OFFSETS"].items()
        ),
    ])  # fmt: skip
    yield _structure("hm_registers", ["    double *r0, *r1, *dr, *adjoint, *slope;"])
    lengths = ", ".join(f"n_{group}" for group in values["GROUPS"])
    vectors = "    double *head;", *_vectors(layout, "STATE"), f"    int64_t {lengths};"
    yield _structure("hm_state", vectors)
    yield _structure("hm_work", _vectors(scratch, "WORK"))
    yield _structure("hm_measured", _vectors(layout, "MEASURED"))
    for name in ("HEADER", "VARIABLE", "RULE", "ROW"):
        size = struct.calcsize("<" + "".join(values[name].values()))
        yield _structure(f"hm_{name.lower()}", _record(layout, name))
        yield f'_Static_assert(sizeof(hm_{name.lower()}) == {size}, "bytes of a model");\n'


def _tables(layout: Declared, table: str, names: Iterable[str] | None = None) -> Iterator[str]:
    for name in names or layout.values[table]:
        known = layout.values[table][name]
        length = known.length if hasattr(known, "length") else f"{known.count} + 1"
        yield _noted(f"const int32_t *{name};", length, layout.note(table, name))


def _vectors(declaration: Declared, table: str) -> Iterator[str]:
    """Yield the vectors; a first and a second one are an array, those of a function a structure."""
    for name, length in declaration.values[table].items():
        if name == "r.r0":
            yield "    hm_registers r;"
        elif not name.startswith("r.") and not name.endswith("_second"):
            field = name.replace("_first", "[2]")
            tables = table, *map(str.upper, declaration.values.get("GROUPS", ()))
            notes = (declaration.note(x, name) for x in tables)
            yield _noted(f"double *{field};", length, next(filter(None, notes), ""))


def _record(layout: Declared, table: str) -> Iterator[str]:
    for name, letter in layout.values[table].items():
        text = letter.endswith("s")
        kind, size = ("char", f"[{letter[:-1]}]") if text else (INTEGERS[letter], "")
        yield _noted(f"{kind} {name}{size};", layout.note(table, name))


# ---------------------------------------------------------------------------- enumerations


def _enumeration(
    declaration: Declared, table: str, prefix: str, names: Iterable[str], last: str = "",
    values: Mapping[str, int] | None = None,
) -> str:  # fmt: skip
    """Return an enumeration with the names of a table, upper case, behind a prefix."""
    lines = [
        _noted(
            f"{prefix}{_constant(name)}{f' = {values[name]}' if values else ''},",
            declaration.note(table, name),
        )
        for name in names
    ]
    return "\n".join(["enum {", *lines, *([f"    {prefix}{last}"] if last else []), "};\n"])


def _constant(name: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])|-", "_", name).upper()


def _enumerations(layout: Declared, errors: Declared) -> Iterator[str]:
    values = layout.values
    sizes = {f"N_{name}": len(values[name]) for name in ("SIZES", "TABLES", "OFFSETS", "ACCOUNTS")}
    yield "enum { " + ", ".join(f"{name} = {size}" for name, size in sizes.items()) + " };\n"
    whole = [name for name, x in values.items() if name.isupper() and type(x) is int]
    codes = [name for name in whole if name not in ("ENTRY_POINTS", "ABI")]
    yield _enumeration(layout, "", "", codes, values=values)
    for table, prefix, last in (
        ("HEAD", "S_", "HEAD"), ("ISLAND", "I_", "SIZE"), ("ISLAND_PARTS", "ISLAND_", "COLUMNS"),
        ("CONTACT", "C_", "SIZE"), ("FRICTION", "F_", "SIZE"), ("NORMAL_SUMS", "NORMAL_", "SUMS"),
        ("CONTACT_MODES", "CONTACT_", "MODES"), ("FRICTION_MODES", "FRICTION_", "MODES"),
        ("MESH", "MESH_", "SIZE"), ("MESH_TAKEN", "TAKEN_", "WAYS"), ("MESH_ENDS", "END_", "WAYS"),
        ("CLOSINGS", "CLOSING_", "WAYS"), ("ROW_KINDS", "ROW_", "KINDS"), ("CODES", "T_", "END"),
    ):  # fmt: skip
        yield _enumeration(layout, table, prefix, values[table], last)
    yield f"#define HOLONOM_DRAWN_INTO {values['DRAWN_INTO']!r}\n"
    yield f"#define HOLONOM_ONE_PLACE {values['ONE_PLACE']!r}\n"
    for field, words in values["WORDS"].items():
        yield _enumeration(layout, "WORDS", f"{field.upper()}_", words, "END")
    for table, prefix in (("FLAGS", ""), ("RESULTS", "HOLONOM_")):
        yield _enumeration(layout, table, prefix, values[table], values=values[table])
    yield _enumeration(layout, "RELATIONS", "", values["RELATIONS"].values())
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


def _field(name: str) -> str:
    """Return what a vector is called in C: a first and a second one are an array."""
    return name.replace("_first", "[0]").replace("_second", "[1]")


def _sections(layout: Mapping[str, Any], scratch: Mapping[str, Any]) -> Iterator[str]:
    """Yield functions that lay the vectors of a structure over a block, and those of its length."""
    counts = layout["COUNTS"] | scratch["COUNTS"]
    groups = [f"n_{group}" for group in layout["GROUPS"]]
    for name, lengths, kept in (
        ("state", {"head": "S_HEAD"} | layout["STATE"], groups), ("work", scratch["WORK"], []),
        ("measured", layout["MEASURED"], []),
    ):  # fmt: skip
        counted = _counts(counts, lengths.values(), layout["SIZES"])
        in_c = {field: _in_c(length, layout["SIZES"]) for field, length in lengths.items()}
        terms = "\n        + ".join(f"({length})" for length in in_c.values())
        yield "\n".join([
            f"int64_t hm_size_of_{name}(const holonom_model *m)\n{{",
            *counted, f"    return {terms};\n}}\n",
        ])  # fmt: skip
        yield "\n".join([
            f"int64_t hm_map_{name}(const holonom_model *m, double *block, hm_{name} *x)\n{{",
            *_counts(counts, [*lengths.values(), *kept], layout["SIZES"]),
            "    const double *begin = block;", *(f"    x->{count} = {count};" for count in kept),
            *(
                f"    x->{_field(field)} = block, block += {length};"
                for field, length in in_c.items()
            ),
            "    return block - begin;\n}\n",
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
        # All kinds of factors are checked alike: the number of values is an argument.
        return "n_values" if formula == "n_lu_values" else in_c(formula)

    rules = _rules(layout["ELIMINATION"], "e->", _places(layout["ELIMINATION"]), of_factors)
    arguments = ", const holonom_elimination *e, const int32_t *length, int64_t n_values"
    yield FUNCTION.format("has_factors", arguments, rules)
    own = {name: tables[name] for name in _own_tables(layout)}
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


def _own_tables(layout: Mapping[str, Any]) -> list[str]:
    """Return the tables that are of no elimination."""
    kinds, names = "|".join(layout["FACTORS"]), "|".join(layout["ELIMINATION"])
    return [x for x in layout["TABLES"] if not re.fullmatch(f"(({kinds})_)?({names})", x)]


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
