"""Sources of an FMU: one C file that includes all others, the model as data, the configuration.

An importer compiles ``sources/all.c`` without any option. What the files share is declared static
there, so that the functions of the standard alone are seen from outside.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from build_fmu.errors import EnvironmentLackError
from build_fmu.payload import package_folder
from build_fmu.platforms import SCOPES, library_scope
from build_fmu.xml_parts import document, element
from solver.runtime.kernel import shared_library

if TYPE_CHECKING:
    from solver.runtime import Model

SUFFIXES = (".c", ".h", ".def")
UNIT = "all.c"
"""The file that is compiled."""
_SHARED = re.compile(
    r"^(?:HOLONOM_API )?((?:const )?(?:struct )?\w+ \**(?:hm|holonom|slave)_\w+\()", re.M
)
_UNIT = """/* All of this FMU, as one unit: compile this file alone. */
#include "model_config.h"

#include "without_libm.h"
/* Ahead of the others, so that what they say to the compiler holds for all of these. */
#include "internal.h"

#if __FLT_EVAL_METHOD__ == 2 || defined(_M_IX86)
#error "numbers must have 53 bits in registers, too; on x86 compile with -msse2 -mfpmath=sse"
#endif
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "the model is for processors whose numbers begin with the lowest byte"
#endif
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic error "-Wimplicit-function-declaration"
#endif
{files}"""
_FILE = """#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#endif
#include "{name}"
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC pop_options
#endif
"""
_CONFIGURATION = """/* What is known of the FMU when it is compiled. */
#define DIM {dimension}
#define HM_SCOPE {scope}
#define HOLONOM_SOURCE
#define HOLONOM_MODEL "model.h"
#define HOLONOM_MODEL_BYTES {bytes}

/* For memory of one instance. A program without malloc says with HOLONOM_BLOCKS for how many
   instances and saved states, together, there is room in static memory. */
#define HOLONOM_INSTANCE_BYTES {instance}
#define HOLONOM_TEXT_ROWS {rows}

/* A program of several FMUs defines for each what its functions have before their names. */
#if defined(FMI{fmi}_OVERRIDE_FUNCTION_PREFIX)
#undef FMI{fmi}_FUNCTION_PREFIX
#ifdef FMI{fmi}_ACTUAL_FUNCTION_PREFIX
#define FMI{fmi}_FUNCTION_PREFIX FMI{fmi}_ACTUAL_FUNCTION_PREFIX
#endif
#endif
#ifdef FMI{fmi}_FUNCTION_PREFIX
#define HOLONOM_PASTE(a, b) a##b
#define HOLONOM_PREFIXED(a, b) HOLONOM_PASTE(a, b)
{names}#endif
"""


def source_files(fmi: int) -> dict[str, bytes]:
    """Files of all models, by path in the archive.

    Raises
    ------
    EnvironmentLackError
        If headers are missing that the compilation of the kernel writes.
    """
    kernel, slave = package_folder("solver") / "kernel", package_folder("fmu_src") / "native"
    if not (kernel / "model_tables.h").is_file():
        text = f"{kernel}/model_tables.h is missing; compile the kernel: python -m build_kernel"
        raise EnvironmentLackError(text)
    others = f"fmi{5 - fmi}.", "host."
    paths = [p for p in sorted(kernel.rglob("*"), key=lambda p: p.name) if p.suffix in SUFFIXES]
    paths += sorted(p for p in slave.iterdir() if p.suffix in SUFFIXES)
    chosen = [path for path in paths if not path.name.startswith(others)]
    text = {p.name: p.read_text(encoding="utf-8") for p in chosen}
    units = [_FILE.format(name=name) for name in text if name.endswith(".c")]
    found = {n: _SHARED.sub(r"static \1", t) if n.endswith(".h") else t for n, t in text.items()}
    found[UNIT] = _UNIT.format(files="".join(units))
    return {f"sources/{name}": content.encode() for name, content in found.items()}


def model_files(model: Model, data: bytes, fmi: int, identifier: str) -> dict[str, bytes]:
    """Files of one model by path in the archive; `data` is what it is else read from."""
    words = memoryview(data.ljust(-len(data) % 8 + len(data), b"\0")).cast("Q")
    rows = [", ".join(f"0x{w:x}" for w in words[k : k + 8]) for k in range(0, len(words), 8)]
    table = "static const uint64_t hm_model[] = {\n" + ",\n".join(rows) + "};\n"
    names = functions((package_folder("fmu_src") / f"native/fmi{fmi}.h").read_text("utf-8"))
    prefix = f"HOLONOM_PREFIXED(FMI{fmi}_FUNCTION_PREFIX, "
    dimension = model.sizes["dim"]
    configuration = _CONFIGURATION.format(
        dimension=dimension, scope=SCOPES.index(library_scope(model.sizes)),
        bytes=len(data), fmi=fmi,
        instance=model.checked_file(shared_library(dimension))[1],
        rows=len(model.rows) + len(model.rules),
        names="".join(f"#define {name} {prefix}{name})\n" for name in names),
    )  # fmt: skip
    build = document(
        element(
            "fmiBuildDescription",
            element(
                "BuildConfiguration",
                element("SourceFileSet", element("SourceFile", name=UNIT), language="C99"),
                modelIdentifier=identifier,
            ),
            fmiVersion="3.0",
        )
    )
    text = {"model.h": table, "model_config.h": configuration}
    files = {name: content.encode() for name, content in text.items()}
    return {f"sources/{n}": c for n, c in {**files, "buildDescription.xml": build}.items()}


def functions(header: str) -> list[str]:
    """Names of the functions in the tables of fmi2.h or fmi3.h."""
    found = re.findall(r"X\((?:[\w *]+, )?(fmi\d[A-Z]\w+)[,)]", header)
    kinds = re.findall(r"FMI\d_VALUES\(X, \w+, ([A-Z]\w+)\)", header)
    ways = re.findall(r"(fmi\d(?:Get|Set))##", header)
    return list(dict.fromkeys([*found, *(way + kind for way in ways for kind in kinds)]))
