cdef void _update(
    const double[::1] t_s, const double[:, ::1] distance_m, double within_m, double[::1] since_s, double[::1] held_s,
    double[::1] worst_s) noexcept nogil
