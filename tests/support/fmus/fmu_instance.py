"""FMUs of scenes for the tests, and an instance of one in fmpy that speaks in names."""

from __future__ import annotations

import contextlib
import functools
import io
import sys
import tempfile
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import fmpy
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import (
    FMU2Slave,
    calloc,
    fmi2CallbackAllocateMemoryTYPE,
    fmi2CallbackFreeMemoryTYPE,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
    fmi2Discard,
    fmi2LastSuccessfulTime,
    free,
)

import solver
from build_fmu import build
from build_fmu.fmpy_slaves import FMU3Run
from build_fmu.instance import LOADING
from build_fmu.payload import SLAVE_NAME

SCENES = Path(__file__).resolve().parents[3] / "scenes"
_FOLDER = tempfile.TemporaryDirectory(prefix="fmu-", ignore_cleanup_errors=True)

PENDULUM = """
name = "pendulum"
dimension = 2
gravity = [0, -9.81]
[parameters]
length = {length}
mass = {mass}
[inputs]
push = {{ start = 0.0, unit = "N" }}
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = ["length", 0], mass = "mass" }}
[joints]
rod = {{ type = "distance", points = ["O", "A"] }}
[forces]
wind = {{ type = "force", point = "A", value = ["{push}", 0] }}
[outputs]
clock = {{ value = "t", unit = "s" }}
reach = {{ value = "length" }}
[experiment]
stop_time = 1.0
step_size = 0.1
"""


def packed(content: Mapping[str, bytes]) -> bytes:
    """Archive with these files."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name, text in content.items():
            archive.writestr(zipfile.ZipInfo(name), text)
    return data.getvalue()


def root_of(path: Path) -> ElementTree.Element:
    """Root of the model description of an FMU."""
    with zipfile.ZipFile(path) as archive:
        return ElementTree.fromstring(archive.read("modelDescription.xml"))


def scene_fmu(name: str, *, native: bool = False) -> Path:
    """FMU of a file in scenes/."""
    return _built(name, None, native)


def text_fmu(text: str, *, native: bool = False) -> Path:
    """FMU of a scene given as TOML text."""
    return _built(f"text{abs(hash(text))}", text, native)


def pendulum(length=1.0, mass=1.0, push="push", *, native: bool = False) -> Path:
    """FMU of a pendulum with a horizontal force `push` at its end."""
    return text_fmu(PENDULUM.format(length=length, mass=mass, push=push), native=native)


@functools.cache
def _built(name: str, text: str | None, native: bool = False) -> Path:
    scene = solver.loads(text) if text else SCENES / f"{name}.toml"
    path = Path(_FOLDER.name, f"{name}{'_native' if native else ''}.fmu")
    return build(scene, path, native=native)


class Instance:
    """One instance; `log` has (status, category, text) of every message."""

    def __init__(self, path: Path, folder: str, *, logging: bool = True) -> None:
        self.description = fmpy.read_model_description(str(path), validate=False)
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}
        of_fmi3 = self.description.fmiVersion == "3.0"
        self.types = {
            v.name: v.type.replace("Float64", "Real") for v in self.description.modelVariables
        }
        self.log: list[tuple[int, str, str]] = []
        fmpy.extract(str(path), folder)
        with LOADING:
            self.fmu = (FMU3Run if of_fmi3 else FMU2Slave)(
                guid=self.description.guid,
                unzipDirectory=folder,
                modelIdentifier=self.description.coSimulation.modelIdentifier,
            )
        if of_fmi3:
            self.fmu.instantiate(loggingOn=logging, logMessage=self._hear_of_fmi3)
            return
        self.callbacks = self._callbacks()
        self.fmu.instantiate(callbacks=self.callbacks, loggingOn=logging)

    def _callbacks(self) -> fmi2CallbackFunctions:
        """Callbacks with a log per instance: fmpy's own logger is one for the whole process."""
        callbacks = fmi2CallbackFunctions()
        callbacks.logger = fmi2CallbackLoggerTYPE(self._hear)
        callbacks.allocateMemory = fmi2CallbackAllocateMemoryTYPE(calloc)
        callbacks.freeMemory = fmi2CallbackFreeMemoryTYPE(free)
        return callbacks

    def _hear(self, _environment, _name, status, category, message) -> None:
        text = message.decode() % ()  # a printf format, which must not ask for arguments
        self.log.append((status, (category or b"").decode(), text))

    def _hear_of_fmi3(self, _environment, status, category, message) -> None:
        self.log.append((status, category.decode(), message.decode()))

    def initialise(self, start=0.0, stop=None, tolerance=None, **values) -> None:
        """Set values and go through the initialization mode."""
        asked = {} if tolerance is None else {"tolerance": tolerance}  # FMU3Run takes none
        self.fmu.setupExperiment(startTime=start, stopTime=stop, **asked)
        self.set(**values)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def set(self, **values) -> None:
        """Set variables; a dot in a name is written as two underscores."""
        for key, value in values.items():
            name = key.replace("__", ".")
            setter = getattr(self.fmu, f"set{self.types[name]}")
            setter([self.references[name]], [value])

    def get(self, name: str):
        """Value of one variable."""
        value = getattr(self.fmu, f"get{self.types[name]}")([self.references[name]])[0]
        return value.decode() if isinstance(value, bytes) else value

    def outputs(self) -> list[float]:
        """Values of all outputs."""
        outputs = [v for v in self.description.modelVariables if v.causality == "output"]
        return self.fmu.getReal([v.valueReference for v in outputs])

    def step(self, t: float, h: float) -> bool:
        """Take a communication step; False if it was discarded."""
        try:
            self.fmu.doStep(t, h)
        except FMICallException as error:
            if error.status != fmi2Discard:
                raise
            return False
        return True

    def run(self, start: float, h: float, steps: int) -> list[list[float]]:
        """Outputs after each of several steps."""
        rows = []
        for i in range(steps):
            assert self.step(start + i * h, h), self.log
            rows.append(self.outputs())
        return rows

    @property
    def last_successful_time(self) -> float:
        """What the importer is told after a discarded step."""
        return self.fmu.getRealStatus(fmi2LastSuccessfulTime)


@contextlib.contextmanager
def instance(path: Path, *, logging: bool = True) -> Iterator[Instance]:
    """Instance in an unpack folder of its own; both are gone afterwards."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        made = Instance(path, folder, logging=logging)
        yield made
        with contextlib.suppress(FMICallException):
            made.fmu.terminate()
        made.fmu.freeInstance()


def slave_of(fmu: Instance) -> Any:
    """Slave as pythonfmu's library makes it, of the code that it has imported, without that."""
    resources = Path(fmu.fmu.unzipDirectory, "resources")
    module = sys.modules[resources.joinpath(SLAVE_NAME).read_text().strip()]
    return module.Slave(instance_name="a", resources=str(resources))


@functools.cache
def of_pendulum(kind: str = "Real") -> dict[str, int]:
    """Value references of the pendulum's variables of a type, by name."""
    variables = fmpy.read_model_description(str(pendulum())).modelVariables
    return {v.name: v.valueReference for v in variables if v.type == kind}


def status_of(slave: Any) -> float:
    """Value of the output `solver.status` of a slave of the pendulum."""
    return slave.get_real([of_pendulum()["solver.status"]])[0]


def stepping_slave() -> Any:
    """Slave of a pendulum at the end of its initialization, without pythonfmu's library."""
    with instance(pendulum()) as fmu:
        slave = slave_of(fmu)
    slave.setup_experiment(0.0)
    slave.enter_initialization_mode()
    slave.exit_initialization_mode()
    return slave
