cimport cython

cdef double PWM_LEAST_US, PWM_MOST_US

cdef enum:  # magic numbers of its packets, and their lengths
    PACKET_16 = 18458
    PACKET_16_BYTES = 40
    PACKET_32 = 29569
    PACKET_32_BYTES = 72

cdef packed struct Packet:  # what is read of one
    unsigned short magic
    unsigned short rate
    unsigned int frame
    unsigned short[4] pwm_us

cdef struct Servo:
    unsigned int frame
    double[4] throttles

cpdef tuple parse(bytes datagram)
@cython.locals(motor=int, throttle=double)
cdef bint read(const char* data, Py_ssize_t size, Servo* servo) noexcept
cdef tuple throttles_of(const Servo* servo)
cpdef bytes answer(
    long step, double dt_s, tuple rates_body, tuple accel_body, tuple p_ned, tuple v_ned, tuple quaternion,
    double volts, double amperes)
