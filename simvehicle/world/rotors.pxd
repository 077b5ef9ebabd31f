cimport cython
from simvehicle.world.rows cimport AirframeRow, Body

cdef struct Sums:  # over the rotors: ω, ωx, ωy, ωxx, ωyy, ωxy, and thrust with its moments
    double s
    double sx
    double sy
    double sxx
    double syy
    double sxy
    double thrust
    double mx
    double my
    double mz

cdef inline Body* body_at(double[::1] row) noexcept nogil:
    return <Body*>&row[0]

cdef inline const AirframeRow* airframe_at(const double[::1] row) noexcept nogil:
    return <const AirframeRow*>&row[0]

cdef (double, double, double) rotated(const double* q, double x, double y, double z, double sign) noexcept nogil
cdef void rotor_sums(const Body* body, const double* wanted, double share, const AirframeRow* a, Sums* out) noexcept nogil
cdef (double, double, double, double, double, double) wrench(
    const Body* at, const Sums* sums, const double* wind, const AirframeRow* a) noexcept nogil
cdef void _slope(
    const Body* at, const Sums* sums, const double* wind, const AirframeRow* a, double* out) noexcept nogil
cdef (double, double) spin_up(const AirframeRow* a, double dt) noexcept nogil
cdef void step_body(
    Body* body, const double* wanted, const double* wind, const AirframeRow* a, (double, double) spin,
    double dt) noexcept nogil
cdef void _normalise(Body* body) noexcept nogil
cdef bint land_body(Body* body, double x, double y, bint stood) noexcept nogil
cdef (double, double, double) euler_of(const double* q) noexcept nogil
cdef void quaternion_of(double roll, double pitch, double yaw, double* out) noexcept nogil
@cython.locals(whole=cython.bint)
cdef void allocate(double thrust, double mx, double my, double mz, const AirframeRow* a, double* out) noexcept nogil
cdef void _allocate_less(
    double thrust, double mx, double my, double mz, const double* m, double most, double coefficient,
    double* out) noexcept nogil
cdef (double, double, double) moments_of(
    const double* angles, const double* rates, double roll_acc, double pitch_acc, double yaw_acc,
    const AirframeRow* a) noexcept nogil

cpdef void body_step(
    double[::1] body, const double[::1] wanted, const double[::1] wind, const double[::1] airframe,
    double dt) noexcept nogil
cpdef bint meet_ground(double[::1] body, double x, double y, bint stood) noexcept nogil
@cython.locals(out=double[::1])
cpdef rotor_speeds(double thrust, double mx, double my, double mz, const double[::1] airframe)
cpdef (double, double, double) moments(
    const double[::1] angles, const double[::1] rates, const double[::1] accelerations,
    const double[::1] airframe) noexcept nogil
cpdef (double, double, double) in_body_axes(const double[::1] quaternion, double x, double y, double z) noexcept nogil
@cython.locals(out=double[::1])
cpdef quaternion(double roll, double pitch, double yaw)
