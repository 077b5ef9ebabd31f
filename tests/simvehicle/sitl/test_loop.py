"""The loop on the supervisor's clock: when a vehicle takes its supervisor for gone."""

from __future__ import annotations

import socket
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.codec import message
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl import supervised
from simvehicle.sitl.link import SupervisedLink, parse_address
from simvehicle.sitl.loop import ConnectedUnit, run_free
from simvehicle.sitl.unit import Unit
from skytender import exit


class Clock:
    """Wall time that passes a little with every look at it, and at once where a machine keeps a process waiting."""

    def __init__(self) -> None:
        self.now_s = 0.0

    def __call__(self) -> float:
        self.now_s += 0.5
        return self.now_s


class Slow(Unit):
    """A unit that the machine does not let run for long, while its supervisor speaks on."""

    def __init__(self, clock: Clock, supervisor: socket.socket) -> None:
        self.advanced_ms: list[int] = []
        self._clock, self._supervisor = clock, supervisor
        self._writer = mav.MAVLink(None, 255, 190)

    def hello(self) -> object:
        return message("HEARTBEAT")(0, 2, 12, 0, 4, 3)

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        pass

    def receive(self, frame: Any, connection: Any) -> None:
        pass

    def advance(self, to_ms: int) -> None:
        self.advanced_ms.append(to_ms)
        self._clock.now_s += 3.0 * supervised.SILENCE_S
        if to_ms < 300:
            self.grant(to_ms + 100)

    def grant(self, t_ms: int, peer: tuple[str, int] | None = None) -> None:
        if peer is not None:
            self._supervisor.connect(peer)
        self._writer.seq = t_ms // 100
        self._supervisor.send(mav.MAVLink_system_time_message(0, t_ms).pack(self._writer))


def test_a_vehicle_that_was_kept_from_running_hears_what_waits_before_it_leaves(
    capsys: pytest.CaptureFixture[str],
) -> None:
    clock = Clock()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as supervisor:
        supervisor.bind(("127.0.0.1", 0))
        address = parse_address(f"udpout:127.0.0.1:{supervisor.getsockname()[1]}")
        with SupervisedLink(address) as link:
            unit = Slow(clock, supervisor)
            unit.grant(0, link.socket.getsockname())
            with pytest.raises(SystemExit) as left:
                supervised.run_supervised([ConnectedUnit(unit, Connection(1), ())], link, clock=clock)
    assert unit.advanced_ms == [0, 100, 200, 300]
    assert left.value.code == exit.ABANDONED
    assert "silent for 10 s" in capsys.readouterr().err


