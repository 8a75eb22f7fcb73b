"""Compositions of pairs of half steps to a higher order (numerics 8).

A symmetric composition of a symmetric step that is near the identity as h goes to 0 has the order
for which its parts are made. The plain step is not: it reflects the velocity normal to the
constraints. The pair is, and each stage conserves by itself, whatever the sign of its step.
"""

from __future__ import annotations

FIRST_PARTS = {
    2: (1.0,),
    4: (0.41449077179437573714, 0.41449077179437573714, -0.65796308717750294857),
    6: (
        0.39216144400731413928,
        0.33259913678935943860,
        -0.70624617255763935981,
        0.082213596293550800230,
        0.79854399093482996340,
    ),
    8: (
        0.74167036435061295344822780,
        -0.40910082580003159399730010,
        0.19075471029623837995387626,
        -0.57386247111608226665638773,
        0.29906418130365592384446354,
        0.33462491824529818378495798,
        0.31529309239676659663205666,
        -0.79688793935291635401978882,
    ),
}
"""Parts of a step up to the middle one: of order 4 by Suzuki 1990, of order 6 by Kahan and Li 1997
(s9odr6a), of order 8 the 15 stages of Suzuki and Umeno 1993."""


EMBEDDED = {
    4: (
        (3, (4.1241054657117822, 5.793661999832441, -9.9177674655442232)),
        (2, (1.3408927628104155, 1.9364790969793597, 2.5412769522090053)),
    ),
    6: (
        (
            4,
            (
                1.8226314151074883,
                -6.4011435573198723,
                -6.2891381706484477,
                -0.8785205100332758,
                -3.0344753042599,
            ),
        ),
        (
            2,
            (
                1.3924516780664877,
                0.79248065939298917,
                0.16758936267750835,
                -0.74285115760501119,
                -0.96762658458308271,
            ),
        ),
    ),
    8: (
        (
            5,
            (
                15.141411217507283,
                -12.263374322255949,
                6.9527437214117782,
                8.5169471212453516,
                -10.225761221162973,
                -9.0240383596451892,
                -1.7001504698145284,
                2.6022223127142272,
            ),
        ),
        (
            3,
            (
                0.13199986272792208,
                1.6107381537523564,
                -0.84908552473929788,
                0.022347701637577013,
                -0.85249375052665732,
                -1.1474567476428574,
                -0.3660281753229786,
                1.4499784801139359,
            ),
        ),
    ),
}
"""By order, two differences from solutions of lower order: that order, and the first half of the
weights of the outputs 0 ... s after each stage."""


def embedded(order: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the weights of the outputs 0 ... s for both differences.

    Weighted outputs sum to zero up to the lower order, with a unit error of the next one.
    """
    high, low = (
        (*first, *(x if lower % 2 else -x for x in reversed(first)))
        for lower, first in EMBEDDED[order]
    )
    return high, low


def stages(order: int) -> tuple[float, ...]:
    """Return the parts of a step, each taken by a pair of half steps."""
    first = FIRST_PARTS[order]
    return (*first, *first[-2::-1])
