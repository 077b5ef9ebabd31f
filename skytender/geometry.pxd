cimport cython

cpdef enum:  # kinds of shapes
    POINT
    SPHERE
    BOX
    CYLINDER
    WALL

cdef double FAR_M, _NO_DIRECTION_M

cdef struct Shape:  # a row of a table, m, NED
    double kind
    double north
    double east
    double down
    double size_1
    double size_2
    double size_3

cdef inline const Shape* shape_at(const double[:, ::1] table, Py_ssize_t i) noexcept nogil:
    return <const Shape*>&table[i, 0]

cdef inline double* row_of(double[:, ::1] table, Py_ssize_t i) noexcept nogil:
    return &table[i, 0]

@cython.locals(low_rows=double[:, ::1], high_rows=double[:, ::1])
cpdef bounds(const double[:, ::1] table)
cdef void write_bounds(const Shape* shape, double* low, double* high) noexcept nogil
cdef (double, double, double, double) shape_surface(const Shape* shape, double qn, double qe, double qd) noexcept nogil
cdef (double, double, double, double) _box_surface(
    double dn, double de, double dd, double hn, double he, double hd) noexcept nogil
cdef (double, double, double, double) _cylinder_surface(
    double dn, double de, double dd, double radius, double half_height) noexcept nogil
cdef (double, double, double) _wall_surface(double dn, double de, double hn, double he) noexcept nogil
cpdef (double, double, double, double) way_past_wall(
    const double[:, ::1] table, Py_ssize_t i, const double[::1] start_ne, const double[::1] end_ne) noexcept nogil
cdef (double, double, double, double) past_wall(
    const Shape* shape, double n0, double e0, double n1, double e1) noexcept nogil
cpdef void fill_clearances(
    const double[:, ::1] table, const double[:, ::1] at, double[::1] least, double[::1] reach) noexcept nogil
cdef void fill_reach(const double[:, ::1] table, double[::1] reach) noexcept nogil
cdef double clearance_at(
    const double[:, ::1] table, const double[::1] reach, double qn, double qe, double qd) noexcept nogil
