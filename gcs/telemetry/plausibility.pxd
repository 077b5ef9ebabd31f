cpdef enum:  # faults of a place
    POSSIBLE
    NO_NUMBER
    FAR
    FAST
    JUMP

cdef double _FARTHEST_M, _FASTEST_M_S, _JUMP_M, _MOST_J, _MOST_W

cpdef int place_fault(
    double n, double e, double d, double v_n, double v_e, double v_d, double moved_m, double elapsed_s) noexcept nogil
cdef bint countable(double joules, double before_j, double elapsed_s, double step_j) noexcept nogil
