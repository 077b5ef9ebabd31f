cimport cython
from libc.stdint cimport int16_t, int64_t

cdef (int64_t, int64_t) after(unsigned char* missing, int64_t newest, int64_t number) noexcept nogil
cdef void _count(
    const int64_t[::1] senders, const int64_t[::1] numbers, int64_t[::1] newest, unsigned char[:, ::1] missing,
    int64_t[::1] lost, unsigned char[::1] new) noexcept nogil
@cython.locals(number=int64_t)
cdef Py_ssize_t _go_on(
    int64_t[:, ::1] rows, Py_ssize_t first, int16_t[::1] newest, unsigned char[:, ::1] missing) noexcept nogil
