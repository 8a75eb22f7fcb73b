"""The order and the pattern of the elimination, against dense algebra on random patterns."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import holonom
from build_kernel.compiler import FLAGS, includes, system_compiler, zig_compiler
from solver import SceneError
from solver.mechanics.elimination import MOST_PRODUCTS, Graph, Pattern, TreeBody, eliminate
from solver.runtime.layout import MOST_IN_GROUP
from tests.support.mechanisms.problems import Array, four_bar, observe, start


@st.composite
def graphs(draw: st.DrawFn) -> Graph:
    """Nodes, rows of one multiplier and coincidences of `dim`, loops and all.

    A row couples one to three nodes and all of their components, a coincidence equal components of
    two; other couplings are of either kind. No node carries more rows than it has coordinates.
    """
    n, dim = draw(st.integers(1, 12)), draw(st.sampled_from([2, 3]))
    nodes = st.lists(st.integers(0, n - 1), min_size=1, max_size=min(3, n), unique=True)
    rows = draw(st.lists(nodes, max_size=2 * n))
    vectors = draw(st.lists(st.booleans(), min_size=len(rows), max_size=len(rows)))
    sizes = [dim] * n + [dim if vector else 1 for vector in vectors]
    couplings = {}
    for near, full in draw(st.lists(st.tuples(nodes, st.booleans()), max_size=n)):
        couplings |= {(a, b): full for a in near for b in near if a < b}
    for k, near in enumerate(rows):
        couplings |= {(a, b): couplings.get((a, b), False) for a in near for b in near if a < b}
        couplings |= {(a, n + k): not vectors[k] for a in near}
    return Graph(
        sizes, n, couplings, {n + k: near for k, near in enumerate(rows)}, [0] * len(sizes)
    )


def first_of(graph: Graph) -> list[int]:
    """First unknown of each block, in the order of the blocks; the last one is their number."""
    return [0, *np.cumsum(graph.sizes).tolist()]


def kkt_matrix(graph: Graph, random: np.random.Generator) -> Array:
    """Random [A, B; C, -eps] with the sparsity of a graph, in the order of its blocks.

    A is positive definite by its diagonal, B and C differ a little, as the gradients at the middle
    and at the end of a step do; -eps is the compliance of a penalty of 1e8.
    """
    first = first_of(graph)
    K = np.zeros((first[-1], first[-1]))
    n = first[graph.n_nodes]
    K[range(n), range(n)] = 4.0 + 2 * len(graph.anchors)
    K[range(n, len(K)), range(n, len(K))] = -1e-2
    for (a, b), full in graph.couplings.items():
        shape = (graph.sizes[a], graph.sizes[b])
        row = b >= graph.n_nodes
        block = random.normal(size=shape) if row else random.uniform(-0.02, 0.02, shape)
        other = block + random.uniform(-0.01, 0.01, shape)
        if not full:
            block, other = (np.diag(np.diag(x)) for x in (block, other))
        rows, columns = slice(first[a], first[a + 1]), slice(first[b], first[b + 1])
        K[rows, columns] += block
        K[columns, rows] += other.T
    return K


def places(graph: Graph, pattern: Pattern) -> list[int]:
    """Place in the elimination of each unknown, in the order of the blocks."""
    blocks = zip(pattern.position, graph.sizes, strict=True)
    return [place + k for place, size in blocks for k in range(size)]


def scatter(K: Array, place: Sequence[int], pattern: Pattern) -> Array:
    """Stored values of K; every entry that is not zero must have its slot."""
    values = np.zeros(pattern.ptr[-1])
    i, j = np.nonzero(K)
    order = np.array(place)
    values[pattern.slots(order[i], order[j])] = K[i, j]
    return values


@pytest.fixture(scope="module", params=[[], ["-DHM_NO_VECTORS"]], ids=["vectors", "no vectors"])
def block_lu(request, tmp_path_factory) -> ctypes.CDLL:
    """Return the kernel's factors in groups, as this machine's compiler makes them, and others."""
    target = tmp_path_factory.mktemp("block_lu") / "block_lu.so"
    compiler = system_compiler() or zig_compiler() or ["cc"]
    root = Path(__file__).resolve().parents[2]
    kernel = root / "solver" / "kernel"
    options = [*FLAGS, "-DDIM=3", "-DHM_SCOPE=2", *includes(kernel), f"-I{kernel / 'linear'}"]
    options = [option for option in options if option != "-fvisibility=hidden"] + request.param
    source = root / "tests" / "support" / "kernel" / "factors_of_groups.c"
    subprocess.run([*compiler, *options, "-o", str(target), str(source)], check=True)
    return ctypes.CDLL(str(target))


@pytest.mark.skipif(not (system_compiler() or zig_compiler()), reason="no C compiler")
@given(graphs(), st.integers(1, MOST_IN_GROUP), st.integers(0, 2**32 - 1))
def test_groups_of_pivots_solve_what_dense_algebra_solves(block_lu, graph, most, seed):
    # Groups of up to `most` pivots, zeros that they store included.
    random = np.random.default_rng(seed)
    pattern = eliminate(graph, most)
    assert np.diff(pattern.groups).max() <= most
    assert not np.any(pattern.later % 2)
    K = kkt_matrix(graph, random)
    right = random.normal(size=len(K))
    solved = solve_in_groups(block_lu, graph, pattern, K, right)
    expected = np.linalg.solve(K, right)
    assert np.linalg.norm(solved - expected) <= 1e-9 * np.linalg.norm(expected)


def solve_in_groups(
    block_lu: ctypes.CDLL, graph: Graph, pattern: Pattern, K: Array, right: Array
) -> Array:
    """Solution by the kernel's factors in groups, in the order of the blocks."""
    place = places(graph, pattern)
    x, values = np.empty_like(right), scatter(K, place, pattern)
    x[place] = right
    columns = pattern.groups[:-1], pattern.later, pattern.parents >= 0
    groups = np.append(np.column_stack(columns).ravel(), pattern.groups[-1])
    island = [0, 0, 0, 0, len(K), len(pattern.groups) - 1, 0, 0]
    tables = pattern.ptr, groups, pattern.columns, pattern.target, island
    kept = [np.ascontiguousarray(table, np.int32) for table in tables]
    pointers = [ctypes.c_void_p(table.ctypes.data) for table in (*kept, values, x)]
    assert block_lu.factor_and_solve(*pointers) == 0
    return x[place]


