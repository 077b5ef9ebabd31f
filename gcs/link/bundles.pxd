cimport cython
from libc.stdint cimport int64_t

cpdef enum:
    SHARED_BYTES = 4096
    NO_SOCKET = -1

cdef struct Receiver:
    int64_t[2] address  # a struct sockaddr_in: all of the address is in the first
    int64_t shared  # whether others speak from there too

cdef inline Receiver* receiver_at(int64_t[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <Receiver*>&rows[i, 0]

@cython.locals(k=Py_ssize_t)
cdef void _send_all(
    int fd, const unsigned char[::1] out, const int64_t[:, ::1] cuts, int64_t[:, ::1] to) noexcept nogil
cpdef (int64_t, int64_t, int64_t) _bundle(
    unsigned char[::1] out, int64_t[:, ::1] rows, const unsigned char[:, ::1] markers, const double[:, ::1] values,
    unsigned char[:, ::1] templates, int64_t[:, ::1] sizes, int64_t[:, ::1] cuts, int64_t[:, ::1] spans,
    int64_t point_ms, int64_t unix_us, int64_t grant_ms, int fd, int64_t[:, ::1] to) noexcept nogil
