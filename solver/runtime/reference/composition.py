"""Compositions of pairs of half steps to a higher order (theory 8.1).

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
    4: (3, (4.1241054657117822, 5.793661999832441, -9.9177674655442232)),
    6: (
        4,
        (
            1.8226314151074883,
            -6.4011435573198723,
            -6.2891381706484477,
            -0.8785205100332758,
            -3.0344753042599,
        ),
    ),
    8: (
        6,
        (
            55.91681365966907,
            -38.903798991623916,
            -13.314127312603684,
            29.777317156091367,
            -24.384415134859363,
            2.2906965052155357,
            -1.2771797104762384,
            54.44749195234535,
        ),
    ),
}
"""By order, the difference from a solution of lower order: that order, and the first half of the
weights of the outputs 0 ... s after each stage."""


def embedded(order: int) -> tuple[float, ...]:
    """Return the weights of the outputs 0 ... s.

    Weighted outputs sum to zero up to the lower order, with a unit error of the next one.
    """
    lower, first = EMBEDDED[order]
    return (*first, *(x if lower % 2 else -x for x in reversed(first)))


def stages(order: int) -> tuple[float, ...]:
    """Return the parts of a step, each taken by a pair of half steps."""
    first = FIRST_PARTS[order]
    return (*first, *first[-2::-1])