@st.composite
def tree_joints(draw: st.DrawFn) -> list[tuple[int | None, int]]:
    """Of each body of trees: the one that carries it, or -1 for the ground, or None; directions."""
    count = draw(st.integers(1, 7))
    return [
        (
            draw(st.sampled_from([None, -1, *range(body)])),
            draw(st.integers(0, 3)),
        )
        for body in range(count)
    ]


def cross_matrix(x: Array) -> Array:
    """Matrix of the cross product x times."""
    return np.cross(np.eye(3), x)


def tree_of_bodies(
    joints: Sequence[tuple[int | None, int]], springs: Sequence[tuple[int, int]],
    random: np.random.Generator,
) -> tuple[Graph, Array]:  # fmt: skip
    """Graph of bodies with the joints that carry them, and its matrix in a step.

    Unknowns are turn and place; arms and directions differ in the middle and at the end.
    """
    n = len(joints)
    sizes, trees = [3] * (2 * n), []
    pairs = (0, 0), (0, 1), (1, 1)
    couplings = {(2 * b + i, 2 * b + k): True for b in range(n) for i, k in pairs}
    for body, (parent, directions) in enumerate(joints):
        rows = []
        if parent is not None:
            rows = [len(sizes) + k for k in range(1 + directions)]
            sizes += [3] + [1] * directions
            near = [b for b in (body, parent) if b >= 0]
            couplings |= {(2 * b + k, rows[0]): k == 0 for b in near for k in range(2)}
            couplings |= {(2 * b, row): True for b in near for row in rows[1:]}
        turn = 2 * parent if parent is not None and parent >= 0 else None
        trees.append(TreeBody((2 * body, 2 * body + 1, *rows), turn))
    tied = [*springs, *((b, p) for b, (p, _) in enumerate(joints) if p is not None and p >= 0)]
    couplings |= {tuple(sorted((2 * a + i, 2 * b + k))): True for a, b in tied for i in range(2)
                  for k in range(2) if (a, i) != (b, k)}  # fmt: skip
    first = [0, *np.cumsum(sizes).tolist()]
    K = np.zeros((first[-1], first[-1]))
    for a, b in [*tied, *((b, b) for b in range(n))]:
        for i, k in {(a, b), (b, a)}:
            K[6 * i : 6 * i + 6, 6 * k : 6 * k + 6] += random.uniform(-0.1, 0.1, (6, 6))
    K[range(6 * n), range(6 * n)] += 4.0
    h = 1e-2
    for body, ((parent, directions), carried) in enumerate(zip(joints, trees, strict=True)):
        if parent is None:
            continue
        sign = random.choice([-1.0, 1.0])
        for factor, at in ((h, 0), (1.0, 1)):
            row = first[carried.blocks[2]]
            g = np.eye(3)[:directions] + random.uniform(-0.2, 0.2, (directions, 3))
            for b, s in ((body, sign), (parent, -sign)):
                if b < 0:
                    continue
                rows = np.zeros((3 + directions, 6))
                rows[:3, :3] = -s * cross_matrix(random.normal(size=3))
                rows[:3, 3:] = s * np.eye(3)
                rows[3:, :3] = s * sign * g
                if at:
                    K[row : row + len(rows), 6 * b : 6 * b + 6] = rows
                else:
                    K[6 * b : 6 * b + 6, row : row + len(rows)] = factor * rows.T
    anchors = {r: [t.blocks[0], t.blocks[1]] for t in trees for r in t.blocks[2:]}
    return Graph(sizes, 2 * n, couplings, anchors, [0] * len(sizes), trees=trees), K


