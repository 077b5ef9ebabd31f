cimport cython

cdef enum:
    NO_SEED = -1
    _IDS = 1 << 16  # of messages of the definitions, at most
    _COMMON = 1 << 8

cdef struct Intact:  # a frame whose checksum is right
    Py_ssize_t end  # behind its checksum, or its signature; 0: no intact frame begins there
    Py_ssize_t payload  # where its payload begins,
    Py_ssize_t checksum  # and where its checksum stands
    unsigned int msgid
    int version  # of MAVLink: 1 or 2
    int seed  # NO_SEED: the definitions lack the message, and some seed explains its checksum
    bint common  # whether it is one of the common messages

cdef short[_IDS] _SEEDS
cdef bint[_IDS] _EXPLAINED

cdef Intact intact_at(const unsigned char* data, Py_ssize_t at, Py_ssize_t size) noexcept nogil
@cython.locals(place="const unsigned char*", end=Py_ssize_t)
cdef Py_ssize_t next_marker(const unsigned char* data, Py_ssize_t at, Py_ssize_t size) noexcept nogil
