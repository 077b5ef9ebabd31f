cpdef double power(double u1, double gravity, double hover_w, double avionics_w) noexcept nogil
cpdef double effort_rate(double u1, double tau2, double tau3, double tau4) noexcept nogil