@pytest.mark.skipif(not (system_compiler() or zig_compiler()), reason="no C compiler")
@given(tree_joints(), st.data(), st.integers(0, 2**32 - 1))
def test_bodies_with_their_joints_solve_what_dense_algebra_solves(block_lu, joints, data, seed):
    # Balls, universal joints, hinges and welds, to the ground or to other bodies, springs between
    # any of these; their rows have no compliance here.
    body = st.integers(0, len(joints) - 1)
    springs = data.draw(st.lists(st.tuples(body, body), max_size=3))
    graph, K = tree_of_bodies(
        joints, [(a, b) for a, b in springs if a != b], np.random.default_rng(seed)
    )
    pattern = eliminate(graph, MOST_IN_GROUP)
    jointed = [9 + directions for parent, directions in joints if parent is not None]
    assert sorted(x for x in np.diff(pattern.groups) if x > MOST_IN_GROUP) == sorted(jointed)
    right = np.random.default_rng(seed).normal(size=len(K))
    solved = solve_in_groups(block_lu, graph, pattern, K, right)
    expected = np.linalg.solve(K, right)
    assert np.linalg.norm(solved - expected) <= 1e-9 * np.linalg.norm(expected)


@given(graphs())
def test_eliminated_rows_find_coordinates_of_their_own_as_long_as_there_are_any(graph):
    # A row that is carried by coordinates which other rows have used up has no pivot: only rows
    # that no order could carry may come so, and these after all nodes.
    position = eliminate(graph).position
    last_node = max(position[: graph.n_nodes])
    for row in graph.anchors:
        gone = [other for other in graph.anchors if position[other] <= position[row]]
        if position[row] > last_node:
            continue
        multipliers = sum(graph.sizes[other] for other in gone)
        nodes = {a for other in gone for a in graph.anchors[other] if position[a] < position[row]}
        assert multipliers <= sum(graph.sizes[a] for a in nodes)


