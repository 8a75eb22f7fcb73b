"""The one place where an interrupt from the keyboard ends: no KeyboardInterrupt leaves a call.

pythonfmu's library would make it fmi2Fatal and free the instance, while the host goes on.
"""

from __future__ import annotations

import functools

TYPE_CHECKING = False  # typing would take a tenth of the time to import all this
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def shielded(instead: Callable[..., Any] = lambda *_: None) -> Callable[[Callable], Callable]:
    """Shield a method: after an interrupt it answers `instead(self, *arguments)`.

    The slave hears of it first, by its method `interrupted`. What is left is an interrupt in the
    microsecond in which the library prepares a call: it strikes before `try`, and nothing written
    in Python could help that. In hosts that are no Python programs none ever arrives.
    """

    def shield(call: Callable) -> Callable:
        @functools.wraps(call)
        def shielded_call(self: Any, *arguments: Any) -> Any:
            try:
                return call(self, *arguments)
            except KeyboardInterrupt:
                self.interrupted()
                return instead(self, *arguments)

        return shielded_call

    return shield
