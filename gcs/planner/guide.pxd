cimport cython

from gcs.planner.line_of_sight cimport Bins, Sight

cpdef enum:  # states of Aims
    STRAIGHT
    ROUTED
    PARTIAL
    NO_ROUTE
    WAITING

cpdef enum:
    MOST_POINTS = 32

cdef int _HALVINGS
cdef double _MOVED_M, _REFRESH_M, _THERE_M, _LEAST_SLACK, _LOST_SHARE

cdef struct Kept:  # what is kept of a vehicle
    double points[32][3]
    double legs[32]  # what the leg to each point keeps
    double searched_from[3]  # infinite before the first search
    double searched_to[3]
    double aim[3]
    long long size  # how many points; 0 without a route
    long long at  # the point that is flown to
    long long waits  # ticks
    long long state

cdef struct Rules:
    double clearance
    double least
    double slack
    double reached
    double floor_d

cdef double _apart(const double* a, const double* b) noexcept nogil
cdef void _copy(const double* place, double* to) noexcept nogil
cpdef double slack_of(double leg, double clearance, double least, double slack) noexcept nogil
cpdef void _advance(
    Sight sight, Kept[::1] kept, const long long[::1] rows, const double[:, ::1] p, const double[:, ::1] goals,
    Rules rules, double[:, ::1] aims, double[::1] remaining, signed char[::1] wanted) noexcept
@cython.locals(
    level=double, last=Py_ssize_t, at=Py_ssize_t, j=Py_ssize_t, seen=cython.bint, elsewhere=cython.bint,
    wanted=cython.bint, place=double[3], points=cython.p_double, legs=cython.p_double, middle=double,
    low=double, high=double)
cdef bint _advance_one(
    const Bins* s, Kept* kept, const double* here, const double* goal, const Rules* rules, double* aim,
    double* remaining) noexcept nogil
