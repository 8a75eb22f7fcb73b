"""A function of the kernel that takes a const context changes nothing that a state keeps."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

KERNEL = Path(__file__).parents[2] / "solver/kernel"
FUNCTION = re.compile(
    r"^[\w ]+?[ *]+(\w+)\([^;{}]*?const context \*(\w+)[^;{}]*?\)\s*\n?\{", re.MULTILINE
)
HANDED_OUT = re.compile(
    r"^static inline double \*(\w+)\(const context \*(\w+)[^{;]*\)\s*\{\s*return ([^;]*);",
    re.MULTILINE,
)
WRITES = r" ?(?:=(?!=)|\+=|-=|\*=|\|=|\+\+|--)"
PLACE = r"(?:\[(?:[^\[\]]|\[[^\]]*\])*\])+"


def functions(text: str) -> Iterator[tuple[str, str, str]]:
    """Yield name, context and body of each function with a const context."""
    for found in FUNCTION.finditer(text):
        line = text[found.end() : text.find("\n", found.end())]
        end = found.end() + len(line) if line.endswith("}") else text.find("\n}", found.end())
        yield found[1], found[2], text[found.end() : end]


@functools.cache
def handing_out() -> str:
    """Names of functions that return a pointer into the state of a const context, as a pattern."""
    found = [
        name
        for path in KERNEL.rglob("*.h")
        for name, context, value in HANDED_OUT.findall(path.read_text("utf-8"))
        if re.search(rf"{context}->(?:s\.|view\.scalars)", value)
    ]
    return "|".join(found)


def writes_the_state(context: str, body: str) -> bool:
    """Tell whether a body assigns to the state, or to what it has a pointer to it for."""
    given = rf"(?:{handing_out()})\({context}"
    parts = rf"(?:{context}->(?:s\.\w+|view\.scalars)|{given})\b"
    pointers = re.findall(rf"(?<!const )double \*(?:const )?(\w+) = {parts}", body)
    places = [rf"(?<![\w.>]){pointer}{PLACE}" for pointer in pointers]
    places += [rf"{context}->(?:s\.\w+|view\.scalars){PLACE}"]
    places += [rf"{given}[^)]*\){PLACE}", rf"\*{given}[^)]*\)"]
    places += [rf"\*{pointer}\b" for pointer in pointers]
    written = [f"{place}{WRITES}" for place in places]
    written += [rf"(?:hm_add|memcpy|memset)\({context}->s\."]
    return any(re.search(x, body) for x in written)


def test_functions_with_a_const_context_leave_the_state_as_it_is():
    liars = [
        f"{path.name}: {name}"
        for path in KERNEL.rglob("*.h")
        for name, context, body in functions(path.read_text("utf-8"))
        if writes_the_state(context, body)
    ]
    assert not liars


@pytest.mark.parametrize(
    "body",
    [
        "double *x = friction_of(c, 0);\n    x[0]++;",
        "double *x = friction_of(c, 0);\n    *x = 1.0;",
        "*friction_of(c, 0) += 1.0;",
        "c->view.scalars[0] = 1.0;",
    ],
)
def test_a_function_that_changes_the_state_is_found(body):
    text = f"void stop(const context *c)\n{{\n    {body}\n}}\n"
    ((name, context, found),) = functions(text)
    assert name == "stop"
    assert writes_the_state(context, found)


def test_a_function_that_reads_the_state_is_no_liar():
    text = "void see(const context *c)\n{\n    const double x = *friction_of(c, 0);\n}\n"
    ((_, context, found),) = functions(text)
    assert not writes_the_state(context, found)