def test_a_row_waits_for_the_node_that_carries_it():
    # The gradient of an offset with respect to the director is zero where the places coincide.
    couplings = {(0, 2): True, (1, 2): True}
    for anchor in (0, 1):
        position = eliminate(Graph([3, 3, 1], 2, couplings, {2: [anchor]}, [0] * 3)).position
        assert position[2] > position[anchor]


@given(graphs())
def test_the_order_depends_on_the_graph_alone(graph):
    first = eliminate(graph)
    mirrored = dict(reversed(graph.couplings.items()))
    second = eliminate(Graph(graph.sizes, graph.n_nodes, mirrored, graph.anchors, graph.islands))
    assert first.position.tolist() == second.position.tolist()
    assert first.target.tolist() == second.target.tolist()


def test_dependent_rows_and_singular_places_are_passed():
    # The same distance three times, and all bars in one line: no dense solve would do.
    content = four_bar(2)
    for i in range(3):
        content["points"][f"B{i}"] = {"position": [i + 1.0, 0.0], "velocity": [0.0, 2.0]}
    ends = {"type": "distance", "points": ["B0", "B1"]}
    content["joints"] = {"one": ends, "two": dict(ends), "three": dict(ends)}
    names = ["energy.error", "constraint.position", "one.force", "two.force", "three.force"]
    values = observe(start(content, h=0.005), 0.005, 400, names)
    assert values[:, :2].max() < 1e-12
    # Which of equal rows carries how much is not determined; the penalty shares it out evenly.
    for other in (3, 4):
        assert values[:, other] == pytest.approx(values[:, 2], rel=1e-6, abs=1e-6)


def bars(n_points: int, pairs: Sequence[tuple[int, int]]) -> str:
    """Scene of mass points on a circle, held by rigid bars between some of them."""
    angles = 2 * np.pi * np.arange(n_points) / n_points
    points = (
        f"P{k} = {{ position = [{np.cos(a):.3f}, {np.sin(a):.3f}], mass = 1 }}\n"
        for k, a in enumerate(angles)
    )
    joints = (
        f'd{k} = {{ type = "distance", points = ["P{a}", "P{b}"] }}\n'
        for k, (a, b) in enumerate(pairs)
    )
    return "".join(['name = "bars"\ndimension = 2\n[points]\n', *points, "[joints]\n", *joints])


@pytest.mark.parametrize(
    "scene",
    [
        bars(2, [(0, 1)] * 1500),
        bars(60, [(a, b) for a in range(60) for b in range(a)]),
    ],
    ids=["equal bars", "every point to every other"],
)
def test_constraints_that_need_too_many_products_are_refused(scene):
    with pytest.raises(
        SceneError, match=r"\d+ moving coordinates are coupled too densely, .* repeat others"
    ):
        holonom.assemble(holonom.loads(scene))


def test_redundant_bars_within_the_limit_are_assembled():
    model = holonom.assemble(holonom.loads(bars(20, [(a, b) for a in range(20) for b in range(a)])))
    assert model.sizes["n_rows"] == 190
    assert len(model.tables["lu_target"]) <= MOST_PRODUCTS


def test_a_square_net_of_springs_is_below_the_limit_of_products():
    size = 35
    points = [
        f"P{i}x{k} = {{ position = [{i}, {k}], mass = 1 }}\n"
        for i in range(size)
        for k in range(size)
    ]
    springs = [
        f's{i}x{k}{i + a}x{k + b} = {{ type = "spring", points = ["P{i}x{k}", "P{i + a}x{k + b}"], '
        "stiffness = 1 }\n"
        for i in range(size - 1)
        for k in range(size - 1)
        for a, b in ((1, 0), (0, 1), (1, 1))
    ]
    text = "".join(['name = "net"\ndimension = 2\n[points]\n', *points, "[forces]\n", *springs])
    assert holonom.assemble(holonom.loads(text)).sizes["n_free"] == size**2
