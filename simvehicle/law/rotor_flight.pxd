cimport cython
from simvehicle.law.rows cimport Command, Parameters, RotorState
from simvehicle.world.rows cimport AirframeRow, Gust, Weather

cpdef enum:
    NOISE_SIZE = 17  # normal numbers that a step takes: the wind's, then the estimate's

cdef double _GRAVITY_M_S2, _LEAST_COSINE, _OBSERVER_1_S, _STRONGEST_M_S2

cdef void _see(RotorState* s, const double* error) noexcept nogil
cdef void _observe(RotorState* s, const Parameters* p, double u1, double dt) noexcept nogil
cdef void _blow(
    RotorState* s, const Weather* w, const Gust* gusts, Py_ssize_t count, const double* noise, double t,
    double dt) noexcept nogil
cdef double _draw(
    RotorState* s, const Parameters* p, const AirframeRow* a, const Weather* w, double dt) noexcept nogil
@cython.locals(running=cython.bint, stood=cython.bint)
cdef double _step(
    RotorState* s, const Command* c, const Parameters* p, const AirframeRow* a, const Weather* w, const Gust* gusts,
    Py_ssize_t count, const double* noise, const double* decays, (double, double) spin, double t,
    double dt) noexcept nogil
cdef void fly_row(
    RotorState* s, const Command* c, const Parameters* p, const AirframeRow* a, const Weather* w, const Gust* gusts,
    Py_ssize_t count, const double* noise, double t, double dt, Py_ssize_t steps, double* thrust) noexcept nogil
@cython.locals(stood=cython.bint)
cdef void turn_row(
    RotorState* s, double* wanted, const Parameters* p, const AirframeRow* a, const Weather* w, const Gust* gusts,
    Py_ssize_t count, const double* noise, double t, double dt, double* force) noexcept nogil
