cimport cython
from skytender.intact_frames cimport Intact

cpdef enum:
    MOST_TRIES = 64

cdef bint _begins_frame(const unsigned char* data, Py_ssize_t at, Py_ssize_t size) noexcept nogil
@cython.locals(
    data="const unsigned char*", size=Py_ssize_t, at=Py_ssize_t, frame_end=Py_ssize_t, tries=int, malformed=int,
    unknown=int, intact=Intact, raw=bytes)
cpdef split(bytes datagram)
