"""Skytender's own competition and policies, asked with what a session's supervisor would know.

Vehicles are where the instance says, and services take what they take in it: setup and way. A session's tankers fly
towards a likely winner while the competition is undecided; here they wait.
"""

from __future__ import annotations

import numpy as np

from gcs.benchmark.arrays import Arrays
from gcs.benchmark.peers.flight import FULL, WANTS_FROM, DispatchedFlight
from gcs.mavlink.autopilots import PX4, FlightMode
from gcs.refuelling.giver import Giver, ServiceTimes
from gcs.refuelling.loss_bidding import LossBidding
from gcs.refuelling.policies import Optimal, RefuellingRequest
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView

SPEED_OVER_S = 0.1


class _Own:
    def __init__(self, arrays: Arrays) -> None:
        shares = [one.lands_at_j / one.capacity_j for one in arrays.instance.receivers]
        self.competition = CompetitionRules(need_from=1.0 - WANTS_FROM)
        self.refuelling = RefuellingRules(rate_w=arrays.rate_w, until=FULL, lands_at=shares[0] if shares else 0.0)
        self.times = ServiceTimes(arrays.setup_s, 1.0, 0.0)
        self._arrays = arrays

    def view(self, flight: DispatchedFlight, i: int) -> VehicleView:
        """A receiver as its messages would show it."""
        arrays, one = self._arrays, self._arrays.instance.receivers[i]
        here, next_ = arrays.at(i, flight.now_s), arrays.at(i, flight.now_s + SPEED_OVER_S)
        above_j = max(float(arrays.power_w[i] * (flight.lands_s[i] - flight.now_s)), 0.0)
        return _view(one.id, "pursuer", _vec(here), _vec((next_ - here) / SPEED_OVER_S), one.capacity_j,
                     one.lands_at_j + above_j, one.power_w)  # fmt: skip

    def tanker(self, flight: DispatchedFlight, t: int) -> VehicleView:
        """A tanker."""
        one = self._arrays.instance.tankers[t]
        place = _vec(flight.place_ned[t])
        return _view(one.id, "tanker", place, (0.0, 0.0, 0.0), one.capacity_j, one.capacity_j, one.power_w)

    def givers(self, flight: DispatchedFlight) -> list[Giver]:
        """Tankers that can give, busy ones too."""
        return [
            Giver(
                one.id, _vec(flight.place_ned[t]), max(float(flight.free_s[t]) - flight.now_s, 0.0), one.speed_m_s,
                float(flight.spare_j[t]), self._arrays.rate_w,
            )
            for t, one in enumerate(self._arrays.instance.tankers)
            if t in flight.free or flight.free_s[t] > flight.now_s
        ]  # fmt: skip

    def by_index(self, pairs: dict[int, int]) -> dict[int, int]:
        """Indices instead of system ids."""
        one = self._arrays.instance
        tankers = {tanker.id: t for t, tanker in enumerate(one.tankers)}
        receivers = {receiver.id: i for i, receiver in enumerate(one.receivers)}
        return {tankers[t]: receivers[i] for t, i in pairs.items()}


class PlannedAhead(_Own):
    """The policy `optimal`: services of all tankers planned ahead."""

    def __init__(self, arrays: Arrays) -> None:
        super().__init__(arrays)
        self._policy = Optimal(self)  # type: ignore[arg-type] # of a scenario it reads `competition` alone

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        tankers = tuple(self.tanker(flight, t) for t in flight.free)
        later = tuple(self.view(flight, i) for i in flight.flying() if i not in flight.waiting)
        request = RefuellingRequest(
            flight.now_s, tankers[0], tuple(self.view(flight, i) for i in flight.waiting), tankers,
            {one.id: one.speed_m_s for one in self._arrays.instance.tankers}, self.refuelling,
            tuple(self.givers(flight)), later, self.times, self._arrays.horizon_s - flight.now_s,
        )  # fmt: skip
        return self.by_index(self._policy.assign(request))


class WinnerTakeAll(_Own):
    """The competition, with bids by losses."""

    def __init__(self, arrays: Arrays) -> None:
        super().__init__(arrays)
        self._bidding = LossBidding(self.competition, self.refuelling, arrays.horizon_s)

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        views = tuple(self.view(flight, i) for i in flight.flying())
        snapshot = FleetSnapshot(flight.now_s, views, ())
        givers = self.givers(flight)
        self._bidding.advance(snapshot, (), givers, self.times)
        found: dict[int, int] = {}
        for award in self._bidding.awards(snapshot, [giver for giver in givers if giver.free_in_s == 0.0]):
            self._bidding.award(award.receiver, flight.now_s)
            found[int(award.giver.name)] = award.receiver
        return self.by_index(found)


def _vec(place: np.ndarray) -> Vec3:
    return (float(place[0]), float(place[1]), float(place[2]))


def _view(
    sysid: int, role: str, p_ned: Vec3, v_ned: Vec3, capacity_j: float, held_j: float, power_w: float
) -> VehicleView:
    return VehicleView(
        sysid=sysid, role=role, label=f"{role} {sysid}", alive=True, profile=PX4, mode=FlightMode.OFFBOARD, armed=True,
        landed=False, last_received_s=0.0, p_ned=p_ned, v_ned=v_ned, age_s=0.0, heading_rad=0.0,
        origin_offset_ned=(0.0, 0.0, 0.0), ground_amsl_m=0.0, capacity_j=capacity_j, initial_j=held_j,
        battery_reported=True, drawn_j=0.0, received_j=0, given_j=0, given_reported_s=0.0, power_w=power_w,
        energy_source="", control_effort=0.0,
    )  # fmt: skip
