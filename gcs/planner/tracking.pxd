cimport cython
from libc.stdint cimport int64_t

cdef enum:
    KEPT = 32  # places of each leader's way, one a period

cdef double _MOVING_M_S, _LAG_SHARE, _MOST_LAG_S

@cython.locals(
    a=Py_ssize_t, b=Py_ssize_t, first=Py_ssize_t, kept=Py_ssize_t, row=Py_ssize_t, best=double, apart=double,
    moves=bint)
cdef void _measure(
    const int64_t[::1] rows, const double[:, ::1] p, double time_s, double decay, double lag_s,
    const double[:, ::1] times, const double[:, :, ::1] way, const int64_t[::1] count, double[::1] now,
    double[::1] error, double[::1] lag) noexcept nogil
cdef double _apart(const double[:, :, ::1] way, Py_ssize_t row, Py_ssize_t a, Py_ssize_t b) noexcept nogil
