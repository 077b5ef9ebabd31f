"""Return parameters of one vehicle, tick by tick: its answers are pymavlink's frames."""

from __future__ import annotations

import math
import struct
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav
from views import view

from gcs.mavlink import codec
from gcs.mavlink.autopilots import ARDUCOPTER, ARDUPLANE, PX4, Profile
from gcs.planner.foreign_returns import ForeignReturn
from gcs.supervisor.return_setting import ReturnSetting

INT32, REAL32 = mav.MAV_PARAM_TYPE_INT32, mav.MAV_PARAM_TYPE_REAL32
PLAN = ForeignReturn(height_m=7.4, begins_after_s=10.0, waits_s=31.5, holds_after_s=0.5)
OLD = {"RTL_ALT": (1500, INT32), "RTL_CLIMB_MIN": (0, INT32)}
NEW = {"RTL_ALT_M": (15.0, REAL32), "RTL_CLIMB_MIN_M": (0.0, REAL32)}
COPTER = {
    "RTL_CONE_SLOPE": (3.0, REAL32), "RTL_LOIT_TIME": (5000, INT32), "FS_GCS_ENABLE": (0, INT32),
    "FS_GCS_TIMEOUT": (5.0, REAL32), "GUID_TIMEOUT": (3.0, REAL32),
}  # fmt: skip
OF_PX4 = {
    "RTL_RETURN_ALT": (60.0, REAL32), "RTL_CONE_ANG": (45, INT32), "RTL_DESCEND_ALT": (30.0, REAL32),
    "RTL_LAND_DELAY": (0.0, REAL32), "NAV_DLL_ACT": (0, INT32), "COM_DL_LOSS_T": (10, INT32),
    "COM_OF_LOSS_T": (1.0, REAL32), "COM_OBL_RC_ACT": (0, INT32),
}  # fmt: skip


class Talk:
    """A vehicle that answers, and the setting; unknown names are not answered, as of autopilots."""

    def __init__(self, has: dict[str, tuple[float, int]], profile: Profile, **options: Any) -> None:
        options.setdefault("external", True)
        self.setting = ReturnSetting(3, PLAN, options.pop("given", ()), **options)
        self.locked = set[str]()
        self.mute = False
        self.numbers = {name: number for name, (number, _) in has.items()}
        self._kinds = {name: kind for name, (_, kind) in has.items()}
        self.profile, self.now_s, self.set_names = profile, 0.0, list[str]()

    def go_on(self, for_s: float, ground_down_m: float | None = 0.0, *, back: bool = False) -> None:
        for _ in range(round(10 * for_s)):
            self.now_s += 0.1
            seen = view(3, profile=self.profile, ground_down_m=ground_down_m)
            setting = self.setting
            for message in setting.poll_back(self.now_s) if back else setting.poll(seen, self.now_s):
                self._answer(message)

    def _answer(self, message: codec.Message) -> None:
        asked = dict(zip(codec.layout(codec.name(message.msgid)).record._fields, message.values, strict=True))
        name = asked["param_id"]
        if self.mute or name not in self.numbers:
            return
        kind = self._kinds[name]
        if "param_value" in asked:
            self.set_names.append(name)
            if name not in self.locked:
                self.numbers[name] = self._number(asked["param_value"], kind)
        number = self.numbers[name]
        bytewise = self.profile.integers_bytewise and kind == INT32
        wire = struct.unpack("<f", struct.pack("<i", int(number)))[0] if bytewise else number
        said = mav.MAVLink_param_value_message(name.encode(), wire, kind, 900, 65535)
        (frame,) = codec.split(bytes(said.pack(mav.MAVLink(None, 3, 1)))).frames
        self.setting.receive("PARAM_VALUE", codec.fields(frame), self.now_s)

    def _number(self, wire: Any, kind: int) -> float:
        if self.profile.integers_bytewise and kind == INT32:
            raw = wire.raw if hasattr(wire, "raw") else struct.pack("<f", wire)
            return float(struct.unpack("<i", raw)[0])
        return float(wire)


COPTER_WANTED = {"RTL_CONE_SLOPE": 0, "RTL_LOIT_TIME": 32000, "FS_GCS_ENABLE": 1, "FS_GCS_TIMEOUT": 10}


