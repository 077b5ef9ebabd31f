from simvehicle.world.rows cimport Gust

cdef double _FOOT_M, _LOWEST_FT, _HIGHEST_FT, _LEAST_AIR_SPEED_M_S, _ROOT3, _SMALL

cdef inline const Gust* gusts_at(const double[:, ::1] table) noexcept nogil:
    return <const Gust*>&table[0, 0]

cpdef (double, double, double, double) dryden_scales(double height_m, double w20_m_s) noexcept nogil
cdef double _first_order(double z, double a, double noise) noexcept nogil
cdef double _second_order(double* g, int i, double h, double a, double n1, double n2) noexcept nogil
cdef (double, double, double) blow(
    double* gust, const double* noise, double height_m, double air_speed_m_s, double w20_m_s, double dt) noexcept nogil
cpdef (double, double, double) turbulence(
    double[::1] gust, const double[::1] noise, double height_m, double air_speed_m_s, double w20_m_s,
    double dt) noexcept nogil
cpdef (double, double, double) discrete(const double[:, ::1] gusts, double t) noexcept nogil
cdef (double, double, double) discrete_of(const Gust* gusts, Py_ssize_t count, double t) noexcept nogil
