cimport cython

cpdef enum:
    MAGIC = 0xFD
    MAGIC_1 = 0xFE
    HEADER_1_BYTES = 6
    HEADER_BYTES = 10
    CHECKSUM_BYTES = 2
    SIGNATURE_BYTES = 13
    SIGNED = 0x01
    MOST_TRIES = 64

cdef enum:
    _LOW_IDS = 512

cdef short[_LOW_IDS] _SEEDS  # CRC_EXTRA of messages with a low id, -1 where there is none

cdef class ReceivedFrame:
    cdef readonly unsigned int sysid
    cdef readonly unsigned int compid
    cdef readonly unsigned int seq
    cdef readonly unsigned int msgid
    cdef readonly bytes payload
    cdef readonly bytes raw

cpdef schema(unsigned int msgid)
cdef int _seed(unsigned int msgid) except? -1
cpdef list split(bytes datagram)
@cython.locals(
    data="const unsigned char *", start=Py_ssize_t, end=Py_ssize_t, tries=int, check=Py_ssize_t, stop=Py_ssize_t,
    msgid="unsigned int", crc="unsigned int", frame=ReceivedFrame)
cdef _split(bytes datagram, list frames)
