cimport cython

from skytender.geometry cimport Shape

cdef double _GOLDEN, _EXACT_M, _ROUNDING_M

cdef struct Bins:  # what a Sight holds, for compiled code
    const Shape* shapes
    const long long* first  # (rows * columns + 1,): where each bin's list begins in `listed`
    const long long* listed
    Py_ssize_t count  # of shapes listed
    double low_n
    double low_e
    double bin_m
    Py_ssize_t rows
    Py_ssize_t columns
    double reach_m

cdef class Sight:
    cdef readonly object table
    cdef readonly object first
    cdef readonly object listed
    cdef Bins bins

cdef void _point(
    Bins* bins, const double[:, ::1] table, const long long[::1] first, const long long[::1] listed) noexcept nogil
cdef void _count(
    const long long[::1] from_n, const long long[::1] to_n, const long long[::1] from_e, const long long[::1] to_e,
    Py_ssize_t columns, long long[::1] first) noexcept nogil
cdef void _list(
    const long long[::1] from_n, const long long[::1] to_n, const long long[::1] from_e, const long long[::1] to_e,
    Py_ssize_t columns, long long[::1] following, long long[::1] listed) noexcept nogil
@cython.locals(
    first_row=Py_ssize_t, last_row=Py_ssize_t, first_column=Py_ssize_t, last_column=Py_ssize_t, row=Py_ssize_t,
    column=Py_ssize_t, place=Py_ssize_t, k=Py_ssize_t, t0=double, t1=double, least=double)
cdef double leg_clearance(
    const Bins* s, double an, double ae, double ad, double bn, double be, double bd, double enough,
    double stop) noexcept nogil
cdef double _along(
    const Shape* shape, double an, double ae, double ad, double bn, double be, double bd, double enough,
    double stop) noexcept nogil
cdef bint sees(
    const Bins* s, double an, double ae, double ad, double bn, double be, double bd, double level,
    double floor_d) noexcept nogil

cdef double clearance_between(
    const Bins* s, const double* a_ned, const double* b_ned, double enough, double stop) noexcept nogil
cdef bint sees_from(
    const Bins* s, const double* a_ned, const double* b_ned, double level, double floor_d) noexcept nogil
cpdef double clear_m(
    Sight s, const double[::1] a_ned, const double[::1] b_ned, double enough, double stop=*) noexcept
cpdef bint visible(
    Sight s, const double[::1] a_ned, const double[::1] b_ned, double level, double floor_d) noexcept
@cython.locals(clearances=double[::1])
cpdef leg_clearances(Sight s, const double[:, ::1] path_ned)
