cimport cython
from libc.stdint cimport int64_t

from gcs.planner.fuzzy_escape cimport Memory
from gcs.planner.potential_field cimport Field
from skytender.geometry cimport Shape

cpdef enum:  # of a leader
    HOLDS  # it has no way points
    STAYS  # it stays at its last one
    GOES_ON  # it may come to one to be left behind
    ARRIVED  # it has left its last one behind

cdef double _UNFREE_SHARE, _ROUNDING_M

cdef struct Leader:  # as LeaderRows describes
    double[3] q
    double[3] begin
    double[3] v
    double[3] goal
    double[3] goal_v
    double speed
    double obstacle_range
    double lowest
    double route

cdef Leader* _leader_at(double[:, ::1] table, Py_ssize_t row) noexcept nogil
@cython.locals(
    one="Leader*", memory="Memory*", other="const Shape*", q="double*", goal="double*", goal_v="double*",
    count=Py_ssize_t, first=Py_ssize_t, j=Py_ssize_t, heeded=double)
cdef void _lead(
    const int64_t[::1] rows, double[:, ::1] table, double[:, ::1] memories, const double[:, ::1] attractors,
    const unsigned char[:, ::1] draws, const double[:, ::1] obstacles, const int64_t[::1] obstacle_rows,
    const int64_t[:, ::1] obstacle_spans, const double[:, ::1] moving, const double[::1] ranges,
    const unsigned char[:, ::1] exempt, const int64_t[::1] moving_rows, const int64_t[:, ::1] moving_spans,
    const double[::1] constants, double period, bint escape, int64_t[::1] near) noexcept nogil
@cython.locals(one="Leader*", stops=double, way=double)
cpdef void limit_speeds(
    const int64_t[::1] rows, double[:, ::1] table, const double[:, ::1] here, double leash, double lookahead,
    double brake) noexcept nogil
@cython.locals(near=bint)
cpdef bint aim(
    double[:, ::1] table, const int64_t[::1] course, const double[:, ::1] course_ned, double cruise,
    double reached) noexcept nogil
cdef (double, double, double) _field_step(double fn, double fe, double fd, double full_step, double k0) noexcept nogil
cdef double _fed_forward(double on, double oe, double od, double distance, double cap, double k0) noexcept nogil
