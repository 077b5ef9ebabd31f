cimport cython

cdef enum:
    WINDOW = 10  # steps over which progress is judged
    TERMS = 5

cdef double GAIN, STUCK_SHARE, NEARER_M, CLEAR_STEPS, TURN_STEPS, _HALF_WIDTH
cdef int[5][5] _RULES

cdef struct Step:
    double north  # m, where it began
    double east
    double down
    double full  # m, how long it could be

cdef struct Memory:
    Step[10] steps  # WINDOW of them, a ring
    double oldest  # of them
    double count  # of those that there have been, up to WINDOW
    double engaged  # 1 while the escape is on
    double side  # 1 or -1, 0 before it is chosen
    double stuck  # steps in a row
    double quarter  # turns by 90 degrees so far, 0 to 3
    double engaged_at  # m from the goal
    double clear  # steps in a row without repulsion

cdef inline Memory* memory_at(double[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <Memory*>&rows[i, 0]

cdef Memory _memory_of(double[::1] row) noexcept nogil
cdef double _membership(double x, int term, double half_width) noexcept nogil
@cython.locals(height=double[7], knots=double[7], term=int)
cdef double _strength(double delta_phi, double delta_f) noexcept nogil
@cython.locals(nearer=bint, stuck=bint)
cdef (double, double, double) escape_force(
    Memory* memory, double qn, double qe, double qd, double gn, double ge, double gd, double on, double oe, double od,
    double goal_distance, double full_step, double arrival) noexcept nogil
@cython.locals(stuck=bint)
cdef bint _record(Memory* memory, double qn, double qe, double qd, double full_step) noexcept nogil
