"""The time step in NumPy, written from the equations: the oracle of the compiled kernel's tests.

    M (v_n1 - v_n) + h [ G_bar' mu - Q ] = 0,   (v_n + v_n1)/2 = (q_n1 - q_n)/h,
    mu = lam + alpha C(q_n, q_n1)

after García Orden & Ortega, "A conservative augmented Lagrangian algorithm for the dynamics of
constrained mechanical systems". G_bar is the discrete gradient of the rows, G(q_mid) for quadratic
ones. Dense matrices, symbols of the paper, no thought of speed: some
hundred times slower than the kernel, for which it stands in where there is none. Both solve the
same equations to round-off; the numbers of Newton iterations may differ.

The only part of `solver.runtime` that imports NumPy.
"""

from .engine import Reference

__all__ = ["Reference"]
