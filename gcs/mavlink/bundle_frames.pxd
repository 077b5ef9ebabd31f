cimport cython
from libc.stdint cimport int64_t

cpdef enum:
    NONE = -1
    LEFT_OUT = -2
    MOST_FRAMES = 3
    TEMPLATE_BYTES = 72
    MARKER_WIDTH = 32
    BUNDLE_BYTES = MARKER_WIDTH + MOST_FRAMES * TEMPLATE_BYTES
    VALUES = 6

cdef enum:
    _HEARTBEAT, _SET_POINT, _GRANT  # rows of the templates
    _HEADER_BYTES = 10
    _CRC_BYTES = 2
    _SEQ_AT = 4
    _VALUES_AT = _HEADER_BYTES + 4  # behind time_boot_ms
    _TARGET_AT = _HEADER_BYTES + 50

cdef struct Vehicle:
    int64_t number  # the next sequence number
    int64_t sysid
    int64_t marker_bytes
    int64_t point  # row of its set point, NONE or LEFT_OUT
    int64_t heartbeat_due  # whether a HEARTBEAT is due

cdef inline Vehicle* vehicle_at(int64_t[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <Vehicle*>&rows[i, 0]

cdef void _sum(unsigned char* frame, Py_ssize_t size, unsigned int seed) noexcept nogil
@cython.locals(value=float)
cdef bint _aim(unsigned char* frame, int64_t sysid, const double* values) noexcept nogil
@cython.locals(grant=cython.p_uchar)
cdef void _date(
    unsigned char[:, ::1] templates, int64_t[:, ::1] sizes, int64_t point_ms, int64_t unix_us,
    int64_t grant_ms) noexcept nogil
@cython.locals(at=Py_ssize_t, frames=Py_ssize_t, vehicle="Vehicle *", frame=cython.p_uchar, size=Py_ssize_t)
cpdef (int64_t, int64_t) write_bundles(
    unsigned char[::1] out, int64_t[:, ::1] rows, const unsigned char[:, ::1] markers, const double[:, ::1] values,
    unsigned char[:, ::1] templates, int64_t[:, ::1] sizes, int64_t[:, ::1] cuts, int64_t[:, ::1] spans,
    int64_t point_ms, int64_t unix_us, int64_t grant_ms) noexcept nogil
