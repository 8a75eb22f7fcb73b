"""Texts in the place of names: what a named expression means in the syntax tree of another.

    stretch = "A.x - B.x",    "k*stretch**3"    is    k*(A.x - B.x)**3

The tree becomes that of the text written out, with brackets, so that all that follows from it has
the same bits. A long sum is a deep tree: nothing here recurs.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping

from solver.scene.expression import MECHANISM_FUNCTIONS, ExpressionError

LARGEST_TREE = 20_000
"""Nodes put into a tree; an expression of the most operations has fewer."""


class ReportedError(ExpressionError):
    """An expression mentions one with a mistake, which has been reported there."""


def in_one_line(text: str) -> str:
    """Return a text as Python reads one expression."""
    return re.sub(r"\s", " ", text).strip()


def put_texts_for_names(
    tree: ast.Expression, texts: Mapping[str, str], within: dict[ast.expr, tuple[str, ...]]
) -> None:
    """Put the trees of texts in the place of their names, in `tree` itself.

    Each node that is put there has the column of the name, and `within` gets the named expressions
    in which it is, the outermost first.

    Raises
    ------
    RecursionError
        If the tree becomes larger than any expression may be.
    ReportedError
        If `texts` raises it for a name.
    """
    pending: list[ast.AST] = [tree]
    while pending:
        node = pending.pop()
        for field, index, child in list(_operands(node)):
            if isinstance(child, ast.Name) and child.id in texts:
                names = (*within.get(child, ()), child.id)
                put = ast.parse(in_one_line(texts[child.id]), mode="eval").body
                for found in ast.walk(put):
                    if isinstance(found, ast.expr):
                        within[found] = names
                        found.col_offset = child.col_offset
                if len(within) > LARGEST_TREE:
                    raise RecursionError
                if index is None:
                    setattr(node, field, put)
                else:
                    getattr(node, field)[index] = put
                child = put
                if isinstance(put, ast.Name):  # which may be the name of another
                    pending.append(node)
                    continue
            pending.append(child)


def _operands(node: ast.AST) -> Iterator[tuple[str, int | None, ast.expr]]:
    """Yield the operands of a node with their places; no names of parts, nor of functions."""
    if isinstance(node, ast.Attribute):
        return
    of_parts = isinstance(node, ast.Call) and getattr(node.func, "id", "") in MECHANISM_FUNCTIONS
    for field, value in ast.iter_fields(node):
        if isinstance(node, ast.Call) and (field != "args" or of_parts):
            continue
        items = enumerate(value) if isinstance(value, list) else [(None, value)]
        yield from ((field, i, item) for i, item in items if isinstance(item, ast.expr))
