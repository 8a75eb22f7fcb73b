"""The one place where exceptions end: no fault and no interrupt from the keyboard leaves a call.

pythonfmu's library would make it fmi2Fatal and free the instance, while the host goes on. The slave
hears of it by its method `broken`. Python gives an interrupt to the next line that it runs. Three
places can be that line: one within a call, where `try` catches it; the first of a call, outside of
any `try`; and, where the library still prepares the call, this first one again, by far most often.
So the library gets each method through a door: a generator that waits within `try`, and so takes in
what is pending when the library asks for the method. What is left is the way between the door and
the call: of interrupts at random in a loop of short calls 3 in 100 strike there, and 19 in 100
without the doors.
"""

from __future__ import annotations

import functools
import operator
from weakref import ref

TYPE_CHECKING = False  # typing would take a tenth of the time to import all this
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

DOOR, BEHIND = "_door_of_", "_behind_door_of_"


def shielded(*instead: Callable[..., Any]) -> Callable[[Callable], Any]:
    """Shield a method: where an exception breaks it, these are called in its stead, in turn."""
    return functools.partial(_Shielded, instead)


class _Shielded(property):
    """A method behind a door. On the way to it no line of Python runs but those of the door."""

    def __init__(self, instead: tuple[Callable[..., Any], ...], call: Callable) -> None:
        @functools.wraps(call)
        def shielded_call(slave: Any, *arguments: Any) -> Any:
            for each in (call, *instead):
                try:
                    return each(slave, *arguments)
                except (KeyboardInterrupt, Exception) as error:
                    slave.broken(error)
            return None

        self._call = shielded_call

    def __set_name__(self, owner: type, name: str) -> None:
        super().__init__(operator.methodcaller(DOOR + name))
        setattr(owner, BEHIND + name, self._call)


def hang_doors(slave: Any) -> None:
    """Give a slave the doors of its shielded methods, which do not keep it alive."""
    for kind in type(slave).__mro__:
        for name, call in vars(kind).items():
            if isinstance(call, _Shielded):
                door = _door(ref(slave), BEHIND + name)
                next(door)  # from here on it waits within `try`
                setattr(slave, DOOR + name, door.__next__)


def _door(slave: Callable[[], Any], name: str) -> Iterator[Callable]:
    while True:
        try:
            while True:  # within, as Python looks for interrupts where a loop turns
                yield getattr(slave(), name)
        except KeyboardInterrupt as error:  # not a fault of the library, whose arguments are wrong
            slave().broken(error)


def takes_signals(slave: Callable[[], Any]) -> Iterator[int]:
    """Let Python answer signals within a call of C, as it does between two lines.

    The library asks this for the next value: 1 where a handler has raised something in this call.
    """
    while True:
        try:
            while True:  # within, as Python looks for signals where a loop turns
                yield slave().struck
        except GeneratorExit:
            return
        except BaseException as error:  # which could not pass through the library
            slave().broken(error)


def guarded(slave: Callable[[], Any], name: str) -> Callable:
    """Return a method for the library to call, through which no exception could pass."""

    def guarded_call(*arguments: Any) -> None:
        try:
            getattr(slave(), name)(*arguments)
        except BaseException as error:
            slave().broken(error)

    return guarded_call
