"""What a fleet's member says and takes on the wire: numbers that come back, and those that are none."""

from __future__ import annotations

import math

import pytest
from fleets import FleetInProcess, on_board
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from simvehicle.fleet.peers import ROW, DecidedBy, PeerReport, PeerStage, as_sent, report_of, row_of
from simvehicle.mavlink.codec import split

REPORT = PeerReport(
    3.5, PeerStage.CALLS, 201, True, (1.5, -2.0, -3.0), (0.5, 0.25, 0.0), 9600.0, 24000.0, 210.0, 12.0, 30.5, 2.0, -4.0,
    17, 3.25, DecidedBy.URGENCY, (1.0, 2.0, -3.0),
)  # fmt: skip


def test_a_report_survives_its_row() -> None:
    assert report_of(3.5, row_of(REPORT)) == REPORT
    assert ROW == 22


def test_a_vehicle_knows_itself_by_the_numbers_that_the_others_get() -> None:
    sent = as_sent(REPORT._replace(bid_s=0.1))
    assert sent.bid_s != 0.1
    assert sent.bid_s == pytest.approx(0.1, rel=1e-7)
    assert as_sent(sent) == sent


@pytest.mark.parametrize(("place", "value"), [(0, 9.0), (1, 256.0), (3, math.nan), (9, math.inf), (18, 7.0), (4, 1e9)])
def test_a_row_that_cannot_be_is_no_report(place: int, value: float) -> None:
    row = list(row_of(REPORT))
    row[place] = value
    assert report_of(3.5, row) is None


def test_pymavlink_reads_the_reports_and_a_stranger_on_another_link_is_not_believed() -> None:
    fleet = FleetInProcess(on_board({1: ((0.0, 0.0, -3.0), 40.0)}, {201: (0.0, 6.0, -8.0)}))
    fleet.fly(0.5)
    assert fleet.member(1).peers.fresh(fleet.now_s).get(201) is not None
    maker = mav.MAVLink(None, srcSystem=77, srcComponent=1)
    usec = 1_767_225_600_000_000 + 400_000
    data = [*row_of(REPORT), *(0.0,) * (58 - ROW)]
    raw = bytes(maker.debug_float_array_encode(usec, b"Peer", 1, data).pack(maker))
    (frame,) = split(raw)
    service = fleet.service(1)
    service.receive(frame, from_fleet=False)
    assert fleet.member(1).peers.fresh(fleet.now_s).get(77) is None
    service.receive(frame)
    assert fleet.member(1).peers.fresh(fleet.now_s).get(77) == REPORT._replace(time_s=0.4)
    assert codec.fields(codec.split(raw).frames[0]).data[:ROW] == pytest.approx(row_of(REPORT))
