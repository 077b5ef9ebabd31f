cdef void step_errors(double* error, const double* noise, const double* deviations, const double* decays) noexcept nogil
cpdef void error_step(
    double[::1] error, const double[::1] noise, const double[::1] deviations, const double[::1] decays) noexcept nogil
