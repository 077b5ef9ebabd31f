cpdef enum:
    MAGIC = 0xFD
    MAGIC_1 = 0xFE  # of MAVLink 1
    HEADER_BYTES = 10
    HEADER_1_BYTES = 6
    PAYLOAD_BYTES = 255
    CHECKSUM_BYTES = 2
    FRAME_BYTES = 267  # at most, unsigned
    SIGNED = 1  # flag of a frame that a signature follows
    SIGNATURE_BYTES = 13

cdef Py_ssize_t write_frame(
    unsigned char* out, const unsigned char* payload, Py_ssize_t size, unsigned int msgid, unsigned int seed,
    unsigned int seq, unsigned int sysid, unsigned int compid) noexcept nogil
cdef bytes framed(
    const unsigned char* payload, Py_ssize_t size, unsigned int msgid, unsigned int seed, unsigned int seq,
    unsigned int sysid, unsigned int compid)
cpdef bytes frame(
    bytes payload, unsigned int msgid, unsigned int seed, unsigned int seq, unsigned int sysid, unsigned int compid)
