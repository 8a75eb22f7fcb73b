"""A scene of a few lines, with a bit of everything that the reader meets."""

SHORT = """
name = "short"
dimension = 2
[parameters]
length = 1.0
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["length", 0], mass = 2 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[inputs]
push = { unit = "N" }
"""
