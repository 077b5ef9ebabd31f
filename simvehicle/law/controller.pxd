cpdef (double, double, double) outer(
    double vx, double vy, double vz, double yaw, double vdx, double vdy, double vdz, double adx, double ady, double adz,
    double gain, double drag, double gravity, double tilt_slope, double thrust_max) noexcept nogil
cpdef (double, double, double) outer_literal(
    double vx, double vy, double vz, double yaw, double vdx, double vdy, double vdz, double adx, double ady, double adz,
    double gain, double drag, double gravity) noexcept nogil
cpdef double inner(
    double error, double rate, double rate_d, double acceleration_d, double rate_gain, double angle_gain, double drag,
    double limit) noexcept nogil
cdef double _LEAST_LIFT, _LEAST_LIFT_LITERAL, _FARTHEST
