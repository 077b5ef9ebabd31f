"""The table of modes, read as a table and held against what the issue says of modes and failsafes."""

import itertools

import pytest

from simvehicle.autopilot.modes import FAILSAFES, RESTING, RULES, STAND_DOWN, STEERED, Mode, Severity, Trigger, rule_for

EVERYWHERE = list(itertools.product(Mode, (False, True)))
_REFUSED = "refused"

# (event, armed) → where each mode goes: a mode, None for "stays", or refused. `others` stands for modes not listed.
EXPECTED: dict[tuple[Trigger, bool], dict[str, str | None]] = {
    (Trigger.ARM, False): {"land": "hold", "return": "hold", "follow": "hold", "others": None},
    (Trigger.ARM, True): {"others": None},
    (Trigger.DISARM, False): {"others": "hold"},
    (Trigger.DISARM, True): {"others": "hold"},
    (Trigger.TAKEOFF, False): {"others": _REFUSED},
    (Trigger.TAKEOFF, True): {"others": "takeoff"},
    (Trigger.TAKEOFF_DONE, False): {"others": _REFUSED},
    (Trigger.TAKEOFF_DONE, True): {"takeoff": "hold", "others": _REFUSED},
    (Trigger.OFFBOARD, False): {"refuel": None, "others": "offboard"},
    (Trigger.OFFBOARD, True): {"refuel": None, "others": "offboard"},
    (Trigger.HOLD, False): {"others": "hold"},
    (Trigger.HOLD, True): {"others": "hold"},
    (Trigger.LAND, False): {"others": "land"},
    (Trigger.LAND, True): {"others": "land"},
    (Trigger.RETURN, False): {"others": "return"},
    (Trigger.RETURN, True): {"others": "return"},
    (Trigger.HOME_REACHED, False): {"others": _REFUSED},
    (Trigger.HOME_REACHED, True): {"return": "land", "others": _REFUSED},
    (Trigger.TOUCHDOWN, False): {"others": _REFUSED},
    (Trigger.TOUCHDOWN, True): {"land": None, "mission": "hold", "others": _REFUSED},
    (Trigger.REFUEL, False): {"others": _REFUSED},
    (Trigger.REFUEL, True): {"offboard": "refuel", "refuel": "refuel", "others": _REFUSED},
    (Trigger.REFUEL_END, False): {"refuel": "offboard", "others": _REFUSED},
    (Trigger.REFUEL_END, True): {"refuel": "offboard", "others": _REFUSED},
    (Trigger.BATTERY_EMPTY, False): {"others": _REFUSED},
    (Trigger.BATTERY_EMPTY, True): {"land": _REFUSED, "others": "land"},
    (Trigger.GCS_LOST, False): {"others": _REFUSED},
    (Trigger.GCS_LOST, True): {"land": _REFUSED, "return": _REFUSED, "others": "return"},
    (Trigger.SETPOINTS_LOST, False): {"others": _REFUSED},
    (Trigger.SETPOINTS_LOST, True): {"offboard": "hold", "refuel": "hold", "others": _REFUSED},
    (Trigger.MISSION, False): {"others": "mission"},
    (Trigger.MISSION, True): {"others": "mission"},
    (Trigger.MISSION_DONE, False): {"mission": "hold", "others": _REFUSED},
    (Trigger.MISSION_DONE, True): {"mission": "hold", "others": _REFUSED},
    (Trigger.FOLLOW, False): {"others": _REFUSED},
    (Trigger.FOLLOW, True): {"others": "follow"},
    (Trigger.GUIDED, False): {"takeoff": None, "offboard": None, "refuel": None, "guided": None, "others": "guided"},
    (Trigger.GUIDED, True): {"takeoff": None, "offboard": None, "refuel": None, "guided": None, "others": "guided"},
    (Trigger.GUIDED_HOLD, False): {"others": "guided"},
    (Trigger.GUIDED_HOLD, True): {"others": "guided"},
    (Trigger.CRASHED, False): {"others": _REFUSED},
    (Trigger.CRASHED, True): {"others": "hold"},
    (Trigger.GPS_LOST, False): {"others": _REFUSED},
    (Trigger.GPS_LOST, True): {"land": _REFUSED, "others": "land"},
    (Trigger.FENCE_HOLD, False): {"others": _REFUSED},
    (Trigger.FENCE_HOLD, True): {"land": _REFUSED, "return": _REFUSED, "others": "hold"},
    (Trigger.FENCE_RETURN, False): {"others": _REFUSED},
    (Trigger.FENCE_RETURN, True): {"land": _REFUSED, "return": _REFUSED, "others": "return"},
}


