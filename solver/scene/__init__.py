"""What a user writes: scene files, read and checked, with errors like a compiler's."""

from solver.scene.expression import Expr, ExpressionError, Number

__all__ = ["Expr", "ExpressionError", "Number"]
