cimport cython
from skytender.intact_frames cimport Intact

cpdef enum:
    MOST_TRIES = 64

cdef class ReceivedFrame:
    cdef readonly unsigned int sysid
    cdef readonly unsigned int compid
    cdef readonly unsigned int seq
    cdef readonly unsigned int msgid
    cdef readonly bytes payload
    cdef readonly bytes raw

cpdef schema(unsigned int msgid)
cpdef list split(bytes datagram)
@cython.locals(
    data="const unsigned char *", text="const char *", place="const unsigned char *", at=Py_ssize_t, size=Py_ssize_t, tries=int, intact=Intact,
    frame=ReceivedFrame)
cdef _split(bytes datagram, list frames)
