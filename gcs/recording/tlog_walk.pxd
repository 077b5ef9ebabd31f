cimport cython
from skytender.intact_frames cimport Intact

cdef Py_ssize_t _NO_STAMP

@cython.locals(octets="const unsigned char*", signature=Py_ssize_t)
cpdef bytes raw_at(bytes data, Py_ssize_t at)
@cython.locals(at=Py_ssize_t)
cpdef list raws_at(bytes data, list places)
@cython.locals(at=Py_ssize_t, begin=Py_ssize_t, size=Py_ssize_t)
cdef void _gather(
    const unsigned char[::1] data, const Py_ssize_t[:, ::1] heads, unsigned char[:, ::1] rows,
    Py_ssize_t head_bytes) noexcept nogil
@cython.locals(data="const unsigned char[::1]", rows="Py_ssize_t[:, ::1]")
cpdef walk(octets, heads, Py_ssize_t last_end, Py_ssize_t look_at, bint final)
@cython.locals(
    n=Py_ssize_t, gaps=Py_ssize_t, skipped=Py_ssize_t, intact=Intact, next_at=Py_ssize_t, numbers=Py_ssize_t,
    stamp_bytes=Py_ssize_t, begin=Py_ssize_t, follows=cython.bint, stamp="unsigned long long")
cdef (Py_ssize_t, Py_ssize_t, Py_ssize_t, Py_ssize_t, Py_ssize_t) _walk(
    const unsigned char[::1] octets, Py_ssize_t[:, ::1] heads, Py_ssize_t last_end, Py_ssize_t look_at,
    bint final) noexcept nogil
