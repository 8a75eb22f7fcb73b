"""Models, states, and the integrator that moves them, in Python.

Imports the standard library alone; its buffers are ctypes arrays.
"""

from .errors import AssemblyError, OptionError, Status, StepError
from .integrator import Integrator
from .model import Experiment, Model, Row, Rule, Variable
from .state import State

__all__ = [
    "AssemblyError",
    "Experiment",
    "Integrator",
    "Model",
    "OptionError",
    "Row",
    "Rule",
    "State",
    "Status",
    "StepError",
    "Variable",
]