def test_expectations_cover_every_event_in_both_armings() -> None:
    assert set(EXPECTED) == set(itertools.product(Trigger, (False, True)))


@pytest.mark.parametrize("event", Trigger)
@pytest.mark.parametrize(("mode", "armed"), EVERYWHERE)
def test_event_in_mode_and_arming_leads_where_it_should(event: Trigger, mode: Mode, armed: bool) -> None:
    row = EXPECTED[event, armed]
    wanted = row.get(mode, row["others"])
    rule = rule_for(event, mode, armed)
    if wanted == _REFUSED:
        assert rule is None
    else:
        assert rule is not None
        assert rule.mode == wanted


@pytest.mark.parametrize(
    ("event", "arming"),
    [(Trigger.ARM, True), (Trigger.DISARM, False), (Trigger.TOUCHDOWN, False), (Trigger.CRASHED, False)],
)
def test_only_arm_disarm_touchdown_and_crash_change_the_arming(event: Trigger, arming: bool) -> None:
    assert {rule.arming for rule in RULES if rule.event is event} <= {arming, None}
    changing = {rule.event for rule in RULES if rule.arming is not None}
    assert changing == {Trigger.ARM, Trigger.DISARM, Trigger.TOUCHDOWN, Trigger.CRASHED}


def test_worst_failsafe_comes_first() -> None:
    landing = (Trigger.BATTERY_EMPTY, Trigger.GPS_LOST)
    returning = (Trigger.GCS_LOST, Trigger.FENCE_RETURN)
    assert (*landing, *returning, Trigger.FENCE_HOLD, Trigger.SETPOINTS_LOST) == FAILSAFES


@pytest.mark.parametrize("mode", Mode)
def test_lesser_failsafe_never_undoes_a_worse_one(mode: Mode) -> None:
    for worse, lesser in itertools.combinations(FAILSAFES, 2):
        first = rule_for(worse, mode, True)
        after = mode if first is None or first.mode is None else first.mode
        second = rule_for(lesser, after, True)
        assert first is None or second is None


def test_failsafes_warn_and_those_that_land_are_critical() -> None:
    loud = {rule.event: rule.severity for rule in RULES if rule.event in FAILSAFES}
    assert loud == {
        Trigger.BATTERY_EMPTY: Severity.CRITICAL,
        Trigger.GPS_LOST: Severity.CRITICAL,
        Trigger.GCS_LOST: Severity.WARNING,
        Trigger.FENCE_RETURN: Severity.WARNING,
        Trigger.FENCE_HOLD: Severity.WARNING,
        Trigger.SETPOINTS_LOST: Severity.WARNING,
    }
    assert (STAND_DOWN.mode, STAND_DOWN.arming, STAND_DOWN.severity) == (Mode.HOLD, False, Severity.WARNING)


def test_every_rule_that_changes_something_has_words_that_fit_a_statustext() -> None:
    for rule in (*RULES, STAND_DOWN):
        changes = rule.mode is not None or rule.arming is not None
        assert bool(rule.text) == changes
        assert len(rule.text) <= 50


def test_every_rule_decides_somewhere() -> None:
    deciding = {id(rule_for(event, mode, armed)) for event in Trigger for mode, armed in EVERYWHERE}
    assert all(id(rule) in deciding for rule in RULES)


def test_every_mode_can_be_left_for_land_and_hold() -> None:
    for mode, armed in EVERYWHERE:
        assert rule_for(Trigger.LAND, mode, armed) is not None
        assert rule_for(Trigger.HOLD, mode, armed) is not None
    assert {Mode.OFFBOARD, Mode.REFUEL} == STEERED
    assert STEERED.isdisjoint(RESTING)
