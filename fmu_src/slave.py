"""The slave: the calls of FMI 2.0 co-simulation, as pythonfmu hands them on, on one `Integrator`.

pythonfmu turns an exception into fmi2Fatal and frees the instance, and it knows no other way to
refuse a call than a discarded step. So no exception leaves this class. What cannot be done is
written to the log and remembered, the old values stay, and every doStep is then discarded until
the value is set again, a saved state is restored or the instance is reset. The reason stands in
the log and, as a code (`status.py`), in the output `solver.status`.
"""

from __future__ import annotations

import math
import sys

from solver.runtime import AssemblyError, StepError

from . import snapshot, status
from .interrupt_guard import hang_doors, shielded
from .log import sentence
from .messages import Failures, ends_too_late, impossible_step, wrong_experiment
from .status import INITIALIZING, INSTANTIATED, STEPPING, TERMINATED
from .values import SlaveWithValues

TYPE_CHECKING = False  # typing would take a tenth of the time to import all this
if TYPE_CHECKING:
    from typing import Any

NOT_YET = "exitInitializationMode comes first"


class Slave(SlaveWithValues):
    """One instance of the FMU. fmi2Reset is a new object of this class."""

    def __init__(self, **kwargs) -> None:
        super().__init__(**kwargs)
        self._stop_time = math.inf  # no communication step ends after this
        self._own_horizon = self._integrator.state.head["horizon"]
        self._failures = Failures()
        hang_doors(self)
        if self.resources in sys.path:  # pythonfmu puts it there for every instance and leaves it
            sys.path.remove(self.resources)

    # ------------------------------------------------------------------------ initialisation

    @shielded()
    def setup_experiment(self, start_time, stop_time=None, tolerance=None) -> None:
        """Take start and stop time and, where the scene asks for a tolerance, this one."""
        if self._phase != INSTANTIATED:
            self.error("setupExperiment was ignored: it belongs before the initialization mode")
            return
        problem = wrong_experiment(start_time, stop_time)
        if problem:
            self._refuse(["experiment"], status.VALUE_REFUSED, problem)
            return
        self._refusals.pop("experiment", None)
        self._start_time, self._assembled = start_time, False
        self._stop_time = math.inf if stop_time is None else stop_time
        length = self._stop_time - start_time
        horizon = length if 0.0 < length < math.inf else self._own_horizon
        try:
            self._integrator.state.head["horizon"] = horizon
            if tolerance is None:
                return
            fixed = "this run has fixed steps, set by solver.step_size and solver.order"
            reason = fixed if tolerance > 0.0 else "it must be > 0"
            if self._integrator["solver.tolerance"] and tolerance > 0.0:
                self._integrator["solver.tolerance"] = tolerance
                return
        except Exception as error:
            reason = sentence(error)
        self.note(f"tolerance {tolerance!r} has no effect: {reason}")

    @shielded()
    def enter_initialization_mode(self) -> None:
        """Begin initialisation; outputs may be read from now on."""
        if self._phase != INSTANTIATED:
            self.error("enterInitializationMode was ignored: reset the instance first")
            return
        self._phase = INITIALIZING

    @shielded()
    def exit_initialization_mode(self) -> None:
        """Assemble the mechanism with the parameters that have arrived."""
        if self._phase != INITIALIZING:
            self.error("exitInitializationMode was ignored: enterInitializationMode comes first")
            return
        self._phase = STEPPING
        try:
            self._assemble()
            self._integrator.begin()
        except Exception as error:
            self._refuse(["assembly"], status.ASSEMBLY_FAILED, sentence(error))

    # ---------------------------------------------------------------------------------- steps

    @shielded(lambda *_: False)
    def do_step(self, current_time: float, step_size: float) -> bool:
        """Advance to `current_time + step_size`; False (fmi2Discard) leaves all as it was."""
        try:
            if (
                self._phase != STEPPING
                or self._refusals
                or not 0.0 < step_size < math.inf
                or ends_too_late(current_time, step_size, self._start_time, self._stop_time)
            ):
                return self._discard(*self._objection(current_time, step_size))
            self._integrator.advance(current_time, step_size)
        except StepError as error:
            return self._fail(error, current_time, step_size)
        except AssemblyError as error:
            return self._discard(status.ASSEMBLY_FAILED, sentence(error))
        except Exception as error:
            self._break(status.INTERNAL_FAULT, sentence(error))
            return False
        self._status = 0
        self._failures.forget()
        return True

    def _fail(self, error: StepError, current_time: float, step_size: float) -> bool:
        """Discard a step that the integrator refused, or could not solve."""
        if not error.status:
            return self._discard(status.STEP_REFUSED, str(error))
        internal = self._integrator.state.head["step_size"]
        remedy = self._failures.remedy(current_time, step_size, internal)
        # The kernel's own code is shown where it has one: 0 lets it through.
        return self._discard(0, f"{error}{remedy}", "repeated" if remedy else "discarded")

    def _objection(self, current_time: float, step_size: float) -> tuple[int, str]:
        """Code and sentence that say why this step is not even tried."""
        if self._refusals:
            reasons = "; ".join(dict.fromkeys(self._refusals.values()))
            return self._status or status.VALUE_REFUSED, f"no step is taken: {reasons}"
        if self._phase != STEPPING:
            when = "after terminate" if self._phase == TERMINATED else "before the initialization"
            return status.STEP_REFUSED, f"doStep was called {when}; it belongs between them"
        return status.STEP_REFUSED, impossible_step(current_time, step_size, self._stop_time)

    def _discard(self, code: int, text: str, what: str = "discarded") -> bool:
        self._status = code
        self.discard(text, what)
        return False

    @shielded()
    def terminate(self) -> None:
        """End the run; values can still be read."""
        if self._phase != STEPPING:
            when = "it was already called" if self._phase == TERMINATED else NOT_YET
            self.error(f"terminate was ignored: {when}")
            return
        self._phase = TERMINATED

    # ---------------------------------------------------------------------------------- state

    def _packed(self, state: bytes) -> bytes:
        what = self._phase, self._assembled, self._status, self._start_time, self._refusals
        return snapshot.pack(snapshot.Memory(*what), state)

    @shielded(lambda self: self._packed(b""))
    def _get_fmu_state(self) -> Any:
        try:
            state = self._integrator.save()
        except Exception as error:
            self.error(f"the state cannot be saved: {sentence(error)}")
            state = b""
        return self._packed(state)

    @shielded()
    def _set_fmu_state(self, state: Any) -> None:
        try:
            memory, data = snapshot.unpack(state)
            self._integrator.restore(data)
        except Exception as error:
            self._refuse(["state"], status.STATE_REFUSED, sentence(error))
            return
        self._phase, self._assembled, self._status, self._start_time, self._refusals = memory

    # A state is bytes already. The library asks the class, where nobody could shield a method.
    _fmu_state_to_bytes = _fmu_state_from_bytes = bytes  # type: ignore[assignment]
