cimport cython
from simvehicle.mavlink.connection cimport Connection
from simvehicle.mavlink.lockstep cimport Bundle, Grants
from simvehicle.sitl.unit cimport Unit

cdef class Granted:
    cdef Unit _unit
    cdef readonly Connection connection
    cdef list _plain
    cdef Grants _grants
    cdef bytes _hello
    cdef double _patience_s
    cdef double _last_received_s
    cdef bint _started

    cdef receive(self, list frames, double now_s, list answers)
    cdef _apply(self, Bundle bundle)

@cython.locals(one=Granted, granted=dict, answers=list, shared=cython.bint)
cpdef run_supervised(object seats, object link, object secret=?, object clock=?)
cdef _send(int fd, list datagrams)
