"""The slave: the calls of FMI 2.0 co-simulation, as pythonfmu hands them on, on one `Integrator`.

pythonfmu turns an exception into fmi2Fatal and frees the instance, and it knows no other way to
refuse a call than a discarded step. So no exception leaves this class. What cannot be done is
written to the log and remembered, the old values stay, and every doStep is then discarded until
the value is set again, a saved state is restored or the instance is reset. The reason stands in
the log and, as a code (`status.py`), in the output `solver.status`.
"""

from __future__ import annotations

import math
import os  # not pathlib, which would take a tenth of the time to import all this
import sys
from collections.abc import Sequence

from solver.runtime import AssemblyError, Integrator, Model, OptionError, StepError

from . import snapshot, status
from .log import LoggedSlave, sentence

TYPE_CHECKING = False  # typing would take a tenth of the time to import all this
if TYPE_CHECKING:
    from typing import Any

MODEL_FILE = "model.bin"
PHASES = INSTANTIATED, INITIALIZING, STEPPING, TERMINATED = (0, 1, 2, 3)
ZERO = {"Real": 0.0, "Integer": 0, "Boolean": False, "String": ""}
ROUNDING, STOP_SLACK = 8, 1e-3
"""A step may end after the stop time by so many last digits of it and this part of the step:
communication points are often sums, and a million additions of 0.1 are off by 1e-5 steps."""


