cimport cython
from simvehicle.law.rows cimport Command, Parameters, RotorState, State
from simvehicle.world.rows cimport AirframeRow, Gust, Weather

cpdef enum:
    STEPS_AHEAD = 500  # of noise, which is drawn at once

cdef class BodyMotion:
    cdef readonly tuple p_ned
    cdef readonly tuple v_ned
    cdef readonly tuple quaternion
    cdef readonly tuple rates_body

cdef class Plant:
    cdef readonly object state
    cdef State* row  # of `state`: what the law knows
    cdef RotorState* rotors  # the same row, or NULL on the paper's plant
    cdef readonly double place_deviation_m
    cdef readonly double velocity_deviation_m_s
    cdef object _packed
    cdef const Parameters* _parameters

    cdef _place(self, object state)
    cpdef _begin(self, object flight, object known, bint airborne)
    cdef fly(self, const Command* command, double time_s, Py_ssize_t steps, double* thrust)
    cdef bint stands(self) noexcept
    cdef void true_motion(self, double* motion) noexcept
    cpdef waste(self, double joules)
    cpdef charge(self, double joules)

cdef class RotorPlant(Plant):
    cdef readonly object own
    cdef object _air
    cdef object _frame
    cdef const AirframeRow* _airframe  # of `_frame`
    cdef object _weather
    cdef const Weather* _here  # of `_weather`
    cdef object _gusts
    cdef const Gust* _gust  # of `_gusts`
    cdef Py_ssize_t _gust_count
    cdef double* _noise_rows  # of `_noise`
    cdef Py_ssize_t _drawn  # rows of `_noise`
    cdef object _random
    cdef object _noise
    cdef Py_ssize_t _next  # row of the next step's noise
    cdef bint _gusty
    cdef bint _errs

    cdef _blow(self)
    cdef _draw_ahead(self, Py_ssize_t steps)
    cpdef tuple turn(self, tuple wanted_rad_s, double time_s, double dt_s)
    @cython.locals(motion=BodyMotion)
    cpdef BodyMotion body(self)
