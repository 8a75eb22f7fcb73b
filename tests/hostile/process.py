"""One process of an attack: runs some of its cases, each within its time.

python -m tests.hostile.process ATTACK SEED FIRST END FOLDER PATIENCE

Each case ends with a line ``> [number, finding]``; a case without one ended this process.
"""

from __future__ import annotations

import faulthandler
import json
import os
import signal
import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from types import FrameType

from tests.hostile.attack import module_of

CPU_LIMIT = 2.0
"""Seconds of processor time in which a case must be answered, if its attack names no others."""


class TooLongError(BaseException):
    """A case took longer than its time; no `except Exception` takes it for its own."""


def _too_long(_signal: int, _frame: FrameType | None) -> None:
    raise TooLongError


def outcome_of(case: Callable[[], str | None], limit: float) -> str | None:
    """What a case found: its own word, a traceback, or that it took too long."""
    signal.signal(signal.SIGVTALRM, _too_long)
    signal.setitimer(signal.ITIMER_VIRTUAL, limit)
    faulthandler.dump_traceback_later(20.0 * limit + 60.0, exit=True)
    begin = time.process_time()
    try:
        found = case()
    except TooLongError:
        found = f"took longer than {limit:g} s at {_frames()}"
    except Exception as error:
        found = f"{type(error).__name__}: {str(error)[:200]} at {_frames()}"
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        faulthandler.cancel_dump_traceback_later()
    spent = time.process_time() - begin
    return found or (f"took {spent:.1f} s, not {limit:g}" if spent > limit else None)


def _frames() -> str:
    frames = reversed(traceback.extract_tb(sys.exc_info()[2]))
    shown = [f"{Path(f.filename).name}:{f.lineno}" for f in frames if f.filename != __file__]
    return " < ".join(shown[:3])


def main() -> None:
    """Run the cases that the command line names."""
    attack, seed, first, end, folder, patience = sys.argv[1:]
    module = module_of(attack)
    limit = float(patience) * getattr(module, "CPU_LIMIT", CPU_LIMIT)
    for number in range(int(first), int(end)):
        found = outcome_of(lambda n=number: module.case(seed, n, Path(folder)), limit)
        print("> " + json.dumps([number, found]), flush=True)
    sys.stdout.flush()
    os._exit(0)  # pythonfmu's library may abort at exit, which is no finding of ours


if __name__ == "__main__":
    main()
