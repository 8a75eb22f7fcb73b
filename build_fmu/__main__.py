"""`python -m build_fmu` does the same as `build-fmu`."""

from __future__ import annotations

import sys

from build_fmu.command_line import main

if __name__ == "__main__":
    sys.exit(main())
