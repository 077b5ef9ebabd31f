cimport cython
from simvehicle.mavlink.connection cimport Connection
from simvehicle.mavlink.lockstep cimport Bundle, Grants
from simvehicle.sitl.unit cimport Unit

cdef long long LOOK_NS, CROWDED_NS, LEAST_SLEEPS, MOST_SLEEPS

cdef class Granted:
    cdef Unit _unit
    cdef readonly Connection connection
    cdef list _plain
    cdef Grants _grants
    cdef bytes _hello
    cdef double _patience_s
    cdef double _last_received_s
    cdef bint _started
    cdef long long _time_ms

    cdef receive(self, list frames, double now_s, list answers)
    cdef _apply(self, Bundle bundle)

cdef class GrantReader:
    cdef readonly long long last_ns
    cdef readonly long long sleeps_left
    cdef int _fd
    cdef bytearray _room
    cdef Py_ssize_t _most
    cdef long long _sleeps

    @cython.locals(into=cython.p_char, have=cython.Py_ssize_t)
    cpdef bytes receive(self)
    cdef Py_ssize_t _wait(self, char* into) noexcept nogil

@cython.locals(one=Granted, reader=GrantReader, granted=dict, answers=list, shared=cython.bint)
cpdef run_supervised(object seats, object link, object secret=?, object clock=?)
cdef _send(int fd, list datagrams)
cdef long long _now_ns() noexcept nogil
