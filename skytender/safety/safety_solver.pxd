cimport cython

from skytender.safety.braking_clearance cimport Clearance
from skytender.safety.constraints cimport Constraint, Constraints, Leader, Moves, Near, Problem, Rules

cdef double TOLERANCE_M, _ACTED_M_S2, _ACTIVE_M, LEAVES_M, _SOFT_M
cdef double[4] _BLENDS
cdef int _LAST_BLEND, _REPAIRS, _FEWEST_ROUNDS

cdef void _copy(const double* row, double* to) noexcept nogil
cdef Moves _moves(const Problem* s, const double* u) noexcept nogil
cdef void _blend(const Problem* s, Py_ssize_t i, long long level, const double* wanted, double* u) noexcept nogil
cdef void _into_limits(const Problem* s, Py_ssize_t i, double* u) noexcept nogil
cdef void _turned(
    const double* wanted, long long sysid, double share, double turn, double climb, double* out) noexcept nogil
@cython.locals(before=double[3], i=Py_ssize_t, k=Py_ssize_t, ball=int)
cdef void _project(const Problem* s, const Py_ssize_t* active, Py_ssize_t count, double* u) noexcept nogil
@cython.locals(a=cython.longlong, b=cython.longlong, low=cython.longlong, i=Py_ssize_t, k=Py_ssize_t)
cdef void _find_live(const Problem* s, bint everybody) noexcept nogil
@cython.locals(i=Py_ssize_t, k=Py_ssize_t, found=cython.bint, pair=cython.bint)
cdef void _check(const Problem* s, const double* wanted, double* u, long long* level) noexcept nogil
@cython.locals(before=double[3], i=Py_ssize_t, lower=cython.longlong, kept=cython.bint)
cdef void _restore(const Problem* s, const double* wanted, double* u, long long* level) noexcept nogil
@cython.locals(k=Py_ssize_t, kept=cython.bint, mine=cython.bint)
cdef bint _repair(const Problem* s, Py_ssize_t i, double* u) noexcept nogil
@cython.locals(i=Py_ssize_t, k=Py_ssize_t)
cdef void _set_aims(
    const Problem* s, const double* u, double* full, const double* still, double* aim) noexcept nogil
@cython.locals(i=Py_ssize_t, k=Py_ssize_t, number=int, count=Py_ssize_t)
cdef void _project_in_rounds(
    const Problem* s, const double* aim, Py_ssize_t* active, double* u) noexcept nogil
@cython.locals(i=Py_ssize_t, k=Py_ssize_t)
cdef void _bind(
    const Problem* s, const double* plain, double* u, double* changed, long long* kind,
    long long* binding) noexcept nogil
@cython.locals(
    i=Py_ssize_t, k=Py_ssize_t, u_b=cython.p_double, plain=cython.p_double, aim=cython.p_double, full=cython.p_double,
    still=cython.p_double, projected=cython.p_double)
cdef void _solve(
    Problem* s, double* rows, Py_ssize_t* active, double* u, double* changed, long long* kind, long long* binding,
    long long* level) noexcept nogil
@cython.locals(
    n=Py_ssize_t, m=Py_ssize_t, i=Py_ssize_t, room=cython.p_char, brake=cython.p_double, u_view=double[:, ::1],
    changed_view=double[::1], kind_view=cython.longlong[::1], binding_view=cython.longlong[::1],
    level_view=cython.longlong[::1])
cpdef solve(
    const double[:, ::1] p, const double[:, ::1] v, const double[:, ::1] wanted, const double[::1] v_max,
    const double[::1] a_max, const double[::1] margin, const double[::1] spread, const long long[::1] ids, const double[:, ::1] others,
    const double[:, ::1] table, const unsigned char[::1] beyond, const double[:, ::1] walls,
    const double[:, ::1] pair_required, const double[:, ::1] other_required, Rules rules)
