cimport cython
from libc.stdint cimport int64_t

cdef double _ROUNDING_M

@cython.locals(count=Py_ssize_t, widest_m=double)
cdef Py_ssize_t _look(
    const double[:, ::1] q_ned, const double[::1] reach_m, const double[:, ::1] table, const int64_t[::1] order,
    double[:, ::1] spheres, int64_t[:, ::1] spans) noexcept nogil
cdef Py_ssize_t _place(double[:, ::1] spheres, double north, bint beyond) noexcept nogil
cdef Py_ssize_t _choose(
    const double[:, ::1] q_ned, const double[::1] reach_m, const int64_t[::1] order, double[:, ::1] spheres,
    int64_t[:, ::1] spans, int64_t[::1] rows) noexcept nogil
