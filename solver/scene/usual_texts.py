"""Descriptions of fields that mean the same in all parts, for editors."""

USUAL_TEXTS = {
    "name": "of the mechanism and its FMU",
    "description": "one sentence",
    "dimension": "2 or 3: every vector has as many numbers",
    "type": "which kind of part it is",
    "unit": "of SI; describes the number and converts nothing",
    "display_unit": "in which tools show it, such as mm or deg; numbers stay in SI",
    "variability": "tunable: may change during a run",
    "interpolation": "between communication points: hold, ramp to the next value, or move smoothly",
    "limit": "beyond min and max: an error, or clip to the limit",
    "x": "first coordinates of the given points, increasing",
    "y": "second coordinates of the given points",
    "periodic": "whether it repeats; its period is the distance of its ends",
    "integrate": "whether the function is the integral of the curve, from the first x on",
    "fixed": "whether it is held in its place",
    "point": "name of a point, or of a point of a body such as arm.tip",
    "points": "names of two points, or of points of bodies such as arm.tip",
    "body": "name of a body",
    "bodies": "names of two bodies; one may be ground",
    "joint": "name of a joint",
    "joints": "names of two joints",
    "profile": "name of a profile",
    "axes": "an axis of each body",
    "law": "rigid, or how the force grows with the penetration",
    "side": "on which side of the surface it stays",
}
"""Descriptions of fields whose kind has none, by their names."""
