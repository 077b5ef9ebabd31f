cdef enum:
    _AT_ONCE = 8

cdef unsigned short[_AT_ONCE][256] _TERMS

cdef void _fill()
cdef unsigned int summed(
    unsigned int register, const unsigned char* data, Py_ssize_t begin, Py_ssize_t end) noexcept nogil
cpdef unsigned int mcrf4xx(bytes data, unsigned int register=?)

cdef inline unsigned int crc_of(const unsigned char* data, Py_ssize_t begin, Py_ssize_t end) noexcept nogil:
    return summed(0xFFFF, data, begin, end)

cdef inline unsigned int ended(unsigned int crc, unsigned int last) noexcept nogil:
    return crc >> 8 ^ _TERMS[0][(crc ^ last) & 0xFF]
