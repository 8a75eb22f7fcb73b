"""What makes a mechanism an FMU: the slave that pythonfmu's library calls.

Everything here travels in the archive, beside the library of the FMU, under a private package
name; it needs the standard library alone.
"""
