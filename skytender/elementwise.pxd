cimport cython

cdef enum:
    _SIN, _COS, _EXP, _LOG, _POW

@cython.locals(row=cython.double[::1], k=Py_ssize_t)
cdef object _of_each(int function, object x, double y=?)
