cdef double _K_ANGLE, _K_ACCELERATION, _TINY
cdef int _MOST_EVALUATIONS

cpdef (double, double, double, int) solve(
    double x1, double x2, double x3, double signal, double dt, double epsilon, double tolerance) noexcept nogil
cpdef (double, double) solve_two(
    double x1, double x2, double x3, double x, double y1, double y2, double y3, double y, double dt, double epsilon,
    double tolerance) noexcept nogil
