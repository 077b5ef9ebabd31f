cimport cython

from skytender.safety.constraints cimport Box, Constraint, Constraints, Near

cdef int _ROOM
cdef double _ROUNDING_M

@cython.locals(i=Py_ssize_t)
cdef int find_constraints(const Near* near, double* reach, Box* boxes, Constraints* found) except -1 nogil
@cython.locals(
    i=Py_ssize_t, j=Py_ssize_t, k=Py_ssize_t, at=Py_ssize_t, begin=Py_ssize_t, end=Py_ssize_t, first=Py_ssize_t,
    farthest=double, most_reach=double, most_margin=double)
cdef int _find_pairs(const Near* near, const double* reach, Box* boxes, Constraints* found) except -1 nogil
@cython.locals(i=Py_ssize_t, j=Py_ssize_t, far=double, closing=double)
cdef int _find_others(const Near* near, const double* reach, Constraints* found) except -1 nogil
@cython.locals(
    i=Py_ssize_t, at=Py_ssize_t, begin=Py_ssize_t, end=Py_ssize_t, first=Py_ssize_t, widest=double, d=double)
cdef int _find_shapes(const Near* near, const double* reach, Box* boxes, Constraints* found) except -1 nogil
@cython.locals(i=Py_ssize_t, side=Py_ssize_t)
cdef int _find_walls(const Near* near, const double* reach, Constraints* found) except -1 nogil
cdef int _put(
    Constraints* found, int kind, Py_ssize_t i, Py_ssize_t j, double required) except -1 nogil
cdef void _in_order(Constraints* found, Py_ssize_t first) noexcept nogil
@cython.locals(k=Py_ssize_t)
cdef double _of_pair(
    const double* given, Py_ssize_t count, Py_ssize_t i, Py_ssize_t j, double usual) noexcept nogil
cdef double _distance(const double* a, const double* b) noexcept nogil
cdef double _outside(const double* p, const Box* box) noexcept nogil
cdef int _by_south(const void* a, const void* b) noexcept nogil
cdef int _by_what(const void* a, const void* b) noexcept nogil
@cython.locals(middle=Py_ssize_t, low=Py_ssize_t)
cdef Py_ssize_t _first_from(const Box* boxes, Py_ssize_t count, double north, bint beyond) noexcept nogil
