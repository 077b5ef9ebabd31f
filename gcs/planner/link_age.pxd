cimport cython

cdef double _LEAST_S, _MOST_S, _USUAL_SHARE, _SPARE_S

@cython.locals(most=double)
cdef void _receive(
    const double[:] age, double period, double decay, double[::1] last, double[::1] oldest,
    unsigned char[::1] silent) noexcept nogil
