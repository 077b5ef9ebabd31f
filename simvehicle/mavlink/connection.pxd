cimport cython
from simvehicle.autopilot.vehicle cimport Vehicle
from simvehicle.mavlink.streams cimport StreamSchedule

cpdef enum:
    DATAGRAM_BYTES = 1400

cdef packed struct Waiting:  # before a payload that waits
    unsigned int msgid
    unsigned char seed

cdef class Connection:
    cdef readonly unsigned int sysid
    cdef readonly unsigned int compid
    cdef readonly StreamSchedule streams
    cdef public unsigned int seq
    cdef list _queue

    cpdef put(self, object content)
    cdef _queue_payload(self, unsigned int msgid, unsigned int seed, const unsigned char* payload, Py_ssize_t size)
    cpdef put_due(self, Vehicle vehicle)
    cpdef list frames(self, Py_ssize_t most=?)
    cdef bytes number(self, unsigned int msgid, unsigned int seed, const unsigned char* payload, Py_ssize_t size)

@cython.locals(first=Py_ssize_t, size=Py_ssize_t)
cpdef list pack(list frames)
@cython.locals(size=Py_ssize_t)
cdef Py_ssize_t size_of(list parts, Py_ssize_t first, Py_ssize_t end) except -1
cdef bytes together(list parts, Py_ssize_t first, Py_ssize_t end)
