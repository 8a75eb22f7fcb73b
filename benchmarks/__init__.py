"""Time and accuracy of holonom, on one thread; `python -m benchmarks` measures and writes a page.

The thread counts are set here, before NumPy is imported by any module of this package: a numerical
library that takes a second thread would spend CPU time that its peer does not.
"""

import os

for _library in ("OMP", "OPENBLAS", "MKL", "NUMEXPR", "VECLIB_MAXIMUM"):
    os.environ[f"{_library}_NUM_THREADS"] = "1"
