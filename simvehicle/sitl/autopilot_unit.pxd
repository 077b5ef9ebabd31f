cimport cython

cdef class Sensed:
    cdef public tuple p_ned
    cdef public tuple v_ned
    cdef public tuple quaternion
    cdef public tuple rates_body
    cdef public tuple accel_body

@cython.locals(a=double, b=double, c=double, d=double)
cdef tuple _speeds(tuple throttles, double fastest_rad_s)
cdef tuple _sum(tuple a, object b)
cdef tuple _turned(tuple quaternion, object angles)
