cimport cython

@cython.locals(i=Py_ssize_t, fit=cython.bint)
cpdef bint all_at_least(const double[:] x, double least) noexcept nogil

@cython.locals(n=Py_ssize_t, i=Py_ssize_t, k=Py_ssize_t, ln_w_k=double, tau_k=double, start=double, top=double, ln_sum=double)
cdef void _advance(
    const double[::1] ln_v, const double[::1] tau, double at, double p, double[::1] z, double[::1] shares) noexcept nogil
