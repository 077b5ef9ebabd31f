cimport cython

cdef struct Head:  # a row of the heads of a chunk's frames
    Py_ssize_t t_us
    Py_ssize_t at  # place of the frame's marker in the chunk's bytes
    Py_ssize_t sysid
    Py_ssize_t compid
    Py_ssize_t seq
    Py_ssize_t msgid

cdef inline Head* head_at(const Py_ssize_t[:, ::1] heads, Py_ssize_t i) noexcept nogil:
    return <Head*>&heads[i, 0]

cdef int _SYSTEM_TIME
cdef unsigned long long _PRIME, _OFFSET

cdef void _fill_sent(
    const Py_ssize_t[:, ::1] heads, const unsigned char[::1] stations, Py_ssize_t[::1] answered_us,
    const Py_ssize_t[::1] relayed, unsigned char[::1] sent) noexcept nogil
cdef unsigned long long _hashed(unsigned long long h, unsigned long long byte) noexcept nogil
@cython.locals(h="unsigned long long")
cdef void _fill_keys(
    const unsigned char[::1] data, const Py_ssize_t[:, ::1] heads, const Py_ssize_t[:, ::1] subjects,
    Py_ssize_t[::1] keys) noexcept nogil
cdef Py_ssize_t _fill_last(const Py_ssize_t[::1] keys, Py_ssize_t[::1] slots, Py_ssize_t[::1] last) noexcept nogil
