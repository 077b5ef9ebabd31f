cimport cython

cdef class Signing:
    cdef readonly long long latest
    cdef readonly dict streams
    cdef object _hash
    cdef Py_ssize_t _most_streams

    @cython.locals(body_end=Py_ssize_t, stamp="long long", stamped=bytes, to="unsigned char*", crc="unsigned int", k=int)
    cpdef bytes sign(self, bytes raw, bytes seed, int link_id, long long now_ticks)
    @cython.locals(size=Py_ssize_t, hash_at=Py_ssize_t, stamp="long long", k=int)
    cpdef object judge(self, bytes raw, unsigned int msgid, long long now_ticks)
    cdef bytes _signature(self, bytes stamped)
