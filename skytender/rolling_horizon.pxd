cimport cython

cdef enum:
    WIDTH = 64  # plans kept of each length

cdef double _SIGMA_S, _SIGMA_GROWS, _EARLY_S, _COST, _TOO_LATE_S, _SHORTEST_S, _WORTH_J, _FORESEEN_S, _WAITS_S, _ROUNDING_S

cdef double _risk(double late_s, double begin_s) noexcept nogil

cdef class _Plans:  # plans of one length; b rows of n receivers and m givers
    cdef readonly Py_ssize_t count
    cdef double[::1] cost
    cdef double[:, ::1] lands
    cdef double[:, ::1] fading
    cdef double[:, ::1] free
    cdef double[:, ::1] left
    cdef double[:, :, ::1] place
    cdef double[:, ::1] starts
    cdef long long[:, ::1] first
    cdef long long[::1] root
    cdef void copy(self, Py_ssize_t to, _Plans others, Py_ssize_t k) noexcept

cdef class _Steps:  # ways to go on from plans of one length; one entry for each
    cdef readonly Py_ssize_t count
    cdef long long[::1] parent
    cdef long long[::1] chosen
    cdef long long[::1] giver
    cdef double[::1] sets_off
    cdef double[::1] begin
    cdef double[::1] flow
    cdef double[::1] cost
    cdef readonly double[::1] score

cdef class Search:
    cdef Py_ssize_t n, m
    cdef double start_s, per_way, end_s, horizon_s, soonest_s
    cdef double[:, ::1] p
    cdef double[::1] power
    cdef double[::1] full
    cdef double[::1] wants
    cdef double[::1] speed
    cdef double[::1] rate
    cdef const unsigned char[::1] flies
    cdef const double[::1] free_at_first
    cdef unsigned char[::1] mark
    cdef _Plans plans, longer
    cdef _Steps steps
    cdef list kept
    cdef readonly double[::1] served
    cdef readonly double[::1] passed_over
    cdef readonly double least
    cdef readonly long long[::1] first
    cdef readonly double[::1] starts
    @cython.locals(rank=Py_ssize_t, which=Py_ssize_t, root=Py_ssize_t)
    cdef void _choose(self)
    cdef void _end(self, Py_ssize_t k) noexcept
    @cython.locals(waits=cython.bint, i=Py_ssize_t, t=Py_ssize_t, j=Py_ssize_t, now=double, soonest=double)
    cdef void _branch(self, Py_ssize_t k) noexcept
    cdef double _rest(self, double lands, double free) noexcept
    cdef double _foreseen(self, Py_ssize_t k, double free) noexcept
    cdef void _step(self, Py_ssize_t to, Py_ssize_t which) noexcept
