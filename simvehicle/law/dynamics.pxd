from skytender.elementary cimport TOGETHER

cdef enum:
    STAGES = TOGETHER  # of RK4

cdef (double, double, double) _thrust_towards(
    double sin_roll, double cos_roll, double sin_pitch, double cos_pitch, double sin_yaw, double cos_yaw) noexcept nogil
cpdef (double, double, double) thrust_direction(double roll, double pitch, double yaw) noexcept nogil
cpdef (double, double, double, double, double) rk4_axis(
    double x, double v, double a1, double a2, double a3, double a4, double drag, double dt) noexcept nogil
cdef void fly_plant(
    double* s, double u1, double tau2, double tau3, double tau4, double gravity, double drag, double rotational_drag,
    double dt) noexcept nogil
cpdef void plant_step(
    double[::1] s, double u1, double tau2, double tau3, double tau4, double gravity, double drag,
    double rotational_drag, double dt) noexcept nogil
cpdef double wrap_angle(double angle) noexcept nogil
