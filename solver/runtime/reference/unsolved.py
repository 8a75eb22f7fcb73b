"""Why a step or the assembly cannot be solved."""

from __future__ import annotations

from ..errors import Status


class UnsolvedError(Exception):
    """A step or the assembly cannot be solved, for the reason `status`."""

    def __init__(self, status: Status) -> None:
        super().__init__(status.name)
        self.status = status
