"""`python -m build_kernel`: compile the kernel into the source tree, and install nothing."""

import sys
from pathlib import Path

from build_kernel.compiler import CompilerError, compile_kernel

try:
    compile_kernel(Path(__file__).resolve().parent.parent)
except CompilerError as error:
    sys.exit(f"holonom: {error}")
