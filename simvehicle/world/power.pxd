from simvehicle.world.rows cimport AirframeRow

cpdef enum:
    CELLS = 4

cdef double _FLATTEST, _INDUCED_FACTOR
cdef int _MOST_EVALUATIONS

cpdef double induced_speed(
    double thrust_n, double across_m_s, double along_m_s, double area_m2, double density_kg_m3) noexcept nogil
cdef double rotor_power(
    double thrust_n, const double* speeds, double across_m_s, double along_m_s, const AirframeRow* a) noexcept nogil
cpdef double shaft_power(
    double thrust_n, const double[::1] speeds, double across_m_s, double along_m_s,
    const double[::1] airframe) noexcept nogil
cpdef double cell_v(double charge) noexcept nogil
cpdef (double, double, double) discharge(double power_w, double charge, double resistance_ohm) noexcept nogil
