"""`python -m build_kernel`: compile the kernel into the source tree, and install nothing.

With ``--all`` it is compiled for all platforms, with zig: FMUs built then run on Linux and Windows,
and native ones on all platforms (`holonom build --native --platforms all`).
"""

import sys
from pathlib import Path

from build_kernel.compiler import CompilerError, compile_for_all, compile_kernel

if sys.argv[1:] not in ([], ["--all"]):
    sys.exit("usage: python -m build_kernel [--all]")
try:
    chosen = compile_for_all if sys.argv[1:] else compile_kernel
    chosen(Path(__file__).resolve().parent.parent)
except CompilerError as error:
    sys.exit(f"holonom: {error}")