@pytest.mark.parametrize(
    ("has", "profile", "wanted"),
    [
        (OLD | COPTER, ARDUCOPTER, {"RTL_ALT": 740, "GUID_TIMEOUT": 0.5} | COPTER_WANTED),
        (NEW | COPTER, ARDUCOPTER, {"RTL_ALT_M": 7.4, "GUID_TIMEOUT": 0.5} | COPTER_WANTED),
        (
            OF_PX4,
            PX4,
            {"RTL_RETURN_ALT": 7.4, "RTL_CONE_ANG": 0, "RTL_DESCEND_ALT": 7.4, "RTL_LAND_DELAY": 32, "NAV_DLL_ACT": 2,
             "COM_DL_LOSS_T": 10, "COM_OF_LOSS_T": 0.5, "COM_OBL_RC_ACT": 5},
        ),
    ],
    ids=["4.6", "4.7", "PX4"],
)  # fmt: skip
def test_each_generation_is_set_and_put_back(
    has: dict[str, tuple[float, int]], profile: Profile, wanted: dict[str, float]
) -> None:
    talk = Talk(has, profile)
    talk.go_on(5.0)
    assert talk.setting.verdict == (True, "return height 7.4 m set and read back")
    assert {name: talk.numbers[name] for name in wanted} == pytest.approx(wanted)
    talk.setting.put_back(profile)
    talk.go_on(3.0, back=True)
    assert talk.numbers == {name: number for name, (number, _) in has.items()}
    assert talk.setting.kept() == []
    assert not talk.setting.putting_back


def test_heights_count_from_a_home_that_lies_lower() -> None:
    talk = Talk(NEW | COPTER, ARDUCOPTER)
    talk.go_on(5.0, ground_down_m=2.0)
    assert talk.numbers["RTL_ALT_M"] == pytest.approx(9.4)


def test_a_home_that_is_not_reported_is_waited_for_and_then_taken_for_height_0() -> None:
    talk = Talk(NEW | COPTER, ARDUCOPTER)
    talk.go_on(9.0, ground_down_m=None)
    assert talk.set_names == []
    talk.go_on(5.0, ground_down_m=None)
    assert talk.numbers["RTL_ALT_M"] == pytest.approx(7.4)


def test_what_it_does_not_have_is_named_but_a_height_it_needs() -> None:
    few = Talk(NEW | {"FS_GCS_ENABLE": (0, INT32)}, ARDUCOPTER)
    few.go_on(8.0)
    text = (
        "return height 7.4 m set and read back (it has no RTL_CONE_SLOPE, RTL_LOIT_TIME, FS_GCS_TIMEOUT, GUID_TIMEOUT)"
    )
    assert few.setting.verdict == (True, text)
    none = Talk(COPTER, ARDUCOPTER)
    none.go_on(8.0)
    assert none.setting.verdict == (False, "return height not set: it has no RTL_ALT_M or RTL_ALT or RTL_RETURN_ALT")


def test_who_does_not_answer_or_keeps_another_value_fails() -> None:
    silent = Talk(OLD | COPTER, ARDUCOPTER)
    silent.mute = True
    silent.go_on(12.0)
    assert silent.setting.verdict == (False, "return height not set: it does not answer about its parameters")
    stubborn = Talk(OLD | COPTER, ARDUCOPTER)
    stubborn.locked = {"FS_GCS_ENABLE"}
    stubborn.go_on(8.0)
    assert stubborn.setting.verdict == (False, "return parameter FS_GCS_ENABLE refused: it keeps 0")


def test_what_the_scenario_sets_is_left() -> None:
    talk = Talk(OLD | COPTER, ARDUCOPTER, given=("RTL_ALT_M", "GUID_TIMEOUT"))
    talk.go_on(5.0)
    assert (talk.numbers["RTL_ALT"], talk.numbers["GUID_TIMEOUT"]) == (1500, 3.0)
    assert talk.setting.verdict == (True, "return parameters set and read back")


def test_a_dry_run_writes_nothing_and_says_what_it_would() -> None:
    talk = Talk(OF_PX4, PX4, dry_run=True)
    talk.go_on(5.0)
    assert talk.setting.verdict == (True, "return height 7.4 m would be set")
    assert talk.set_names == []
    assert talk.setting.before == {}


def test_an_autopilot_without_a_table_is_named_and_passes() -> None:
    talk = Talk(OF_PX4, ARDUPLANE)
    talk.go_on(1.0)
    assert talk.setting.verdict is not None
    assert talk.setting.verdict.passed
    assert "no parameter for it that is known here" in talk.setting.verdict.text
    assert talk.set_names == []


def test_a_session_that_ends_amid_the_setting_puts_back_what_it_wrote() -> None:
    talk = Talk(OLD | COPTER, ARDUCOPTER)
    talk.go_on(0.2)
    assert talk.setting.verdict is None
    assert talk.set_names
    talk.setting.put_back(ARDUCOPTER)
    talk.go_on(3.0, back=True)
    assert talk.numbers == {name: number for name, (number, _) in (OLD | COPTER).items()}


def test_launched_ones_get_nothing_back_for_they_end_with_the_session() -> None:
    talk = Talk(OLD | COPTER, ARDUCOPTER, external=False)
    talk.go_on(5.0)
    talk.setting.put_back(ARDUCOPTER)
    assert talk.setting.poll_back(talk.now_s) == []
    assert math.isclose(talk.numbers["RTL_ALT"], 740.0)
