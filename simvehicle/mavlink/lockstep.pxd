cimport cython
from simvehicle.mavlink.codec cimport ReceivedFrame
from simvehicle.mavlink.connection cimport Connection

cpdef enum:
    FRAMES_A_TICK = 127
    SHARED = 1
    SHARED_BYTES = 4096
    SYSTEM = 255
    COMPONENT = 190

cdef class Bundle:
    cdef readonly list frames
    cdef readonly long long time_ms
    cdef readonly unsigned long long unix_us

cdef class Grants:
    cdef Connection _connection
    cdef readonly unsigned int number
    cdef readonly list last_answer
    cdef readonly long long time_ms

    @cython.locals(last=ReceivedFrame, frame=ReceivedFrame, bundle=Bundle, seq='unsigned int')
    cpdef feed(self, list frames)
    cpdef list answer(self, Bundle bundle)

cdef bint _is_supervisors(ReceivedFrame frame, unsigned int msgid) noexcept
cdef unsigned int _addressee(bytes payload) noexcept
@cython.locals(frame=ReceivedFrame, frames=list)
cpdef list bundles(bytes datagram)
