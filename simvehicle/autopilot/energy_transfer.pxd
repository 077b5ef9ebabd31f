cdef class Exchange:
    cdef public long long given_j
    cdef public long long received_j
    cdef public object current
    cdef public double ended_s
    cdef public dict neighbours
    cdef public dict _last_in
    cdef public dict _ended_orders
