"""A host for an unpacked FMU that needs nothing but Python: arguments folder, name, steps, size.

Prints a hash of the outputs after the last step. For tests; fmpy needs NumPy.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

LOGGER = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 2, ctypes.c_int, *[ctypes.c_char_p] * 2)
ALLOCATE = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)
FREE = ctypes.CFUNCTYPE(None, ctypes.c_void_p)


class Callbacks(ctypes.Structure):
    """fmi2CallbackFunctions."""

    _fields_ = [
        ("logger", LOGGER),
        ("allocate", ALLOCATE),
        ("free", FREE),
        ("step_finished", ctypes.c_void_p),
        ("environment", ctypes.c_void_p),
    ]


def main(folder: Path, name: str, steps: int, size: float) -> str:
    """Hash of the last outputs."""
    library = ctypes.CDLL(str(next(folder.glob(f"binaries/*64/{name}.so"))))
    library.fmi2Instantiate.restype = ctypes.c_void_p
    callbacks = Callbacks(LOGGER(_say), ALLOCATE(lambda *_: None), FREE(lambda _: None))
    location = (folder / "resources").as_uri().encode()
    component = ctypes.c_void_p(
        library.fmi2Instantiate(b"bare", 1, b"", location, ctypes.byref(callbacks), 0, 0)
    )
    if not component:
        sys.exit("fmi2Instantiate gave no instance")
    references = output_references(folder)
    real = ctypes.c_double
    library.fmi2SetupExperiment(component, 0, real(0.0), real(0.0), 0, real(0.0))
    library.fmi2EnterInitializationMode(component)
    library.fmi2ExitInitializationMode(component)
    for i in range(steps):
        status = library.fmi2DoStep(component, real(i * size), real(size), 1)
        assert status == 0, status
    values = (real * len(references))()
    array = (ctypes.c_uint32 * len(references))(*references)
    library.fmi2GetReal(component, array, ctypes.c_size_t(len(references)), values)
    library.fmi2Terminate(component)
    library.fmi2FreeInstance(component)
    assert "numpy" not in sys.modules
    return hashlib.sha256(repr(list(values)).encode()).hexdigest()


def _say(_environment, _instance, _status, _category, message) -> None:
    sys.stderr.write(message.decode() + "\n")


def output_references(folder: Path) -> list[int]:
    """Value references of all outputs."""
    root = ElementTree.parse(folder / "modelDescription.xml").getroot()
    variables = root.findall("ModelVariables/ScalarVariable")
    return [int(v.get("valueReference", "")) for v in variables if v.get("causality") == "output"]


if __name__ == "__main__":
    sys.stdout.write(main(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), float(sys.argv[4])))
    sys.stdout.flush()
    os._exit(0)  # pythonfmu's exit handlers read freed memory (docs/fmu.md, section 5)
