cimport cython

@cython.locals(rows=Py_ssize_t, pairs=Py_ssize_t, i=Py_ssize_t, k=Py_ssize_t, radius=double, s=double, c=double)
cdef void _box_muller(const double[:, :, ::1] uniform, double[:, ::1] made) noexcept nogil
