cimport cython

cdef enum:
    _SIN, _COS, _EXP, _LOG

@cython.locals(row=cython.double[::1], k=Py_ssize_t)
cdef object _of_each(int function, object x)
@cython.locals(n=Py_ssize_t, k=Py_ssize_t, count=Py_ssize_t)
cdef void _raise(double[::1] row, double y) noexcept nogil
