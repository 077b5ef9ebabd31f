cimport cython
from libc.stdint cimport int64_t

from gcs.telemetry.approach cimport Pair

cdef double _ROUNDING_S

@cython.locals(began=cython.bint, ceased=cython.bint, least=Pair)
cdef void _fill(
    const double[:, :, ::1] at, const double[::1] t_s, const double[:, ::1] partners, double[::1] separation,
    int64_t[:, ::1] pair, double[:, ::1] here, double[:, ::1] before, int64_t[::1] rows, int64_t[::1] place,
    int64_t[:, ::1] close, const double[:, ::1] straight, double[:, ::1] found,
    const unsigned char[::1] ours) noexcept nogil
cpdef void fill_errors(
    const double[::1] t_s, const double[:, ::1] plan, const double[::1] reported_s, const double[:, ::1] at,
    double period_s, double pause_s, Py_ssize_t memory, double[::1] found) noexcept nogil
