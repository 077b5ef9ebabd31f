# Numbers in a frame's payload, low byte first. Trailing zeros of a payload are cut: what lies at `stop` or behind is 0.

from libc.stdint cimport int8_t, int16_t, int32_t, int64_t, uint32_t
from libc.string cimport memcpy

cdef inline int64_t octet(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil:
    return data[at] if at < stop else 0

cdef inline int64_t u16(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil:
    return octet(data, at, stop) | octet(data, at + 1, stop) << 8

cdef inline int64_t u32(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil:
    return u16(data, at, stop) | u16(data, at + 2, stop) << 16

cdef inline int64_t i8(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil:
    return <int8_t>octet(data, at, stop)

cdef inline int64_t i16(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil:
    return <int16_t>u16(data, at, stop)

cdef inline int64_t i32(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil:
    return <int32_t>u32(data, at, stop)

cdef inline double f32(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil:
    cdef uint32_t bits = <uint32_t>u32(data, at, stop)
    cdef float value
    memcpy(&value, &bits, sizeof(value))
    return value

cdef inline void put(unsigned char* frame, Py_ssize_t at, int64_t number, Py_ssize_t size) noexcept nogil:
    for k in range(size):
        frame[at + k] = (number >> 8 * k) & 0xFF

cdef inline void put_f32(unsigned char* frame, Py_ssize_t at, float number) noexcept nogil:
    cdef uint32_t bits
    memcpy(&bits, &number, sizeof(number))
    put(frame, at, bits, sizeof(bits))
