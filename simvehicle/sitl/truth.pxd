cimport cython
from simvehicle.autopilot.vehicle cimport Vehicle

cpdef enum:
    FIXED_NUMBERS = 18  # of a record, before its thrust
    MOTION = 12

cdef class TruthWriter:
    cdef readonly int number
    cdef Vehicle _vehicle
    cdef object _file
    cdef int _fd
    cdef bytearray _room
    cdef object _path
    cdef bytes _head
    cdef double _period_s
    cdef double _due_s
    cdef long long _written
    cdef long long _begun_ms
    cdef long long _begun_at

    cpdef write(self)
    cdef _put(self, const char* content, Py_ssize_t size)
