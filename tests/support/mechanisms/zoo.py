"""Scenes with one of everything, in the plane and in space."""

SPACE = """
name = "zoo"
gravity = [0, 0, -9.81]
[parameters]
k = { value = 30.0, variability = "tunable" }
a = 1.0
[inputs]
u = { start = 0.3 }
[points]
O = { position = [0, 0, 0], fixed = true }
P = { position = [1, 0, 0], mass = 1.0 }
Q = { position = [2, 0, 1], mass = 0.5 }
[bodies]
beam = { type = "bar", points = ["P", "Q"], mass = 1.0 }
wheel = { position = [3, 0, 0.5], mass = 1.0, inertia = [0.1, 0.2, 0.1] }
nut = { position = [0.5, 1, 2], mass = 0.7, inertia = [0.01, 0.02, 0.015] }
[bodies.rod]
position = [0.5, 1, 0]
center_of_mass = [0.1, 0, 0]
mass = 2.0
inertia = [0.1, 0.2, 0.25]
points = { tip = [0.5, 0, 0], top = [0, 0, 0.2] }
[joints]
lift = { type = "rack", joints = ["thread", "bearing"], radius = 0.05 }
pair = { type = "gear", joints = ["bearing", "thread"], ratio = -2.0 }
roll = { type = "rolling", body = "wheel", radius = 0.5, axis = [0, 1, 0] }
string = { type = "distance", points = ["O", "P"] }
[joints.bearing]
type = "cylindrical"
bodies = ["ground", "rod"]
position = [0, 1, 0]
axis = [0, 0, 1]
[joints.thread]
type = "screw"
bodies = ["ground", "nut"]
position = [0.5, 1, 2]
axis = [0, 0, 1]
pitch = 0.1
[constraints]
path = { value = "Q.x**2 + Q.z*a - 5 + 0.0*t" }
skate = { velocity = "P.vx*Q.y - P.vy" }
[forces]
s1 = { type = "spring", points = ["rod.tip", "P"], stiffness = "k", free_length = 0.1 }
s2 = { type = "spring", points = ["rod.tip", "Q"], energy = "0.5*k*(length - 1)**2 + exp(-length)" }
d1 = { type = "damper", points = ["rod", "Q"], damping = 0.3 }
ts = { type = "torsion_spring", joint = "bearing", stiffness = 3.0, free_angle = 0.2 }
td = { type = "torsion_damper", joint = "bearing", damping = 0.1 }
jt = { type = "joint_torque", joint = "thread", value = "u*sin(t) - 0.1*thread.angular_velocity" }
f1 = { type = "force", point = "rod.top", value = ["u", "0.1*Q.vx", 0], axes = "body" }
f2 = { type = "force", point = "wheel", value = ["u", "0.1*distance(P, Q)", 0] }
m1 = { type = "torque", body = "wheel", value = [0, 0.2, "t"], axes = "body" }
m2 = { type = "torque", body = "wheel", value = [0, 0.2, "0.1*t"] }
m3 = { type = "torque", body = "beam", value = [0, 0.2, "0.1*t"] }
p1 = { type = "potential", value = "0.5*k*P.x**2 + cos(bearing.angle)*a + distance(P, rod.tip)" }
g1 = { type = "gravitation", points = ["P", "Q"], masses = [1.0, 2.0], constant = 0.3 }
[outputs]
o1 = { value = "s2.force + p1.energy + pair.torque + thread.force.z + distance(P, Q)*t*k" }
"""

PLANE = """
name = "zoo"
dimension = 2
gravity = [0, -9.81]
[inputs]
u = { start = 0.3, interpolation = "ramp" }
v = { start = 0.0 }
[points]
O = { position = [0, 0], fixed = true }
P = { position = [1, 0], mass = 1.0 }
Q = { position = [2, 1], mass = 0.5 }
R = { position = [1, -1], mass = 0.5 }
[bodies]
beam = { type = "bar", points = ["P", "Q"], mass = 1.0 }
wheel = { position = [3, 0.5], mass = 1.0, inertia = 0.1, orientation = 1.0 }
slide = { position = [0.5, 2], mass = 1.0, inertia = 0.1 }
[bodies.rod]
position = [0.5, 1]
center_of_mass = [0.1, 0.05]
orientation = 0.3
mass = 2.0
inertia = 0.1
points = { tip = [0.5, 0.1] }
[joints]
bearing = { type = "revolute", bodies = ["ground", "rod"], position = [0, 1] }
guide = { type = "prismatic", bodies = ["rod", "slide"], position = [0.5, 2], axis = [1, 1] }
hinge = { type = "revolute", bodies = ["beam", "slide"], position = [1.5, 1.3] }
lift = { type = "rack", joints = ["bearing", "guide"], radius = 0.05 }
roll = { type = "rolling", body = "wheel", radius = 0.5 }
[forces]
s1 = { type = "spring", points = ["rod.tip", "P"], stiffness = "30 + u", free_length = 0.1 }
ts = { type = "torsion_spring", joint = "hinge", stiffness = 3.0, free_angle = 0.2 }
f1 = { type = "force", point = "rod.tip", value = ["u", "0.1*Q.vx"], axes = "body" }
m1 = { type = "torque", body = "wheel", value = "0.2*t" }
m2 = { type = "torque", body = "beam", value = "0.2*wheel.angle" }
p1 = { type = "potential", value = "15*beam.angle**2 + sin(rod.angle)" }
s2 = { type = "spring", points = ["P", "R"], stiffness = 20, free_length = 0.8 }
[drivers]
hand = { type = "position", point = "R", value = ["1 + 0.1*t**2", "v - 1"] }
[outputs]
o1 = { value = "lift.force + roll.force.x + hand.power" }
"""
