"""A model whose directors are not those of one body after the other is refused before it is run."""

from __future__ import annotations

from array import array
from collections.abc import Iterator

import pytest

import solver
from solver.runtime.errors import OptionError
from solver.runtime.kernel import shared_library
from tests.support.fmus.fmu_instance import SCENES


def damaged(name: str, table: dict[str, array]) -> Iterator[dict[str, array]]:
    """Tables in which a director has another kind, or a body the director of another one."""
    kinds, bodies = table["node_kind"], table["body_node"]
    turning = {"slider_crank": 1, "bricard": 3}[name]
    for b, first in enumerate(bodies):
        for other in {*bodies} - {first}:
            changed = array("i", bodies)
            changed[b] = other
            yield {"body_node": changed}
        for node in range(first - 1, first + turning):
            for kind in {0, 1, 2, 3, 4, -1} - {kinds[node]}:
                changed = array("i", kinds)
                changed[node] = kind
                yield {"node_kind": changed}


@pytest.mark.parametrize("name", ["slider_crank", "bricard"])
def test_directors_that_are_not_those_of_one_body_after_the_other_are_refused(name):
    model = solver.assemble(solver.load(SCENES / f"{name}.toml"))
    library, count = shared_library(model.sizes["dim"]), 0
    for tables in damaged(name, model.tables):
        broken = model._replace(tables={**model.tables, **tables})
        with pytest.raises(OptionError, match="an index leads beyond"):
            broken.checked_file(library)
        count += 1
    assert count > 10
