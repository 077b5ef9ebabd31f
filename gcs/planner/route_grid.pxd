cimport cython

from gcs.planner.search cimport Front

cdef int _STRAIGHT, _SLANT, _CORNER
cdef long long _CELL

@cython.locals(a=Py_ssize_t[3], b=Py_ssize_t[3], at=double, axis=int, n=Py_ssize_t, e=Py_ssize_t, d=Py_ssize_t)
cdef void _rasterise(
    const double[:, ::1] table, const double[:, ::1] low, const double[:, ::1] high, float[:, :, ::1] distance,
    const double[::1] first, double cell_m, double wanted_m, double thicker_m) noexcept nogil
@cython.locals(
    part=int[::1], lower=int[::1], count=int, number=int, other=int, met=int, final=int, cell=Py_ssize_t,
    back=Py_ssize_t[3], axis=int)
cdef _connected_parts(const unsigned char[::1] weight, Py_ssize_t row, Py_ssize_t layer)
cdef long long _estimate(long long dn, long long de, long long dd) noexcept nogil
cdef void _edge(long long* free, int i, int j) noexcept nogil
cdef void _corner(long long* free, int i, int j, int d) noexcept nogil
@cython.locals(blocked=int, k=int, s=int, t=int)
cdef void _allowed(
    const unsigned char* weight, Py_ssize_t cell, const long long* around, long long* free) noexcept nogil
@cython.locals(k=int, n=int, e=int, d=int, axes=int)
cdef void _moves(Py_ssize_t stride_n, Py_ssize_t stride_e, long long* around, long long* costs) noexcept nogil
cdef void _push(long long* heap, Py_ssize_t size, long long key) noexcept nogil
@cython.locals(at=Py_ssize_t, child=Py_ssize_t)
cdef long long _pop(long long* heap, Py_ssize_t size) noexcept nogil
@cython.locals(
    f=cython.longlong, heap=cython.longlong[::1], stride_n=Py_ssize_t, stride_e=Py_ssize_t, start_n=Py_ssize_t,
    start_e=Py_ssize_t, start_d=Py_ssize_t, cell=Py_ssize_t, n=Py_ssize_t, e=Py_ssize_t, d=Py_ssize_t, i=Py_ssize_t)
cdef _keyed(
    const long long[::1] open_cells, const int[::1] cost, Py_ssize_t count_e, Py_ssize_t count_d, Py_ssize_t start)
@cython.locals(
    heap=cython.longlong[::1], seen=cython.longlong[::1], stride_n=Py_ssize_t, stride_e=Py_ssize_t,
    found=cython.bint)
cdef _settle(
    const unsigned char[::1] weight, Py_ssize_t count_e, Py_ssize_t count_d, int[::1] cost,
    const long long[::1] keys, Py_ssize_t start, long long most)
@cython.locals(
    heap=cython.p_longlong, seen=cython.p_longlong, around=cython.p_longlong, moves=cython.p_longlong,
    size=Py_ssize_t, met=Py_ssize_t, settled=cython.longlong, limit=cython.longlong, own=cython.longlong,
    known=cython.longlong, new=cython.longlong, here=cython.longlong, free=cython.longlong[27], stride_n=Py_ssize_t,
    stride_e=Py_ssize_t, count_e=Py_ssize_t, start=Py_ssize_t, start_n=Py_ssize_t, start_e=Py_ssize_t,
    start_d=Py_ssize_t, cell=Py_ssize_t, other=Py_ssize_t, n=Py_ssize_t, e=Py_ssize_t, d=Py_ssize_t, k=int, dn=int,
    de=int, dd=int, ended=cython.bint)
cdef bint _advance(Front* front, const unsigned char* weight, int* cost, long long most) noexcept nogil
@cython.locals(
    around=cython.longlong[27], moves=cython.longlong[27], free=cython.longlong[27], cell=Py_ssize_t,
    other=Py_ssize_t, following=Py_ssize_t, k=int)
cdef _descend(
    const unsigned char[::1] weight, Py_ssize_t count_e, Py_ssize_t count_d, const int[::1] cost, Py_ssize_t start,
    Py_ssize_t goal)
@cython.locals(
    counts=Py_ssize_t[3], at=double[3], low=Py_ssize_t[3], high=Py_ssize_t[3], axis=int, wide=Py_ssize_t,
    nearest=Py_ssize_t, best=double, square=double, cell=Py_ssize_t, n=Py_ssize_t, e=Py_ssize_t, d=Py_ssize_t)
cdef Py_ssize_t _nearest(
    const unsigned char[::1] weight, const int[::1] parts, Py_ssize_t count_n, Py_ssize_t count_e, Py_ssize_t count_d,
    double north, double east, double down, int part, int dearest) noexcept nogil
