cimport cython

cdef bint _is_digit(unsigned char letter) noexcept nogil
cdef Py_ssize_t _put(const unsigned char* text, Py_ssize_t size, unsigned char* out, Py_ssize_t at) noexcept nogil
@cython.locals(small=cython.bint)
cdef (Py_ssize_t, Py_ssize_t) _put_number(
    const unsigned char* text, Py_ssize_t begin, unsigned char* out, Py_ssize_t at) noexcept nogil
cdef (Py_ssize_t, Py_ssize_t) _put_three(
    const unsigned char* text, Py_ssize_t begin, unsigned char* out, Py_ssize_t at) noexcept nogil
cdef Py_ssize_t _lay_out(
    const unsigned char* numbers, const unsigned char* sysids, const unsigned char* time, Py_ssize_t time_size,
    unsigned char[::1] out, Py_ssize_t[:, ::1] spans) noexcept nogil
