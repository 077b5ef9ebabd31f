cimport cython
from libc.stdint cimport int64_t

from gcs.mavlink.frame_runs cimport Awaited, Found, Run
from skytender.system_calls cimport socklen_t

cpdef enum:
    NOTHING
    ENOUGH
    UNKNOWN
    FULL
    LOST

cpdef enum:
    ALONE
    SHARED_BY

cdef enum:
    _ADDRESS_BYTES = 16  # of a struct sockaddr_in

cdef struct Datagram:
    int64_t begin
    int64_t end
    int64_t address  # its number

cdef class Inbox:
    cdef Py_ssize_t _most_bytes, _room_bytes, _unknown_bytes
    cdef unsigned char[::1] _data
    cdef int64_t[::1] _begins
    cdef int64_t[:, ::1] _rows
    cdef int64_t[:, ::1] _bounds
    cdef int64_t[:, ::1] _origins
    cdef int64_t[::1] _sender  # a struct sockaddr_in: all of the address is in the first
    cdef object _order
    cdef int64_t[::1] _order_row

    # of what the buffer holds: frames and runs; bytes and datagrams, how many of these were looked into, and where
    # looking has stopped
    cdef Found _found
    cdef Py_ssize_t _used, _count, _looked, _stopped_at
    # answers, and how many there were before the last call
    cdef readonly Py_ssize_t answers
    cdef Py_ssize_t _before
    # of the last call: datagrams received; the place and length of the one that it ended with
    cdef readonly Py_ssize_t taken
    cdef Py_ssize_t _stray_at, _stray_bytes

    cdef void _forget(self) noexcept nogil
    cdef int64_t _number(self, Py_ssize_t* known) noexcept nogil
    @cython.locals(known=Py_ssize_t, origin_bytes=socklen_t)
    cdef int _receive(self, int fd, Py_ssize_t most, Py_ssize_t left, Py_ssize_t yields, bint lost) noexcept nogil
    cdef void _look(self, const int64_t[::1] row_by_sysid, int64_t[:, ::1] awaited) noexcept nogil
    cdef bint _is_answer(self, const Run* run, const Awaited* one, int64_t address) noexcept nogil
    @cython.locals(count=Py_ssize_t, frames=Py_ssize_t)
    cdef Found _cut(self, int64_t[:, ::1] awaited, int64_t[:, ::1] rows, int64_t[:, ::1] spans) noexcept nogil
    cdef bytes _bytes(self, Py_ssize_t begin, Py_ssize_t end)
    cdef Datagram* _datagram(self, Py_ssize_t k) noexcept nogil
