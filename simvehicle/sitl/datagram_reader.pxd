cimport cython

cpdef enum:
    LOOK_NS = 500_000

cdef enum:
    # After so long without the processor that was left to others, sleep is better: to be woken gives it back at once.
    CROWDED_NS = 1_300_000
    # So many waits are slept through then; twice as many as the last time, up to a most, where fewer waits than those
    # of the last number were looked through in between.
    SLEEPS = 50
    MOST_SLEEPS = 3200
    UNDISTURBED = 200

cdef class DatagramReader:
    cdef int _fd
    cdef bytearray _room
    cdef char* _buffer
    cdef Py_ssize_t _size
    cdef public long long last_ns
    cdef public long long sleeps_left
    cdef long long _slept  # how many were to be
    cdef long long _looked  # how many were looked through since

    cpdef bytes receive(self)
    cdef Py_ssize_t _wait(self) noexcept nogil
    @cython.locals(again=cython.bint)
    cdef void _go_on_with_sleep(self) noexcept nogil

cdef long long _now_ns() noexcept nogil
