cimport cython
from simvehicle.autopilot.body cimport Body
from simvehicle.autopilot.energy_transfer cimport Exchange

cdef struct SetPoint:  # of offboard control
    double[3] p_ned  # m
    double[3] v_ned  # m/s
    bint[3] use_position  # axes on which a position counts beside the velocity
    bint place_alone  # whether no velocity was given
    double yaw_ned  # rad; of yaw and yaw rate at most one is a number, and without one the yaw stays
    double yaw_rate  # rad/s
    double time_s  # NaN: there is none

cdef object _OFFBOARD, _REFUEL, _GUIDED

cdef class Vehicle(Body):
    cdef readonly object identity
    cdef readonly object frame
    cdef const double* origin  # of `frame`: latitude, longitude, height, degrees per metre north and east
    cdef double[3] home  # NED, m
    cdef public bint home_locked  # whether it stays where it is when the vehicle is armed
    cdef public long long unix_epoch_us
    cdef public object mode
    cdef public bint armed
    cdef readonly object intended  # the mode that the last order brought, or its end
    cdef readonly Exchange exchange
    cdef public object mission
    cdef object _fence
    cdef bint _fenced
    cdef public object rally_ned
    cdef readonly set failed
    cdef public bint booting
    cdef readonly list announcements
    cdef public object on_change
    cdef readonly double gcs_seen_s  # NaN: never
    cdef public unsigned char gcs_main  # system id of the ground station that owns it; 0: none does
    cdef public bint takeover_allowed  # whether another is given control that asks for it
    cdef readonly SetPoint set_point_now
    cdef SetPoint set_point_before
    cdef public bint station_leads  # whether the last set point is the station's
    cdef public object separation  # what keeps it apart while it flies by itself; None: nothing
    cdef public double period_s  # from one of the station's set points to the next
    cdef readonly bint ordered  # whether an order, not a failsafe, brought the mode
    cdef readonly bint in_failsafe  # whether a failsafe, and no order since, brought it here
    cdef public bint leads  # whether it has a virtual leader of its own,
    cdef double[9] leader  # its place, velocity, and the acceleration that it wants, NED
    cdef double gcs_loss_s
    cdef double set_point_loss_s
    cdef double fastest_m_s
    cdef double floor_j
    cdef bint _breached
    cdef object _followed
    cdef object _return_ned
    cdef object _anchor
    cdef object _leg  # of a return; None: as it is high
    cdef object _plan  # timetable of a return; None: at once
    cdef double _began_s  # to return
    cdef double _over_home_s  # when a return came there; NaN: not yet
    cdef double _granted_s  # when the present flight began
    cdef double _takeoff_down_m
    cdef readonly double yaw_ned

    cpdef bint trigger(self, object event) except -1
    cpdef bint outside(self) except -1
    cpdef arming_refusal(self)
    cdef take_set_point(self, const SetPoint* wanted)
    cpdef receive_gcs_heartbeat(self)
    cpdef receive_gcs_command(self)
    cpdef bint setpoints_fresh(self)
    cpdef advance(self, long long to_ms)
    cdef double voltage_v(self)
    cdef double current_a(self)
    cdef int percent(self)
    cdef double shown_j(self)
    @cython.locals(follows=cython.bint)
    cpdef lead_of_set_points(self, double period_s)
    cpdef put_leader(self, tuple row)
    cpdef bint alone(self, double for_s)
    cpdef double returning_s(self)
    cpdef mode_target(self)
    @cython.locals(steered=cython.bint, led=cython.bint)
    cdef bint _keeps_apart(self) except -1
    cdef _fly(self, Py_ssize_t steps)
    cdef _steer(self, double dt_s)
    cdef _progress(self)
    @cython.locals(low=cython.bint, there=cython.bint)
    cdef _progress_return(self, object p_ned)
    @cython.locals(over=cython.bint, flown_s=double)
    cdef _leg_of(self, object plan, object p_ned)
    cdef _progress_mission(self, object p_ned)
    cdef _check_failsafes(self)
    cdef _hold_guided(self)
    cdef bint _fence_crossed(self)
    cdef bint battery_low(self)
    cdef _apply(self, object rule)
    cdef _enter(self, object mode)
    cdef _move_joules(self, double dt_s)
    cdef _settle(self, object order)
