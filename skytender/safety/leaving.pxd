cimport cython

from skytender.safety.braking_clearance cimport Clearance
from skytender.safety.constraints cimport Moves, Other, Problem

cdef int DIRECTIONS
cdef double FREE_M, PEER_M, NEARBY_M, _HALF
cdef double[8] _NORTH

@cython.locals(
    un=double, ue=double, ud=double, left=double, t=double, span=double, least=double, when=double,
    nn=double, ne=double, nd=double)
cdef Clearance way_clearance(
    double xn, double xe, double xd, double vn, double ve, double vd, double brake, double v_max, double w,
    const double* e, double dt, double horizon) noexcept nogil
cdef Clearance reach_clearance(
    const Moves* m, Py_ssize_t i, const Other* other, const double* leave, double dt, double horizon,
    double enough) noexcept nogil
cpdef (double, double) clearance_leaving(
    const double[::1] p, const double[::1] v, const double[::1] u, double w, const double[::1] e, double brake,
    double v_max, double dt, double horizon)
@cython.locals(
    k=Py_ssize_t, end=Py_ssize_t, at=Py_ssize_t, i=cython.longlong, number=int, most=double, least=double)
cdef void choose_directions(Problem* s) noexcept nogil
cdef bint _write_away(const Problem* s, Py_ssize_t k, double* e) noexcept nogil
@cython.locals(k=Py_ssize_t, least=double)
cdef double _least_of(
    const Problem* s, Py_ssize_t begin, Py_ssize_t end, const double* e, double enough) noexcept nogil
@cython.locals(j=Py_ssize_t, free=double, near=double)
cdef double _hindrance(const Problem* s, cython.longlong i, const double* e) noexcept nogil
@cython.locals(eighth=int, level=double)
cdef void write_direction(int number, double* e) noexcept nogil
