cimport cython

cdef int _IN, _OUT, _DECISION

cdef Py_ssize_t _put_prefix(long long t_ms, int part, unsigned char* out, Py_ssize_t at) noexcept nogil
@cython.locals(size=Py_ssize_t)
cdef Py_ssize_t _put_frames(
    long long t_ms, int part, const unsigned char* raw, const Py_ssize_t[:, ::1] spans,
    unsigned char* out, Py_ssize_t at) noexcept nogil
@cython.locals(at=Py_ssize_t, size=Py_ssize_t)
cdef Py_ssize_t _count(
    long long t_ms, const unsigned char* received, const Py_ssize_t[:, ::1] received_spans,
    const unsigned char* sent, const Py_ssize_t[:, ::1] sent_spans,
    const unsigned char* lines, const Py_ssize_t[:, ::1] lines_spans, unsigned char[::1] counted) noexcept nogil
