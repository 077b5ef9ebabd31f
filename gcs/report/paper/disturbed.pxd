from libc.stdint cimport int64_t

cpdef void noisy(
    double[::1] v, const double[::1] tau, const double[:, ::1] noise, double p, double rate, double step_s,
    Py_ssize_t counted_from, double[::1] total, double[::1] squares) noexcept nogil
cdef void _step_delayed(
    double[::1] v, const double[::1] tau, const int64_t[::1] delays, double[:, ::1] past, double[::1] norms, double p,
    double rate, double step_s, Py_ssize_t steps) noexcept nogil
