cimport cython

from skytender.safety.braking_clearance cimport Clearance
from skytender.safety.constraints cimport Constraint, Moves, Surroundings

cpdef enum:  # kinds of constraints
    PAIR = 1
    OTHER
    OBSTACLE
    PLANE
    REACH

cdef double GOLDEN, _PLASTIC
cdef int _LIMIT_SWEEPS

cdef Clearance clearance_of(
    const Constraint* c, double enough, const Moves* m, const Surroundings* around) noexcept nogil
cdef void into_ball(double* u, double cn, double ce, double cd, double radius) noexcept nogil
cdef void into_limits(
    double* u, const double* v, const double* u_b, double a_max, double v_top, double dt) noexcept nogil
cdef double part_of_turn(double x) noexcept nogil
cpdef double descent_of(long long sysid) noexcept nogil
@cython.locals(t=double, way=double)
cdef bint write_line(
    Constraint* c, double after, double when, double nn, double ne, double nd, const Moves* m, double dt,
    const long long* ids) noexcept nogil
@cython.locals(k=Py_ssize_t, found=double[:, ::1])
cpdef clearances(
    const long long[:, ::1] rows, double enough, const double[:, ::1] p, const double[:, ::1] v,
    const double[:, ::1] u, const double[::1] brake, const double[:, ::1] others, const double[:, ::1] table,
    const double[:, ::1] walls, double dt, double horizon)
