"""The state: all that survives from one step to the next, in one block of doubles."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator, Mapping

from .layout import HEAD, PLACE, state_sections


class Head(Mapping[str, float]):
    """The scalars at the head of a state, by name."""

    def __init__(self, block: ctypes.Array[ctypes.c_double]) -> None:
        self._block = block

    def __getitem__(self, name: str) -> float:
        """Return a scalar."""
        return self._block[PLACE[name]]

    def __setitem__(self, name: str, value: float) -> None:
        """Set a scalar."""
        self._block[PLACE[name]] = value

    def __iter__(self) -> Iterator[str]:
        """Names in their order in memory."""
        return iter(HEAD)

    def __len__(self) -> int:
        """Return the number of scalars."""
        return len(HEAD)


class State:
    """Named views of a state's block; writing to them writes the state.

    `head` maps names to scalars, `vectors` those of ``layout.state_sections`` to memory views of
    doubles, which `numpy.asarray` shares.
    """

    def __init__(self, sizes: Mapping[str, int], block: ctypes.Array[ctypes.c_double]) -> None:
        self.block = block
        self.head = Head(block)
        view: memoryview[float] = memoryview(block).cast("B").cast("d")
        self.vectors: dict[str, memoryview[float]] = {
            name: view[start : start + length]
            for name, (start, length) in state_sections(sizes).items()
        }
