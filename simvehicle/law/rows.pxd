# Rows of float64 that the flight core reads and writes, nwu axes and SI units. A field's place in its struct is its place
# in the row; rows.py gives the same places to Python.

from simvehicle.world.rows cimport Body, ERROR_SIZE, GUST_SIZE, Weather

cdef struct Guide:  # guidance.py's memory, three axes each
    double[3] q  # m
    double[3] q_rate  # m/s
    double[3] r1  # m
    double[3] r2
    double[3] r3

cdef struct GuideYaw:
    double q  # rad
    double r1
    double r2
    double r3

cdef struct Linear:  # the paper's reference
    double[3] start  # v_d at the set point's arrival, m/s
    double since_s  # time of arrival
    double stamp_s  # time_s of that set point

cdef struct State:  # the plant comes first, as dynamics.py has it
    double[3] position  # m
    double[3] velocity  # m/s
    double[3] attitude  # φ, θ, ψ in rad; ψ in [-π, π]
    double[3] rates  # of the Euler angles, rad/s
    double[3] diff_roll  # X1, X2, X3
    double[3] diff_pitch
    Guide guide
    GuideYaw guide_yaw
    Linear linear
    double[3] reference_position  # r of the state's time; the vehicle's own position where only v_d is flown
    double[3] reference_velocity  # v_d
    double[3] reference_acceleration  # v_d'
    double started  # 1 once X1 has been given its first angle
    double contact  # 1 while the vehicle stands on the ground
    double effort  # control effort
    double drawn_j
    double remaining_j

cdef struct Command:  # the last set point and what goes with it
    double[3] position  # m
    double[3] velocity  # m/s
    double time_s  # when the position held: p̂ = p + v (t - time_s); a change of it marks a new set point
    double[3] use_position  # per axis: 1 position and velocity, 0 velocity alone
    double yaw  # rad
    double motors  # 1 armed and turning, 0 off
    double ground  # 1 there is ground at z = 0, 0 there is none
    double speed_max  # m/s, cap of |v*|; the vehicle's own limit holds too
    double period_s  # time that a linear reference takes from its value at arrival to `velocity`

cdef struct Parameters:  # as params.pack lays them out
    double gravity
    double drag
    double rotational_drag
    double speed_gain
    double rate_gain
    double angle_gain
    double epsilon
    double tolerance
    double tilt_slope
    double thrust_max
    double angular_max
    double speed_max
    double acceleration_max
    double hover_w
    double avionics_w
    double shaped
    double guide_gain
    double guide_decel
    double velocity_gain
    double omega
    double reference_gain
    double yaw_rate
    double bumpless
    double literal

cdef struct RotorState:  # of a vehicle on rotors
    State known  # as the law knows it
    Body body
    double[GUST_SIZE] gust  # memory of the turbulence
    double[3] wind  # m/s
    double[ERROR_SIZE] error  # of what the law knows
    double voltage_v
    double current_a
    double capacity_j
    double[3] foreseen  # velocity of the disturbance observer, m/s
    double[3] disturbance  # m/s²

cdef inline State* state_of(double[:, ::1] rows, Py_ssize_t n) noexcept nogil:
    return <State*>&rows[n, 0]

cdef inline Command* command_of(double[:, ::1] rows, Py_ssize_t n) noexcept nogil:
    return <Command*>&rows[n, 0]

cdef inline Parameters* parameters_of(double[:, ::1] rows, Py_ssize_t n) noexcept nogil:
    return <Parameters*>&rows[n, 0]

cdef inline RotorState* rotors_of(double[:, ::1] rows, Py_ssize_t n) noexcept nogil:
    return <RotorState*>&rows[n, 0]

cdef inline const Weather* weather_of(const double[:, ::1] rows, Py_ssize_t n) noexcept nogil:
    return <const Weather*>&rows[n, 0]

cdef RotorState _rotor_state_of(double[::1] row) noexcept nogil
cdef State _state_of(double[::1] row) noexcept nogil
cdef Command _command_of(double[::1] row) noexcept nogil
cdef Parameters _parameters_of(double[::1] row) noexcept nogil
