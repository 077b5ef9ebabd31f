cimport cython

from gcs.planner.line_of_sight cimport Bins, Sight

cdef double _ROUNDING_M
cdef int _TIGHTEN_ROUNDS, _HALVINGS, _CENTRE_STEPS

cdef bint _keeps(const Bins* s, const double* a, const double* b, double level) noexcept nogil
@cython.locals(legs=double[::1], kept=double[:, ::1], level=double[::1])
cpdef pulled(
    Sight s, const double[:, ::1] path, double clearance, double narrow, double cell, double floor_d)
@cython.locals(size=Py_ssize_t, first=Py_ssize_t, end=Py_ssize_t, at=Py_ssize_t, to=Py_ssize_t, least=double)
cdef Py_ssize_t _pull(
    const Bins* s, const double* path, const double* legs, Py_ssize_t count, double clearance, double narrow,
    double cell, double floor_d, double* kept, double* level) noexcept nogil
cdef int _kind(double leg, double clearance, double narrow) noexcept nogil
@cython.locals(a=double[3], b=double[3], moved=cython.bint, side=int)
cdef void _centre(
    const Bins* s, double* kept, double* level, Py_ssize_t i, double clearance, double cell,
    double floor_d) noexcept nogil
@cython.locals(chord=double[3], foot=double[3], place=double[3], moved=double[3], square=double, along=double)
cdef void _tighten(const Bins* s, double* kept, const double* level, Py_ssize_t i) noexcept nogil
@cython.locals(count=Py_ssize_t, needed=cython.bint)
cdef Py_ssize_t _thinned(const Bins* s, double* kept, double* level, Py_ssize_t size) noexcept nogil
cdef void _copy(const double* place, double* to) noexcept nogil
