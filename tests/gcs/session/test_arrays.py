"""Snapshots as arrays: what numpy and pandas get."""

from __future__ import annotations

import sys
from typing import Any

import msgspec
import numpy as np
import pandas as pd
import pytest

from gcs.extras import MissingExtra
from gcs.session.arrays import Snapshot, from_message
from gcs.session.message_types import EventRow, ServiceRow
from gcs.session.program.messages import FleetMessage


def vehicle(sysid: int, **changed: Any) -> dict[str, Any]:
    told = {"sysid": sysid, "role": "pursuer", "mode": "mission", "mode_name": "AUTO", "alive": True, "armed": True}
    told |= {"p_ned": [1.0, 2.0, -3.0], "v_ned": [0.5, 0.0, 0.0], "target_m": 2.0, "battery": 0.5}
    told |= {"attitude_rad": [0.1, 0.2, 3.0], "age_s": 0.1, "heard_s": 0.0, "lost_share": 0.25, "trouble": []}
    told |= {"set_point_p_ned": [1.5, 2.0, -3.0], "set_point_v_ned": [1.0, 0.0, 0.0]}
    return {**told, "remaining_j": 1e4, "endurance_s": 50.0, "v": 0.3, "tau": 1.0, **changed}


def snapshot(*vehicles: dict[str, Any]) -> Snapshot:
    event = EventRow(4.0, 2, "info", "Armed", "text")
    service = ServiceRow(1, 201, None, "join", 7.0, "policy", 1.0, None, None, {}, "")
    columns = {key: [one[key] for one in vehicles] for key in vehicle(1)}
    message = FleetMessage(t_s=4.5, services=[service], refuelled=3, events=[event], acknowledged=[], **columns)
    return from_message(msgspec.json.decode(msgspec.json.encode(message), type=FleetMessage))


def test_unknown_values_are_nan_and_shapes_hold() -> None:
    unknown: dict[str, Any] = dict.fromkeys(("target_m", "endurance_s", "v", "tau"))
    unknown |= {"p_ned": [np.nan] * 3, "set_point_p_ned": [None] * 3, "trouble": ["dead", "battery 3 %"]}
    seen = snapshot(vehicle(1), vehicle(7, **unknown))
    assert seen.p_ned.shape == seen.v_ned.shape == (2, 3)
    assert seen.p_ned[0].tolist() == [1.0, 2.0, -3.0]
    assert np.isnan(seen.p_ned[1]).all()
    assert np.isnan([seen.target_m[1], seen.endurance_s[1], seen.v[1], seen.tau[1]]).all()
    assert np.isnan(seen.set_point_p_ned).tolist() == [[False] * 3, [True] * 3]
    assert seen.attitude_rad[1].tolist() == [0.1, 0.2, 3.0]
    assert seen.trouble == ((), ("dead", "battery 3 %"))
    assert seen.table()["trouble"].tolist() == ["", "dead; battery 3 %"]
    assert seen.row(7) == 1
    with pytest.raises(KeyError):
        seen.row(8)
    assert (seen.services[0].tanker, seen.events[0].text, seen.refuelled) == (201, "Armed", 3)


def test_a_frame_has_a_row_per_vehicle_and_frames_of_a_session_can_be_put_together() -> None:
    frame = snapshot(vehicle(1), vehicle(2, battery=0.25)).frame()
    assert list(frame["sysid"]) == [1, 2]
    assert frame.loc[frame.sysid == 2, "battery"].item() == 0.25
    assert frame["p_d"].tolist() == [-3.0, -3.0]
    assert (frame["yaw_rad"][0], frame["set_point_v_n"][1], frame["lost_share"][0]) == (3.0, 1.0, 0.25)
    both = pd.concat([frame, snapshot(vehicle(1)).frame()], ignore_index=True)
    assert both.shape == (3, frame.shape[1])
    assert both["battery"].dtype == np.float64


def test_no_vehicle_is_an_empty_table() -> None:
    assert snapshot().p_ned.shape == (0, 3)
    assert len(snapshot().frame()) == 0


def test_without_pandas_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingExtra, match=r"pip install '\.\[pandas\]'"):
        snapshot(vehicle(1)).frame()
