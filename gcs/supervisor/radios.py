"""The simulated radios of a session: between vehicles and the station, and among vehicles."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from gcs.link.impairment import Burst, Impairment
from gcs.link.peers.peer_radio import PeerRadio
from gcs.link.peers.place_radio import PlaceRadio
from gcs.scenario.faults import Injection
from gcs.scenario.model import Scenario, keeps_apart
from gcs.supervisor.faults import radio_faults

_SHARES = {"loss", "delay_s", "jitter_s", "duplicate", "reorder"}


class Radios(NamedTuple):
    """The radios that a scenario has."""

    station: Impairment
    """between each vehicle and the station"""
    peers: PeerRadio | None = None
    """among vehicles that compete on board"""
    places: PlaceRadio | None = None
    """on which launched vehicles receive each other's places, where they keep apart on board"""

    @classmethod
    def of(cls, scenario: Scenario, injections: Iterable[Injection]) -> Radios:
        """The radios of a scenario, with the faults that befall them."""
        injections = list(injections)
        return cls(
            make_radio(scenario, injections),
            make_peer_radio(scenario, injections),
            make_place_radio(scenario, injections),
        )

    def add(self, fault: Injection, scenario: Scenario) -> None:
        """Let another fault befall them."""
        blackouts, bursts = radio_faults([fault], scenario, own=False)
        self.station.add([*blackouts, *bursts])
        for radio in (self.peers, self.places):
            if radio is not None:
                radio.black_out(blackouts)


def make_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> Impairment:
    """The radio between vehicles and supervisor, with the faults that befall it."""
    radio = scenario.radio
    blackouts, bursts = radio_faults(injections, scenario)
    dead = [Burst(None, silence.from_s, silence.to_s, loss=1.0) for silence in radio.ground_blackouts]
    return Impairment(
        **{name: getattr(radio, name) for name in _SHARES}, bursts=[*blackouts, *dead, *bursts], seed=scenario.seed
    )


def make_peer_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> PeerRadio | None:
    """The radio among vehicles that compete on board, with the blackouts that befall it; None where they do not."""
    if scenario.competition.where == "supervisor":
        return None
    radio = scenario.radio
    return PeerRadio(
        [vehicle.sysid for vehicle in scenario.vehicles.all],
        Impairment(**{name: getattr(radio, name) for name in _SHARES}, seed=scenario.seed),
        blackouts=radio_faults(injections, scenario)[0],
        splits=radio.splits,
    )


def make_place_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> PlaceRadio | None:
    """The radio on which launched vehicles receive each other's places; None where they do not keep apart on board."""
    if not keeps_apart(scenario):
        return None
    radio = scenario.radio
    return PlaceRadio(
        [vehicle.sysid for vehicle in scenario.vehicles.launched if vehicle.real is None],
        Impairment(**{name: getattr(radio, name) for name in _SHARES}, seed=scenario.seed),
        blackouts=radio_faults(injections, scenario)[0],
        splits=radio.splits,
        traffic=bool(scenario.traffic),
    )