def test_a_vehicle_of_a_fork_server_waits_for_a_suspended_supervisor(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its supervisor goes on after a minute; without a fork server a vehicle would have left after ten seconds."""

    class Enough(Exception):
        pass

    class Waiting(Slow):
        def advance(self, to_ms: int) -> None:
            self.advanced_ms.append(to_ms)
            if to_ms == 100:
                raise Enough

    class Suspended(Clock):
        def __call__(self) -> float:
            if self.now_s == 150.0:
                unit.grant(100)
            return super().__call__()

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as supervisor:
        supervisor.bind(("127.0.0.1", 0))
        address = parse_address(f"udpout:127.0.0.1:{supervisor.getsockname()[1]}")
        monkeypatch.setattr(supervised, "HELLO_EVERY_S", 1e-3)
        with SupervisedLink(address) as link:
            clock = Suspended()
            unit = Waiting(clock, supervisor)
            unit.grant(0, link.socket.getsockname())
            with pytest.raises(Enough):
                supervised.run_supervised([ConnectedUnit(unit, Connection(1), ())], link, 1, clock)
    assert unit.advanced_ms == [0, 100]


class Idle:
    """A plain link on which nothing comes."""

    def __init__(self) -> None:
        self.connection = Connection(1)

    def receive(self) -> list[Any]:
        return []

    def flush(self) -> None:
        pass


def test_streams_know_how_often_they_are_looked_at() -> None:
    """At each grant, 100 ms apart here, and 50 times a second on the wall clock."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as supervisor:
        supervisor.bind(("127.0.0.1", 0))
        with SupervisedLink(parse_address(f"udpout:127.0.0.1:{supervisor.getsockname()[1]}")) as link:
            clock, own, plain = Clock(), Connection(1), Idle()
            unit = Slow(clock, supervisor)
            unit.grant(0, link.socket.getsockname())
            with pytest.raises(SystemExit):
                supervised.run_supervised([ConnectedUnit(unit, own, (plain,))], link, clock=clock)
            assert own.streams.tick_ms == plain.connection.streams.tick_ms == 100
            run_free([ConnectedUnit(unit, None, (plain,))], stop=lambda: True)
            assert plain.connection.streams.tick_ms == 20


class Machine:
    """Wall time that passes while one sleeps, later than asked, and while it keeps a process from running."""

    def __init__(self, late_s: float, **stalls_s: float) -> None:
        self.now_s, self._late_s, self._stalls_s = 1000.0, late_s, stalls_s
        self._sleeps = 0

    def clock(self) -> float:
        return self.now_s

    def sleep(self, for_s: float) -> None:
        self._sleeps += 1
        self.now_s += for_s + self._late_s + self._stalls_s.get(f"at_{self._sleeps}", 0.0)


class Living(Unit):
    """A unit that writes down its times, and when each was on the wall."""

    def __init__(self, machine: Machine, until_s: float) -> None:
        self.ticks_ms: list[int] = []
        self.behind_ms: list[float] = []
        self._machine, self._start_s, self._until_s = machine, machine.now_s, until_s

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        pass

    def advance(self, to_ms: int) -> None:
        self.ticks_ms.append(to_ms)
        self.behind_ms.append(1e3 * (self._machine.now_s - self._start_s) - to_ms)
        self._machine.now_s += 0.002

    def live(self) -> None:
        def over() -> bool:
            return self._machine.now_s - self._start_s >= self._until_s

        run_free([ConnectedUnit(self, None, ())], stop=over, clock=self._machine.clock, sleep=self._machine.sleep)


@pytest.mark.parametrize("machine", [Machine(0.0), Machine(0.004), Machine(0.012), Machine(0.0, at_30=0.095)])
def test_there_are_fifty_ticks_a_second_however_late_they_come(machine: Machine) -> None:
    unit = Living(machine, 10.0)
    unit.live()
    assert unit.ticks_ms == list(range(20, 20 * len(unit.ticks_ms) + 1, 20))
    assert len(unit.ticks_ms) in (499, 500, 501)
    assert all(-1e-6 <= behind < 100.0 for behind in unit.behind_ms)
    assert unit.behind_ms[-1] < 13.0


def test_what_a_stopped_process_missed_is_one_tick() -> None:
    unit = Living(Machine(0.001, at_50=60.0), 70.0)
    unit.live()
    gaps = [after - before for before, after in zip(unit.ticks_ms, unit.ticks_ms[1:], strict=False)]
    assert sorted(set(gaps)) == [20, 60_000]
    assert gaps.count(60_000) == 1
    assert unit.behind_ms[-1] < 20.0


def test_a_machine_that_is_too_slow_is_behind_by_no_more_than_is_caught_up_with() -> None:
    machine = Machine(0.0)
    unit = Living(machine, 10.0)
    advance = unit.advance

    def slow(to_ms: int) -> None:
        advance(to_ms)
        machine.now_s += 0.033

    unit.advance = slow  # type: ignore[method-assign]
    unit.live()
    assert max(unit.behind_ms) <= 100.0
    assert unit.ticks_ms[-1] > 9800


def test_a_hello_carries_the_secret_of_the_fork_server() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as supervisor:
        supervisor.bind(("127.0.0.1", 0))
        with SupervisedLink(parse_address(f"udpout:127.0.0.1:{supervisor.getsockname()[1]}")) as link:
            unit = Slow(Clock(), supervisor)
            supervised.Granted(unit, Connection(1), (), 0xFEDC_BA98_7654_3210, False).look(0.0, link)
            (_, time) = mav.MAVLink(None).parse_buffer(supervisor.recv(2048))
    assert time.time_unix_usec == 0xFEDC_BA98_7654_3210
