cimport cython

from simvehicle.law.rows cimport Command, Parameters, State

cdef double _FARTHEST_M, _FASTEST_M_S, _LONGEST_S, _LEAST_PERIOD_S

cdef void set_reference(State* s, const Command* c, const Parameters* p, double t) noexcept nogil
cdef void guide_on(State* s, const Command* c, const Parameters* p, double t, double dt) noexcept nogil
cdef void start_afresh(State* s, const Parameters* p) noexcept nogil
cdef (double, double, double, double) control(
    State* s, const Command* c, const Parameters* p, double dt) noexcept nogil
cpdef (double, double, double, double) control_row(
    double[::1] state, const double[::1] command, const double[::1] parameters, double dt) noexcept nogil
cdef void _meet_ground(State* s, const Command* c, double x, double y) noexcept nogil
cdef void draw(State* s, const Parameters* p, double u1, double dt) noexcept nogil
@cython.locals(running=cython.bint)
cdef double _step(State* s, const Command* c, const Parameters* p, double t, double dt) noexcept nogil
cdef void take_command(State* s, const Command* c, double t) noexcept nogil
cdef void fly_row(
    State* s, const Command* c, const Parameters* p, double t, double dt, Py_ssize_t steps, double* thrust) noexcept nogil
cpdef void fly_rows(
    double[:, ::1] states, double[:, ::1] commands, double[:, ::1] parameters, double[::1] times, double dt,
    double[:, ::1] thrust) noexcept nogil
