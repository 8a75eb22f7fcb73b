"""`python -m build_fmu` does the same as the command `holonom`."""

from __future__ import annotations

import os
import sys

from build_fmu import command_line


def main() -> int:
    """Run the command line and return its exit code, or leave with it where an FMU was loaded.

    The exit handlers of pythonfmu's library read freed memory, and now and then abort a process
    whose work is done; so they are not run.
    """
    code = command_line.main()
    if "fmpy.fmi2" in sys.modules:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    return code


if __name__ == "__main__":
    sys.exit(main())
