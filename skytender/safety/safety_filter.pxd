cimport cython

cdef int _SIZE
cdef double _LEAST

cdef bint _sound(
    const double[:, ::1] p, const double[:, ::1] v, const double[:, ::1] wanted, const double[::1] v_max,
    const double[::1] a_max, const double[::1] margin, const double[::1] spread, const double[:, ::1] moving, const double[:, ::1] table,
    const double[:, ::1] walls) noexcept nogil
cdef bint _finite(const double* numbers, Py_ssize_t count) noexcept nogil
