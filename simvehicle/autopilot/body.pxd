from simvehicle.law.plants cimport Plant
from simvehicle.law.rows cimport Command

cpdef enum:
    STEP_MS = 4
    CHUNK_MS = 100

cdef class Body:
    cdef readonly object parameters
    cdef readonly Plant plant
    cdef public long long time_ms
    cdef readonly bint ground
    cdef readonly double initial_j
    cdef readonly double fastest_turn_rad_s
    cdef public double power_w
    cdef double lift_m_s2  # thrust per mass now; 0 with motors off
    cdef double full_m_s2  # the same at full throttle
    cdef double[3] shift_ned  # what a wrong GPS adds to its place, m
    cdef bint shifted
    cdef Command command  # of the next stretch
    cdef object _thrust
    cdef double* thrust  # (steps,), per mass after each step of the last flight, m/s²
    cdef readonly Py_ssize_t steps
    cdef Py_ssize_t room  # for thrust

    cpdef retune(self)
    cdef (double, double, double) seen(self, double x, double y, double z) noexcept
    cdef bint stands(self) noexcept
    cdef double throttle(self) noexcept
    cdef have_room(self, Py_ssize_t steps)
    cdef put_target(self, object wanted)
    cdef fly(self, Py_ssize_t steps, double yaw_ned_rad, bint motors)
