"""Values of a slave: what is read and set, and what is refused.

A getter never raises and never hands out NaN; a setter takes all values or none. What was refused
is remembered until the same variable is set well.
"""

from __future__ import annotations

import functools
import os  # not pathlib, which would take a tenth of the time to import all this
from collections.abc import Sequence

from solver.runtime import AssemblyError, Integrator, Model, OptionError, StepError

from . import status
from .interrupt_guard import shielded
from .log import Fmi2Slave, sentence
from .status import INSTANTIATED, STEPPING, TERMINATED

TYPE_CHECKING = False  # typing would take a tenth of the time to import all this
if TYPE_CHECKING:
    from typing import Any

MODEL_FILE = "model.bin"
ZERO = {"Real": 0.0, "Integer": 0, "Boolean": False, "String": ""}


_model_of = functools.lru_cache(maxsize=8)(Model.from_bytes)
"""The model of some bytes: instances share it, and one that is made again finds it."""


def _getter(kind: str) -> Any:
    """Method that reads variables of a type by their value references."""

    @shielded(lambda self, vrs: self._substitutes(kind, vrs))
    def get(self: SlaveWithValues, vrs: list[int]) -> list:
        return self._get(kind, vrs)

    return get


def _setter(kind: str) -> Any:
    """Method that sets variables of a type by their value references."""

    @shielded()
    def set(self: SlaveWithValues, vrs: list[int], values: Sequence) -> None:
        self._set(kind, vrs, values)

    return set


class SlaveWithValues(Fmi2Slave):
    """A model with its state, as variables by their value references."""

    def __init__(self, **kwargs) -> None:
        super().__init__(**kwargs)
        if not self.instance_name:
            message = "fmi2Instantiate: the name of an instance must not be empty"
            raise OptionError(message)
        path = os.path.join(self.resources or ".", MODEL_FILE)
        try:
            with open(path, "rb") as file:
                self._model = _model_of(file.read())
        except OSError as error:
            message = f"fmi2Instantiate: {path} cannot be read: {error.strerror}"
            raise OptionError(message) from None
        self._integrator = Integrator(self._model, log=self.warn)
        self._phase = INSTANTIATED
        self._start_time: float | None = None
        self._assembled = False  # with the present parameters
        self._status = 0
        self._refusals: dict[int | str, str] = {}
        self._sort_variables()

    def _sort_variables(self) -> None:
        variables = list(enumerate(self._model.variables))
        self._of_type = {kind: {i for i, v in variables if v.type == kind} for kind in ZERO}
        self._settable = {i for i, v in variables if v.causality in ("parameter", "input")}
        self._fixed = {i for i in self._settable if variables[i][1].variability == "fixed"}
        self._status_index = next((i for i, v in variables if v.name == "solver.status"), -1)

    def _assemble(self) -> None:
        self._integrator.initialise(self._start_time)
        self._assembled = True
        if not self._refusals:
            self._status = 0

    # --------------------------------------------------------------------------------- values

    # A getter never hands out NaN; a setter takes all values, or none and a line in the log.
    get_real, get_integer, get_boolean, get_string = map(_getter, ZERO)
    set_real, set_integer, set_boolean, set_string = map(_setter, ZERO)

    def _get(self, kind: str, vrs: list[int]) -> list:
        try:
            self._check_type(kind, vrs)
            if not self._assembled and not self._settable.issuperset(vrs):
                if "assembly" in self._refusals:
                    return self._substitutes(kind, vrs)
                self._assemble()
            values = self._integrator.get(vrs)
        except AssemblyError as error:
            self._status = status.ASSEMBLY_FAILED
            self.error(sentence(error))
            return self._substitutes(kind, vrs)
        except StepError:
            values = [self._one(kind, vr) for vr in vrs]
        except Exception as error:
            self.error(sentence(error))
            return self._substitutes(kind, vrs)
        if self._status and self._status_index in vrs:
            values = [
                float(self._status) if vr == self._status_index else value
                for vr, value in zip(vrs, values, strict=True)
            ]
        return values

    def _one(self, kind: str, vr: int) -> object:
        """Value of one variable; what is not a finite number is 0, and said to be."""
        try:
            return self._integrator.get([vr])[0]
        except StepError as error:
            self._status = self._status or status.NOT_FINITE
            self.error(sentence(error))
            return self._substitute(kind, vr)

    def _substitutes(self, kind: str, vrs: list[int]) -> list:
        """What is handed out where nothing can be computed: parameters, inputs, and else zeros."""
        return [self._substitute(kind, vr) for vr in vrs]

    def _substitute(self, kind: str, vr: int) -> object:
        if vr == self._status_index and kind == "Real":
            return float(self._status)
        if vr in self._settable and vr in self._of_type[kind]:
            try:
                return self._integrator.get([vr])[0]
            except Exception:  # none may leave the slave: it would end the host
                return ZERO[kind]
        return ZERO[kind]

    def _set(self, kind: str, vrs: list[int], values: Sequence) -> None:
        try:
            self._check_type(kind, vrs)
            self._check_phase(vrs)
            self._integrator.set(vrs, values)
        except Exception as error:
            self._refuse(vrs, status.VALUE_REFUSED, sentence(error))
            return
        if self._phase < STEPPING:
            self._assembled = False
        for vr in vrs if self._refusals else ():
            self._refusals.pop(vr, None)

    def _check_type(self, kind: str, vrs: list[int]) -> None:
        if not self._of_type[kind].issuperset(vrs):
            strangers = sorted(set(vrs) - self._of_type[kind])
            text = f"value references {strangers} are not those of {kind} variables"
            raise OptionError(text)

    def _check_phase(self, vrs: list[int]) -> None:
        if self._phase == TERMINATED:
            text = "no value can be set after terminate; reset the instance first"
            raise OptionError(text)
        if self._phase == STEPPING and not self._fixed.isdisjoint(vrs):
            names = ", ".join(self._model.variables[vr].name for vr in vrs if vr in self._fixed)
            text = f"{names}: a fixed parameter cannot be set after the initialization; reset first"
            raise OptionError(text)

    # ------------------------------------------------------------------------------- refusals

    def _refuse(self, what: Sequence[int | str], code: int, text: str) -> None:
        """Remember a refusal: no step is taken while it stands."""
        self._status = code
        self._refusals.update(dict.fromkeys(what, text))
        self.error(text)

    def _break(self, code: int, text: str) -> None:
        """Refuse all steps after one call broke in its midst: nobody knows where it left things."""
        self._refuse(["break"], code, f"{text}; restore a saved state, or reset the instance")

    def interrupted(self) -> None:
        """Take notice of an interrupt from the keyboard."""
        self._break(status.INTERRUPTED, "interrupted from the keyboard")
