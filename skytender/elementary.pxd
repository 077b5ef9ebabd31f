cimport cython

cdef enum:
    TOGETHER = 4  # numbers of `sin_cos_of_each` and `pow_of_each`

cdef long long _FRACTION, _ONE, _FIRST_BITS
cdef double _LEAST_NORMAL, _ROUND, _FAR, _TINY, _STEPS, _TWO_OVER_PI, _STEPS_OVER_LN_2, _LN_2, _INVERSE_LN_2, _TWO_PI, _PI, _PI_REST
cdef double _PI_HALVES_1, _PI_HALVES_2, _PI_HALVES_3, _LN_2_1, _LN_2_2, _STEP_1, _STEP_2

cdef double[128] _POWER
cdef double[128] _POWER_REST
cdef double[129] _INVERSE
cdef double[129] _LOG
cdef double[129] _LOG_REST
cdef double[17] _ARCTANGENT
cdef double[17] _ARCTANGENT_REST

cdef void _fill()
cdef (double, double, int) _reduced(double x) noexcept nogil
cdef double _sine_near_0(double r, double rest) noexcept nogil
cdef double _cosine_near_0(double r, double rest) noexcept nogil
cpdef (double, double) sin_cos(double x) noexcept nogil
cdef void sin_cos_of_each(const double* x, double* sines, double* cosines) noexcept nogil
cpdef double sin(double x) noexcept nogil
cpdef double cos(double x) noexcept nogil
cpdef double tan(double x) noexcept nogil
cdef double _grown(double u) noexcept nogil
cdef double _scaled(double x, long long exponent) noexcept nogil
cpdef double exp(double x) noexcept nogil
cpdef double expm1(double x) noexcept nogil
cpdef double log(double x) noexcept nogil
cpdef double pow(double x, double y) noexcept nogil
cdef void pow_of_each(const double* x, const double* y, double* made) noexcept nogil
cdef double _limit_of_pow(double x, double y) noexcept nogil
cpdef double atan2(double y, double x) noexcept nogil
cpdef double atan(double x) noexcept nogil
cpdef double asin(double x) noexcept nogil
cpdef double hypot(double x, double y) noexcept nogil

@cython.locals(square=double, part=double, k=Py_ssize_t)
cpdef double norm(object vector) except? -1.0
@cython.locals(square=double, part=double, k=Py_ssize_t)
cpdef double distance(object a, object b) except? -1.0
