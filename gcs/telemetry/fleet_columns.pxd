cimport cython
from libc.stdint cimport int64_t

from gcs.telemetry.energy cimport Account

cdef struct Facts:
    double alive  # 1 or 0
    double armed
    double steerable
    double offset_n  # m, of its own frame in the common one; NaN while unknown
    double offset_e
    double offset_d
    double turn  # rad, of that frame's axes
    double cosine
    double sine
    double ground_down  # m; NaN while unknown
    double doubted  # s, when it last reported what cannot be; -inf without

cdef enum:  # columns of gcs/telemetry/columns.py
    _IS_ALIVE, _IS_STEERABLE, _IS_FLYING, _IS_FRESH, _IS_LANDED, _IS_EMPTY

cdef enum:
    _P_NED, _V_NED, _P_NOW_NED

cdef enum:
    _AGE_S, _GROUND_DOWN_M, _REMAINING_J, _DRAWN_J, _INITIAL_J, _CAPACITY_J, _WAY_M

cdef double _LANDED_M, _STALE_S, _MODE_STALE_S, _DOUBTED_S, _LEAST_SHARE, _MOST_SHARE

cdef inline const Facts* facts_at(double[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <const Facts*>&rows[i, 0]

cdef class ColumnFiller:
    cdef double[:, ::1] _reports
    cdef double[:, ::1] _facts
    cdef Account[::1] _accounts
    cdef int64_t[::1] _seen
    cdef int64_t[::1] _changed

    cpdef bint fill(
        self, double now_s, int64_t number, unsigned char[:, ::1] flags, double[:, :, ::1] places,
        double[:, ::1] figures)
    @cython.locals(
        some=cython.bint, known=cython.bint, landed=cython.bint, doubted=cython.bint, overfull=cython.bint,
        reported=cython.bint, moded=cython.bint, alive=cython.bint, armed=cython.bint, flying=cython.bint,
        fresh=cython.bint, empty=cython.bint, now_seen=int64_t)
    cdef bint _fill(
        self, double now_s, int64_t number, unsigned char[:, ::1] flags, double[:, :, ::1] places,
        double[:, ::1] figures) noexcept nogil
