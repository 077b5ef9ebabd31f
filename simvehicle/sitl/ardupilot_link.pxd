cdef enum:
    SERVO_BYTES = 2048
