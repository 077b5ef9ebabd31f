cdef Py_ssize_t _put(
    long long t_us, const unsigned char* raw, const Py_ssize_t[:, ::1] spans,
    unsigned char* out, Py_ssize_t at) noexcept nogil
cdef Py_ssize_t _stamp(
    long long t_us, const unsigned char* first, const Py_ssize_t[:, ::1] first_spans,
    const unsigned char* last, const Py_ssize_t[:, ::1] last_spans, unsigned char[::1] stamped) noexcept nogil
