cimport cython
from libc.stdint cimport int64_t

cpdef enum:
    FINE = 25  # looks per interval on a curve: 4 ms, the vehicles' own step, of a period of 0.1 s
    ENDS = 26  # of the parts between two looks
    CLEAR_M = 3  # of a way, behind the place where it began
    CLEAR_AT = 4
    CLEAR_PLACE = 5
    V_BEGAN = 8
    V_ENDED = 11

cdef double _CLOSING_M_S, _BULGE

cdef struct Pair:
    double distance_m
    int64_t one
    int64_t other
    double share
    Py_ssize_t count  # of pairs that are too near

cdef struct Seen:
    Py_ssize_t count
    Pair pair
    Py_ssize_t clearest

cdef (double, double) segment_gap2(double rn, double re, double rd, double dn, double de, double dd) noexcept nogil
cdef (double, double) curve_gap2(
    const double* r0, const double* r1, const double* v0, const double* v1, double period_s) noexcept nogil
cdef (double, double, double) _on_way(
    const double* r0, const double* r1, const double* v0, const double* v1, bint curved, double period_s,
    double share) noexcept nogil
cdef double _bulge(
    const double* r0, const double* r1, const double* v0, const double* v1, double period_s) noexcept nogil
@cython.locals(moved=cython.double, slack=cython.double, left_out=cython.bint, one=int64_t, other=int64_t)
cdef Pair find_pair(
    const double[:, ::1] before, const double[:, ::1] now, const double[:, ::1] v_before, const double[:, ::1] v_now,
    Py_ssize_t n, bint curved, double period_s, const unsigned char[::1] ours, const int64_t[:, ::1] exempt,
    Py_ssize_t exempted, double limit_m, double worth_m, double[:, ::1] found) noexcept nogil
@cython.locals(curved=cython.bint)
cdef void _find_nearest(
    const double[:, ::1] before, const double[:, ::1] now, const double[:, ::1] v_before, const double[:, ::1] v_now,
    const double[:, ::1] others_before, const double[:, ::1] others_now, double period_s, double[::1] least,
    int64_t[::1] which, double[::1] shares) noexcept nogil
cdef (double, double) _clearance_between(
    const double[:, ::1] shapes, const double* r0, const double* r1, const double* v0, const double* v1, bint curved,
    double period_s, const double[::1] reach, double* there) noexcept nogil
@cython.locals(pair=Pair, known=cython.bint, curved=cython.bint)
cdef Seen _look(
    const double[:, ::1] p, const double[:, ::1] v, double[:, :, ::1] last, double period_s,
    const unsigned char[::1] flying, const unsigned char[::1] ours, const int64_t[:, ::1] exempt,
    const double[:, ::1] shapes, double limit_m, double worth_m, double clear_limit_m, double clear_worth_m,
    double[:, ::1] ways, double[:, ::1] found, int64_t[::1] rows, int64_t[::1] place, double[:, :, ::1] block,
    unsigned char[::1] own, int64_t[:, ::1] pairs, double[::1] reach) noexcept nogil
@cython.locals(known=cython.bint, left=cython.Py_ssize_t)
cpdef Py_ssize_t pass_points(
    const double[:, ::1] p, double[:, ::1] last, const unsigned char[::1] left_out, const double[:, ::1] points,
    int64_t[::1] ahead, const int64_t[::1] end, double within2) noexcept nogil

cdef class FleetWatch:
    cdef double[:, :, ::1] _last
    cdef const double[:, ::1] _shapes
    cdef double[:, ::1] _ways
    cdef double[:, ::1] _found
    cdef int64_t[::1] _rows
    cdef int64_t[::1] _place
    cdef double[:, :, ::1] _block
    cdef unsigned char[::1] _own
    cdef int64_t[:, ::1] _pairs
    cdef double[::1] _reach

    @cython.locals(seen=Seen)
    cpdef look(
        self, const double[:, ::1] p, const double[:, ::1] v, double period_s, flying, ours, const int64_t[:, ::1] exempt,
        double limit_m, double worth_m, double clear_limit_m, double clear_worth_m)
