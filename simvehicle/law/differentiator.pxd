cdef enum:
    BOTH = 2

cdef double _K_ANGLE, _K_ACCELERATION, _TINY
cdef int _MOST_EVALUATIONS

cdef int _solve(
    const double* x1, const double* x2, const double* x3, const double* signals, double dt, double epsilon,
    double tolerance, double* s) noexcept nogil
cpdef (double, double, double, int) solve(
    double x1, double x2, double x3, double signal, double dt, double epsilon, double tolerance) noexcept nogil
cpdef (double, double, int) solve_two(
    double x1, double x2, double x3, double x, double y1, double y2, double y3, double y, double dt, double epsilon,
    double tolerance) noexcept nogil
