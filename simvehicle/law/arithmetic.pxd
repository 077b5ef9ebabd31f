# Small functions of the law that become part of each function that calls them.

from libc.math cimport M_PI

cdef inline double bounded(double x, double limit) noexcept nogil:
    """x within ±limit."""
    return min(max(x, -limit), limit)
