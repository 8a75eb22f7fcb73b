"""Words of other programs and of everyday speech, and what a scene calls the same.

Each place of a file, a table or the fields of any part, has its words; a word has names, of which
the first that is known there is suggested, or a sentence.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches

_MOST = 300
"""Names that are listed: of more, as variables of large mechanisms are, their number."""
_MANY = 300
"""Names that are compared with a wrong one; of more only those that begin like it."""

_WORDS = {
    "file": """
        bodies: links rods bars beams masses frames
        points: nodes markers supports anchors
        joints: hinges connections couplings pins
        forces: springs dampers loads torques moments elements potentials
        drivers: actuators motions drives
        contacts: collisions impacts obstacles
        parameters: variables constants params
        inputs: signals
        states: memories controllers blocks
        expressions: formulas definitions terms
        profiles: tables curves splines characteristics lookups
        sensors: instruments probes
        outputs: results measurements measures
        experiment: simulation run
        solver: settings integrator
        looks: visuals appearance
        view: camera
        """,
    "states": """
        sampled: discrete state
        pid: controller pi pd
        """,
    "bodies": """
        rigid: body solid
        bar: rod link beam
        """,
    "joints": """
        revolute: hinge pin rotational pivot
        prismatic: slider translational slide
        spherical: ball ball_joint ball_socket
        fixed: weld lock rigid
        distance: rod link bar massless_rod
        universal: cardan hooke
        """,
    "forces": """
        torsion_spring: torsional_spring rotational_spring angular_spring
        torsion_damper: torsional_damper rotational_damper angular_damper
        damper: dashpot
        torque: moment
        force: load
        """,
    "drivers": """
        angle: rotation rotational revolute turn
        displacement: translation translational linear prismatic slide
        position: motion path trajectory
        """,
    "sensors": """
        imu: accelerometer gyro gyroscope inertial
        relative: distance difference gap frame
        """,
    "contacts": """
        plane: floor ground wall line halfspace half_space
        corners: vertices feet
        capsule: segment stick pill rods
        polygon: hull polygons
        convex: polyhedron polyhedra convex_hull convex_mesh
        box: block cube cuboid rectangle boxes
        cylinder: coin drum rim barrel
        sphere: ball balls disc discs circle
        clearance: play backlash
        journal: journal_bearing bearing sleeve bush bushing
        stop: limit end_stop endstop rope bound
        profile: road rail track curve
        cam: lobe
        height_field: terrain heightfield heightmap height_map grid
        superquadric: superellipsoid
        ellipsoid: ellipse egg
        mesh: stl obj trimesh triangles
        """,
    "looks": """
        box: block cube cuboid
        cylinder: disc rod drum
        sphere: ball
        wheel: tyre tire
        tube: pipe ring
        """,
    "fields": """
        opacity: alpha transparency
        colour: color
        stiffness: k spring_constant spring_rate rate
        damping: c d damping_coefficient viscosity
        free_length: l0 rest_length natural_length length length0 l
        free_angle: phi0 rest_angle
        mass: m weight
        inertia: j i moment_of_inertia inertia_tensor
        center_of_mass: com cg cog center_of_gravity centre_of_mass centre_of_gravity
        position at: pos location origin place coordinates xyz
        orientation free_angle value: axes angle rotation rot attitude euler
        velocity: vel v
        angular_velocity: omega w spin angular_speed
        bodies: body1 body2 parent child
        points: from to point1 point2 ends nodes
        axis value: direction normal
        pitch: lead
        ratio: gear_ratio teeth
        radius: diameter r clearance play
        density: rho
        value energy: torque moment force magnitude formula function law expression
        value start: default initial initial_value
        fixed: ground is_fixed
        description: text comment
        min: minimum lower low
        max: maximum upper high
        restitution: e cor bounce elasticity coefficient_of_restitution
        friction coefficient: mu friction_coefficient kinetic_friction sliding_friction mu_k
        static_friction static: mu_s mu_static stiction
        surface_velocity: belt_speed belt_velocity surface_speed
        """,
}
_NOT_A_WORD = {
    ("motor", "motors", "servo"): (
        'a motor is a motion in [drivers], such as type = "angle" with value = "2*t", or one with '
        'limits in [forces], type = "actuator"'
    ),
    ("friction",): (
        "friction is a field of contacts, friction = 0.3, and of revolute, prismatic, spherical "
        "and cylindrical joints, friction = { coefficient = 0.1, radius = 0.01 }; what grows with "
        'the speed stands in [forces]: type = "torsion_damper" or "damper"'
    ),
    ("limit", "limits", "end_stop", "file.stops", "joints.stop", "forces.stop"): (
        'write an end stop in [contacts]: type = "stop" with joint = "..." and min, max, or with '
        "points = [...] and max for a rope"
    ),
    ("velocity", "velocities", "speed", "initial", "initial_velocity"): (
        "a velocity at the start is a field of points and rigid bodies: velocity, angular_velocity"
    ),
    ("drivers.velocity", "drivers.speed", "drivers.angular_velocity"): (
        'write the motion that it makes: type = "angle" or "displacement" with value = "2*t"'
    ),
    ("joints.contact", "forces.contact", "drivers.contact", "fields.contact"): (
        'write a contact in [contacts]: type = "plane", "corners", "sphere", "clearance", '
        '"journal", "stop", "profile", "cam", "surface", "height_field", "superquadric", '
        '"mesh", "convex", "capsule", "polygon", "box", "cylinder" or "ellipsoid"'
    ),
}
"""What is written instead of a word that is none of a scene, wherever it stands."""


def _read(text: str) -> dict[str, list[str]]:
    """Names of each word; a line has names and, behind the colon, the words that mean them."""
    lines = (line.partition(":") for line in text.strip().splitlines())
    return {word: names.split() for names, _, words in lines for word in words.split()}


NAMES = {place: _read(text) for place, text in _WORDS.items()}
SENTENCES = {word: sentence for words, sentence in _NOT_A_WORD.items() for word in words}


def a(kind: str) -> str:
    """Put the article in front of a kind of part."""
    return f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}"


def nearest(wrong: str, known: Iterable[str], place: str = "") -> str | None:
    """Return the known name that was perhaps meant by a word at a place, if there is one."""
    low, folded = wrong.lower(), {name.lower(): name for name in known}
    close = [name for name in NAMES.get(place, {}).get(low, ()) if name in folded]
    if not close and _sentence(low, place):
        return None
    close += [name for name in _other_numbers(low) if name in folded]
    alike = [name for name in folded if name[:2] == low[:2]]
    few = folded if len(folded) <= _MANY else alike[:_MANY]
    close += get_close_matches(low, few, 1, 0.65)
    close += [name for name in alike if len(name) > 2 and low.startswith(name)]
    close += [name for name in alike if len(low) > 2 and name.startswith(low)]
    return folded[close[0]] if close else None


def did_you_mean(
    wrong: str, known: Iterable[str], title: str = "known", place: str = ""
) -> str | None:
    """Suggest the known name that was perhaps meant, say what is written instead, or list them."""
    names = list(known)
    near = nearest(wrong, names, place)
    if near:
        return f"did you mean '{near}'?"
    if sentence := _sentence(wrong, place):
        return sentence
    return f"{title}: {listed(names)}" if names else None


def listed(names: Sequence[str]) -> str:
    """All names in one line; of very many the first, and how many more there are."""
    more = len(names) - _MOST
    return ", ".join(names[:_MOST]) + (f" and {more} more" if more > 0 else "")


def _sentence(word: str, place: str) -> str | None:
    """What is written at a place instead of a word that no scene has."""
    word = word.lower()
    return SENTENCES.get(f"{place}.{word}") or SENTENCES.get(word) if place else None


def _other_numbers(word: str) -> list[str]:
    """Plurals and singulars of a word."""
    plural = f"{word[:-1]}ies" if word.endswith("y") else f"{word}s"
    singular = f"{word[:-3]}y" if word.endswith("ies") else word.removesuffix("s")
    return [plural, singular]
