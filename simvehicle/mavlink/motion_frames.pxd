cimport cython
from simvehicle.law.rows cimport State

cpdef enum:
    ATTITUDE = 1
    LOCAL_POSITION = 2
    GLOBAL_POSITION = 4
    LARGEST_BYTES = 120

cdef enum:
    _PAYLOAD_BYTES = 28  # of each of the three
    HEADER_BYTES = 10
    MAGIC = 0xFD
    TURN_DEG = 360
    _ATTITUDE_ID = 30
    _LOCAL_ID = 32
    _GLOBAL_ID = 33
    _ATTITUDE_SEED = 39
    _LOCAL_SEED = 185
    _GLOBAL_SEED = 104

cdef double _TURN_RAD

cdef double remainder(double x, double whole) noexcept nogil
cdef long long bounded(double value, int bits) noexcept nogil
cdef long long rounded(double value) noexcept nogil
cdef long long heading_cdeg(double angle_rad) noexcept nogil
@cython.locals(crc=cython.uint, low=cython.uint)
cdef unsigned int checksum(
    const unsigned char* frame, Py_ssize_t start, Py_ssize_t end, unsigned int seed) noexcept nogil
cdef Py_ssize_t write_frame(
    unsigned char* out, Py_ssize_t at, const unsigned char* payload, Py_ssize_t size, int msgid, unsigned int seed,
    int seq, int sysid, int compid) noexcept nogil
cpdef (Py_ssize_t, Py_ssize_t, Py_ssize_t) write_motion(
    unsigned char[::1] out, double[:, ::1] state, const double[::1] origin, double home_down_m, long long time_ms,
    int wanted, int seq, int sysid, int compid) noexcept nogil
cdef (Py_ssize_t, Py_ssize_t, Py_ssize_t) motion_of(
    unsigned char* out, const State* s, const double* origin, double home_down_m, long long time_ms, int wanted,
    int seq, int sysid, int compid) noexcept nogil
