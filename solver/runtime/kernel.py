"""The compiled kernel: where it lies, and its functions with their arguments."""

from __future__ import annotations

import ctypes
import functools
import os
import sys
import sysconfig
from array import array
from collections.abc import Callable

from .layout import ABI, CODES


class KernelMissingError(Exception):
    """There is no compiled kernel for this platform, or it does not load."""


def library_path(dimension: int) -> str:
    """Return where the kernel of this platform for models of this dimension lies when built."""
    suffix = {"win32": "dll", "cygwin": "dll", "darwin": "dylib"}.get(sys.platform, "so")
    kind = "planar" if dimension == 2 else "spatial"
    return os.path.join(os.path.dirname(__file__), "_kernel", f"libholonom_{kind}.{suffix}")


def _other(path: str) -> str:
    return (
        f"{path} belongs to another version of this Python code; compile the kernel: "
        "python -m build_kernel"
    )


_POINTER, _INTEGER, _REAL, _COUNT = ctypes.c_void_p, ctypes.c_int32, ctypes.c_double, ctypes.c_int64
LOOK = ctypes.CFUNCTYPE(_INTEGER)
"""What a step asks now and then: 1 for its end."""
FUNCTIONS = {
    "abi": (_INTEGER, []),
    "dimension": (_INTEGER, []),
    "state_size": (_COUNT, [_POINTER]),
    "work_size": (_COUNT, [_POINTER]),
    "instance_size": (_COUNT, [_POINTER, _COUNT, _POINTER, _COUNT]),
    "make": (_POINTER, [_POINTER, _POINTER, _INTEGER]),
    "reset": (None, [_POINTER]),
    "message": (ctypes.c_char_p, [_POINTER]),
    "remarks": (ctypes.c_char_p, [_POINTER]),
    "get": (_INTEGER, [_POINTER, _POINTER, _INTEGER, _POINTER]),
    "set": (_INTEGER, [_POINTER, _POINTER, _INTEGER, _POINTER, _POINTER]),
    "word": (ctypes.c_char_p, [_POINTER, _INTEGER, _REAL]),
    "number_of_word": (_REAL, [_POINTER, _INTEGER, ctypes.c_char_p]),
    "assemble": (_INTEGER, [_POINTER]),
    "steps": (ctypes.c_char_p, [_POINTER, _INTEGER]),
    "begin": (None, [_POINTER]),
    "let_look": (None, [_POINTER, LOOK]),
    "use_mesh": (None, [_POINTER, _POINTER]),
    "move": (_INTEGER, [_POINTER, _REAL, _REAL]),
    "saved_size": (_COUNT, [_POINTER]),
    "save": (None, [_POINTER, _POINTER]),
    "restore": (_INTEGER, [_POINTER, ctypes.c_char_p, _COUNT]),
    "rows": (None, [_POINTER] * 3),
    "phase_of": (_INTEGER, [_POINTER]),
    "model_of": (_POINTER, [_POINTER]),
    "numbers_of": (_POINTER, [_POINTER]),
    "state_of": (_POINTER, [_POINTER]),
    "work_of": (_POINTER, [_POINTER]),
    "evaluate": (None, [_POINTER, _POINTER, _INTEGER]),
    "operate": (_REAL, [_INTEGER, _POINTER, _INTEGER]),
    "run_fmu": (_INTEGER, [_POINTER, _POINTER, _INTEGER, _POINTER]),
}
"""Result and arguments of each function of the core, ``holonom_...``, that is called here."""


def load_library(dimension: int, path: str | None = None) -> ctypes.CDLL:
    """Load the kernel for models of this dimension, 2 or 3, and declare its functions.

    Raises
    ------
    KernelMissingError
        When the library is absent, is for another machine, or was built from other sources.
    """
    path = path or library_path(dimension)
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        text = (
            f"no kernel for this platform, {sysconfig.get_platform()} ({error}); compile it: "
            "python -m build_kernel"
        )
        raise KernelMissingError(text) from error
    for name, (result, arguments) in FUNCTIONS.items():
        function = getattr(library, f"holonom_{name}", None)
        if function is None:
            raise KernelMissingError(_other(path))
        function.restype, function.argtypes = result, arguments
    if (library.holonom_abi(), library.holonom_dimension()) != (ABI, dimension):
        raise KernelMissingError(_other(path))
    return library


@functools.cache
def shared_library(dimension: int) -> ctypes.CDLL:
    """Load a kernel once: ctypes keeps some 1.4 kB for every time that a library is loaded."""
    return load_library(dimension)


@functools.cache
def in_core(name: str) -> Callable[..., float]:
    """Return an operation of the core on floats, with the bits of one in a run.

    Its value is NaN where there is no real one, and an infinity where the result is too large. A
    spline takes x, then the numbers of its table. One array may stand for all floats.

    Raises
    ------
    KernelMissingError
        When there is no compiled kernel.
    """
    operate, code = shared_library(2).holonom_operate, CODES.index(name)

    def value(*arguments) -> float:
        numbers = arguments[0]
        if not isinstance(numbers, array):
            numbers = array("d", arguments if len(arguments) > 2 else (*arguments, 0.0, 0.0))
        return operate(code, *numbers.buffer_info())

    return value
