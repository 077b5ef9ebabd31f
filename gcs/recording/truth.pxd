cdef Py_ssize_t _find(const double[::1] numbers, Py_ssize_t width, Py_ssize_t[::1] places) noexcept nogil
