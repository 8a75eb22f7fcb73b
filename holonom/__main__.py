"""`python -m holonom` does the same as the command `holonom`."""

import sys

from build_fmu.__main__ import main

if __name__ == "__main__":
    sys.exit(main())
