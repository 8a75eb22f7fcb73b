"""What all parts of a scene file have in common: fixed fields, and no value that is null."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, ValidatorFunctionWrapHandler, field_validator

from solver.scene.fields import BROKEN, mistake


class Part(BaseModel):
    """A table with fixed fields."""

    model_config = ConfigDict(extra="forbid", strict=True, arbitrary_types_allowed=True)

    @field_validator("*", mode="wrap")
    @classmethod
    def _accept_broken(cls, value: object, handler: ValidatorFunctionWrapHandler) -> object:
        if value is None:  # JSON's null; an optional field is left out instead
            raise mistake({"message": "must have a value, got null", "help": "leave it out"})
        return value if value is BROKEN else handler(value)
