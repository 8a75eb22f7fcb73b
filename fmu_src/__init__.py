"""What makes a mechanism an FMU: the slave that pythonfmu's library calls.

Everything here travels in the archive, beside `solver.runtime`, under a private package name; it
needs the standard library, pythonfmu's `Fmi2Slave` and `solver.runtime` alone.
"""
