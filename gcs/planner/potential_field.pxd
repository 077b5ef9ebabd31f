from skytender.geometry cimport Shape

cdef double _FLOOR_M

cdef struct Field:  # the row of FieldConstants.constants()
    double k0
    double k1
    double a
    double b
    double attraction_range  # m
    double step  # m
    double cap  # m
    double full_steps  # 1 or 0

cdef inline const Field* field_of(const double[::1] row) noexcept nogil:
    return <const Field*>&row[0]

cdef double repulsion_size(double rho, double rho_o, const Field* field) noexcept nogil
cdef (double, double, double) repulsion_of_shape(
    const Shape* shape, double rho_o, double qn, double qe, double qd, const Field* field) noexcept nogil
cdef (double, double, double) attraction_to(
    double gn, double ge, double gd, double reach, double qn, double qe, double qd, const Field* field) noexcept nogil
