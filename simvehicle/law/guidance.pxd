from simvehicle.law.rows cimport Guide, GuideYaw

cdef double NO_STAMP

cdef double _sqrt_slope(double distance, double gain, double decel) noexcept nogil
cdef void _shape_axis(Guide* memory, int axis, double acceleration, double omega, double dt) noexcept nogil
cdef void start_axis(Guide* memory, int axis, double position, double velocity, double omega) noexcept nogil
cdef void start_yaw(GuideYaw* memory, double yaw, double rate, double omega) noexcept nogil
cdef void shape(
    Guide* memory, double ex, double ey, double ez, double vx, double vy, double vz, double speed_max, double accel_max,
    double gain, double decel, double velocity_gain, double omega, double dt) noexcept nogil
cdef void shape_yaw(GuideYaw* memory, double yaw, double rate_max, double omega, double dt) noexcept nogil
cpdef (double, double, double) reference_axis(double r1, double r2, double r3, double omega) noexcept nogil
cpdef (double, double) linear_axis(double start, double end, double elapsed, double period) noexcept nogil

cdef inline Guide* guide_of(double[::1] memory) noexcept nogil:
    return <Guide*>&memory[0]

cdef inline GuideYaw* guide_yaw_of(double[::1] memory) noexcept nogil:
    return <GuideYaw*>&memory[0]

cpdef follow(
    double[::1] memory, const double[::1] error, const double[::1] velocity, double speed_max, double accel_max, law,
    double dt)
cpdef void follow_yaw(double[::1] memory, double yaw, double rate_max, double omega, double dt) noexcept nogil
