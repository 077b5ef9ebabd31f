cimport cython
from libc.stdint cimport int64_t

cdef enum:  # rows of the blocks, as columns.py has them
    FLYING = 2
    FRESH = 3
    EMPTY = 5
    P_NED = 0
    P_NOW = 2
    AGE = 0
    WAY = 6

cdef int64_t _MEMORY, _KEPT
cdef double _ROUNDING_S

cdef struct Flown:
    double[3] last  # place at the last tick, NaN where it does not count
    double way_m  # by its reports at the last tick, NaN where it was not in the air
    double length_m  # of the way in the air, NaN before the second tick in a row
    double error_m  # greatest distance from the plan, NaN before the first
    double reported_s  # time of the last place that was held against the plan, NaN before the first

cdef inline Flown* flown_at(double[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <Flown*>&rows[i, 0]

cdef double distance_to_path(
    const double* plan, Py_ssize_t kept, Py_ssize_t oldest, Py_ssize_t count, double n, double e, double d) noexcept nogil
cdef void _measure(
    const unsigned char[:, ::1] flags, const double[:, :, ::1] places, const double[:, ::1] figures,
    const int64_t[::1] rows,
    const double[:, ::1] planned, const int64_t[:, ::1] pairs, double[:, ::1] flown, double[:, :, ::1] plans,
    int64_t[:, ::1] runs, const double[::1] ticks_s, int64_t tick, double[:, ::1] distances_m) noexcept nogil