class Slave(LoggedSlave):
    """One instance of the FMU. fmi2Reset is a new object of this class."""

    def __init__(self, **kwargs) -> None:
        super().__init__(**kwargs)
        with open(os.path.join(self.resources or ".", MODEL_FILE), "rb") as file:
            self._model = Model.from_bytes(file.read())
        self._integrator = Integrator(self._model, log=self.warn)
        self._phase = INSTANTIATED
        self._start_time: float | None = None
        self._latest = sys.float_info.max  # no communication step ends after this
        self._assembled = False  # with the present parameters
        self._status = 0
        self._refusals: dict[int | str, str] = {}
        self._sort_variables()
        if self.resources in sys.path:  # pythonfmu puts it there for every instance and leaves it
            sys.path.remove(self.resources)

    def _sort_variables(self) -> None:
        variables = list(enumerate(self._model.variables))
        self._of_type = {kind: {i for i, v in variables if v.type == kind} for kind in ZERO}
        self._settable = {i for i, v in variables if v.causality in ("parameter", "input")}
        self._fixed = {i for i in self._settable if variables[i][1].variability == "fixed"}
        self._status_index = next((i for i, v in variables if v.name == "solver.status"), -1)

    # ------------------------------------------------------------------------ initialisation

    def setup_experiment(self, start_time, stop_time=None, tolerance=None) -> None:
        """Take start and stop time and, where the scene asks for a tolerance, this one."""
        if self._phase != INSTANTIATED:
            self.error("setupExperiment was ignored: it belongs before the initialization mode")
            return
        self._start_time, self._assembled = start_time, False
        if stop_time is not None:
            self._latest = stop_time + ROUNDING * math.ulp(max(abs(stop_time), abs(start_time)))
        try:
            if stop_time is not None and stop_time > start_time:
                self._integrator.state.head["horizon"] = stop_time - start_time
            if tolerance is None:
                return
            fixed = "this run is one of fixed steps, set by solver.step_size and solver.order"
            reason = fixed if tolerance > 0.0 else "it must be > 0"
            if self._integrator["solver.tolerance"] and tolerance > 0.0:
                self._integrator["solver.tolerance"] = tolerance
                return
        except Exception as error:
            reason = sentence(error)
        self.note(f"tolerance {tolerance!r} has no effect: {reason}")

    def enter_initialization_mode(self) -> None:
        """Begin initialisation; outputs may be read from now on."""
        if self._phase != INSTANTIATED:
            self.error("enterInitializationMode was ignored: reset the instance first")
            return
        self._phase = INITIALIZING

    def exit_initialization_mode(self) -> None:
        """Assemble the mechanism with the parameters that have arrived."""
        if self._phase != INITIALIZING:
            self.error("exitInitializationMode was ignored: enterInitializationMode comes first")
            return
        self._phase = STEPPING
        try:
            self._assemble()
        except Exception as error:
            self._refuse(["assembly"], status.ASSEMBLY_FAILED, sentence(error))

    def _assemble(self) -> None:
        self._integrator.initialise(self._start_time)
        self._assembled = True
        self._status = 0

    # ---------------------------------------------------------------------------------- steps

    def do_step(self, current_time: float, step_size: float) -> bool:
        """Advance to `current_time + step_size`; False (fmi2Discard) leaves all as it was."""
        try:
            if (
                self._phase != STEPPING
                or self._refusals
                or not step_size > 0.0
                or not current_time + (1.0 - STOP_SLACK) * step_size <= self._latest
            ):
                return self._discard(*self._objection(current_time, step_size))
            self._integrator.advance(current_time, step_size)
        except StepError as error:
            # The kernel's own code is shown where it has one: 0 lets it through.
            return self._discard(0 if error.status else status.STEP_REFUSED, str(error))
        except AssemblyError as error:
            return self._discard(status.ASSEMBLY_FAILED, sentence(error))
        except KeyboardInterrupt:
            return self._break(status.INTERRUPTED, "interrupted from the keyboard")
        except Exception as error:
            return self._break(status.INTERNAL_FAULT, sentence(error))
        self._status = 0
        return True

    def _objection(self, current_time: float, step_size: float) -> tuple[int, str]:
        """Code and sentence that say why this step is not even tried."""
        if self._refusals:
            reasons = "; ".join(dict.fromkeys(self._refusals.values()))
            return self._status or status.VALUE_REFUSED, f"no step is taken: {reasons}"
        if self._phase != STEPPING:
            when = "after terminate" if self._phase == TERMINATED else "before the initialization"
            return status.STEP_REFUSED, f"doStep was called {when}; it belongs between them"
        step = f"step from t = {current_time!r} s with size {step_size!r} s"
        if not step_size > 0.0:
            return status.STEP_REFUSED, f"{step}: the size must be > 0 s"
        return status.STEP_REFUSED, (
            f"{step}: it ends after the stop time given to setupExperiment; take a shorter step "
            "or define no stop time"
        )

    def _discard(self, code: int, text: str) -> bool:
        self._status = code
        self.discard(text)
        return False

    def _break(self, code: int, text: str) -> bool:
        """Discard a step in the midst of which something broke: nobody knows where it stands."""
        self._refuse(["step"], code, f"{text}; restore a saved state, or reset the instance")
        return False

    def terminate(self) -> None:
        """End the run; values can still be read."""
        self._phase = TERMINATED

    # --------------------------------------------------------------------------------- values

    def get_real(self, vrs: list[int]) -> list[float]:
        """Values of Real variables; never NaN."""
        return self._get("Real", vrs)

    def get_integer(self, vrs: list[int]) -> list[int]:
        """Values of Integer variables: there are none, so zeros and a line in the log."""
        return self._get("Integer", vrs)

    def get_boolean(self, vrs: list[int]) -> list[bool]:
        """Values of Boolean variables."""
        return self._get("Boolean", vrs)

    def get_string(self, vrs: list[int]) -> list[str]:
        """Values of String variables."""
        return self._get("String", vrs)

    def set_real(self, vrs: list[int], values: list[float]) -> None:
        """Take values of Real variables: all of them, or none and a line in the log."""
        self._set("Real", vrs, values)

    def set_integer(self, vrs: list[int], values: list[int]) -> None:
        """Refuse: there are no Integer variables."""
        self._set("Integer", vrs, values)

    def set_boolean(self, vrs: list[int], values: list[bool]) -> None:
        """Take values of Boolean variables: all of them, or none and a line in the log."""
        self._set("Boolean", vrs, values)

    def set_string(self, vrs: list[int], values: list[str]) -> None:
        """Take values of String variables: all of them, or none and a line in the log."""
        self._set("String", vrs, values)

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
        except Exception as error:
            self.error(sentence(error))
            return self._substitutes(kind, vrs)
        if self._status and self._status_index in vrs:
            values = [
                float(self._status) if vr == self._status_index else value
                for vr, value in zip(vrs, values, strict=True)
            ]
        return values

    def _substitutes(self, kind: str, vrs: list[int]) -> list:
        """What is handed out where nothing can be computed: parameters, inputs, and else zeros."""
        return [self._substitute(kind, vr) for vr in vrs]

    def _substitute(self, kind: str, vr: int) -> object:
        if vr == self._status_index and kind == "Real":
            return float(self._status)
        if vr in self._settable and vr in self._of_type[kind]:
            try:
                return self._integrator.get([vr])[0]
            except Exception:
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

    # ---------------------------------------------------------------------------------- state

    def _get_fmu_state(self) -> Any:
        try:
            state = self._integrator.save()
        except Exception as error:
            self.error(f"the state cannot be saved: {sentence(error)}")
            state = b""
        header = {
            "phase": self._phase,
            "start_time": self._start_time,
            "assembled": self._assembled,
            "status": self._status,
            "refusals": list(self._refusals.items()),
        }
        return snapshot.pack(header, state)

    def _set_fmu_state(self, state: Any) -> None:
        try:
            header, data = snapshot.unpack(state)
            memory = snapshot.memory(header, PHASES)
            self._integrator.restore(data)
        except Exception as error:
            self._refuse(["state"], status.STATE_REFUSED, sentence(error))
            return
        self._phase, self._start_time, self._assembled, self._status, self._refusals = memory

    @staticmethod
    def _fmu_state_to_bytes(state: Any) -> bytes:
        return state

    @staticmethod
    def _fmu_state_from_bytes(state: bytes) -> Any:
        return state

    # ------------------------------------------------------------------------------- refusals

    def _refuse(self, what: Sequence[int | str], code: int, text: str) -> None:
        """Remember a refusal: no step is taken while it stands."""
        self._status = code
        self._refusals.update(dict.fromkeys(what, text))
        self.error(text)
