from libc.stdint cimport int64_t

cdef _match(
    const double[:, ::1] cost, double[::1] row_price, double[::1] column_price, int64_t[::1] column_of,
    int64_t[::1] row_of, int64_t[::1] before, int64_t[::1] left, int64_t[::1] reached, double[::1] way)
