from libc.stdint cimport int64_t

cdef Py_ssize_t _extremes(
    const int64_t[::1] bucket, const double[::1] values, int64_t[::1] places) noexcept nogil
cdef void _spread(
    const int64_t[::1] bucket, const double[::1] values, double[::1] least, double[::1] greatest, double[:, ::1] sums,
    double[::1] means) noexcept nogil
