"""Compile the C kernel when the package is built; used by pip, not by the package itself."""
