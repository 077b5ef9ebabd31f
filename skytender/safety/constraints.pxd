# Rows that the safety filter's functions share. Frames NED, SI units.

from skytender.geometry cimport Shape

cdef struct Moves:  # of n vehicles: places, velocities and accelerations of the coming period (n, 3), brakes and limits of speed (n,)
    const double* p
    const double* v
    const double* u
    const double* brake
    const double* v_max

cdef struct Other:  # that gives no way; a row of 9
    double[3] p
    double[3] v
    double radius
    double growth
    double agile

cdef struct Surroundings:  # what vehicles keep away from
    const Other* others
    const Shape* shapes
    const double* walls  # (n, 6)
    double dt
    double horizon

cdef struct Constraint:
    double[3] a  # A_i of the linear constraint  A_i·u_i + A_j·u_j >= r
    double[3] b  # A_j
    double r
    double square  # |A|²
    double weight  # of the line in the projection
    double target  # aimed at, m
    double least  # kept whatever is wanted, m
    double required  # m
    double[3] leave  # direction in which a vehicle leaves what turns; zero: straight away from it
    long long kind
    long long i  # the vehicle
    long long j  # with what
    bint near  # the line takes part
    bint short  # of its least

cdef struct Constraints:  # a list in order of kind, vehicle and with what, that grows; its user frees `rows`
    Constraint* rows
    Py_ssize_t count
    Py_ssize_t room

cdef struct Near:  # what vehicles may come near to, and how near
    Py_ssize_t n
    const double* p  # (n, 3)
    const double* v
    const double* v_max
    const double* a_max
    const double* brake
    const double* margin
    const double* spread
    const unsigned char* beyond
    const double* walls  # (n, 6)
    const Other* others
    Py_ssize_t others_count
    const Shape* shapes
    Py_ssize_t shapes_count
    const double* pairs  # rows (i, j, m), i < j
    Py_ssize_t pairs_count
    const double* singles  # rows (vehicle, other, m)
    Py_ssize_t singles_count
    bint apart
    double separation
    double clearance
    double buffer
    double dt
    double horizon

cdef struct Box:  # around a shape
    double[3] low
    double[3] high
    Py_ssize_t j
    bint wall

cdef struct Rules:  # of the filter, as FilterSettings has them
    double separation
    double clearance
    double brake_share
    double dt
    double horizon
    double buffer
    double recover
    double turn
    double climb
    int rounds
    int sweeps
    bint apart

cdef struct Leader:  # what is found out of one
    double[6] corrected  # by both balls of the projection
    double v_top
    double share  # of its wanted velocity that cannot be had
    double leaves  # share of its wish that is leaving what turns
    double[3] leave
    double pull  # of the constraint that binds it most
    long long group  # of those that near constraints join
    long long cause  # constraint that turned or braked it; -1: none
    bint live  # a near constraint concerns it
    bint concerned
    bint moved
    bint worse

cdef struct Problem:
    Py_ssize_t n
    const double* p  # (n, 3), as all that have three axes
    const double* v
    const double* wanted
    const double* v_max
    const double* a_max
    const double* brake
    const long long* ids
    const double* u_b  # braking
    Leader* leaders
    Constraint* constraints
    Py_ssize_t count  # of them
    Surroundings around
    Rules rules
