"""`python -m benchmarks.peers.peer_run MODULE`: what `run` of a module makes of a request.

The request is JSON on the standard input; the last line of what is printed is JSON, the answer.
Needs NumPy and, of other codes, the one that is run alone.
"""

from __future__ import annotations

import json
import sys
from importlib import import_module

if __name__ == "__main__":
    found = import_module(sys.argv[1]).run(json.load(sys.stdin))
    print()
    print(json.dumps(found))
