cdef double _sig(double x, double power) noexcept nogil
cdef double _sign(double x) noexcept nogil
cpdef (double, double, double) explicit(
    double x1, double x2, double x3, double signal, double dt, double epsilon) noexcept nogil
cpdef (double, double, double) sliding_mode(
    double x, double u1, double signal, double dt, double alpha, double lambda_) noexcept nogil
cpdef (double, double) high_gain(
    double x1, double x2, double signal, double dt, double k1, double k2, double alpha) noexcept nogil
