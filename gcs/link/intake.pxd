from libc.stdint cimport int64_t

cdef bint _begin(int64_t[:, ::1] table, int64_t t_ms) noexcept nogil
