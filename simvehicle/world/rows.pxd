# Rows of float64 of the world: axes nwu for it and flu for a body, SI units. rows.py gives the places to Python.

cdef struct Body:
    double[3] position  # m
    double[3] velocity  # m/s
    double[4] quaternion  # w, x, y, z, from flu to nwu
    double[3] rates  # about the body's axes, rad/s
    double[4] rotors  # speeds, rad/s

cpdef enum:
    MOVING = 13  # numbers of a Body before its rotors: those that are integrated
    GUST_SIZE = 5
    GUST_NOISE = 5
    ERROR_SIZE = 12

cdef struct AirframeRow:  # as airframes.pack lays it out
    double mass
    double gravity
    double ix
    double iy
    double iz
    double thrust
    double torque
    double rotor_drag
    double inflow_drag
    double[3] body_drag
    double fastest
    double lag
    double area
    double density
    double[4] x
    double[4] y
    double[4] spin
    double[16] allocation  # 4 x 4, row by row: the rotors' thrusts of total thrust and three moments
    double radius
    double profile
    double hover_w

cdef struct Gust:  # a discrete one
    double at
    double rise
    double hold
    double x
    double y
    double z

cdef struct Weather:  # of a vehicle, and how well it knows its motion
    double[3] mean  # m/s
    double[2] along  # unit vector of the mean wind, north and west
    double w20  # m/s at 20 ft, which sets the turbulence
    double[4] deviation  # of the estimate: position, velocity, angles, rates
    double[4] time_s
    double ohm  # inner resistance of the battery

cdef Body _body_of(double[::1] row) noexcept nogil
cdef AirframeRow _airframe_of(double[::1] row) noexcept nogil
cdef Gust _gust_of(double[::1] row) noexcept nogil
cdef Weather _weather_of(double[::1] row) noexcept nogil
