cimport cython

cdef enum:  # what the history (3, window, n) keeps of the start of a step, at step % window
    STATE
    DRIFT
    NOISE

@cython.locals(past=cython.double, at=cython.double, left=cython.Py_ssize_t)
cdef void _drift(
    const double[::1] v, const double[:, :, ::1] drive, Py_ssize_t m, double part, Py_ssize_t step,
    const double[:, :, ::1] history, const double[::1] initial, const double[::1] delays, double p, double rate,
    double[::1] slope) noexcept nogil
@cython.locals(beside=cython.bint)
cdef Py_ssize_t _step_block(
    double[::1] v, double[:, :, ::1] history, const double[::1] initial, const double[:, :, ::1] drive,
    const double[:, ::1] noise, const double[::1] delays, const double[::1] wanted, double[:, ::1] out,
    Py_ssize_t first, Py_ssize_t following, double step_s, double p, double rate, double[::1] k1, double[::1] k2,
    double[::1] k3, double[::1] k4, double[::1] stage) noexcept nogil
