cimport cython

from skytender.safety.constraints cimport Moves, Other
from skytender.geometry cimport Shape

cdef double TINY, _GAP_M
cdef int _TANGENTS

# in the coming period, after it, when after its end s, direction to where the distance grows n, e, d
ctypedef (double, double, double, double, double, double) Clearance

cpdef (double, double, double) braking(double vn, double ve, double vd, double brake, double dt) noexcept nogil
cpdef double stop_distance(double speed, double brake, double dt) noexcept nogil
cpdef double stop_way(double speed, double brake, double dt) noexcept nogil
cdef Clearance period_bound(
    double an, double ae, double ad, double bn, double be, double bd, double cn, double ce, double cd, double span,
    double growth) noexcept nogil
cdef double _least(double a, double b, double c, double span) noexcept nogil
cdef Clearance pair_clearance(const Moves* m, Py_ssize_t i, Py_ssize_t j, double dt, double enough) noexcept nogil
@cython.locals(stands=cython.bint)
cdef Clearance other_clearance(
    const Moves* m, Py_ssize_t i, const Other* other, double dt, double horizon, double enough) noexcept nogil
cdef Clearance _segment(
    const Shape* shape, double n0, double e0, double d0, double n1, double e1, double d1, double enough) noexcept nogil
cdef Clearance shape_clearance(
    const Moves* m, Py_ssize_t i, const Shape* shape, double dt, double enough) noexcept nogil
cdef Clearance plane_clearance(
    const Moves* m, Py_ssize_t i, Py_ssize_t axis, double limit, double dt) noexcept nogil
cdef (double, double, double) sensitivity(
    double vn, double ve, double vd, double brake, double t, double way, double nn, double ne, double nd,
    double dt) noexcept nogil
