"""The table of modes, read as a table and held against what the issue says of modes and failsafes."""

import itertools

import pytest

from simvehicle.autopilot.modes import FAILSAFES, RESTING, RULES, STAND_DOWN, STEERED, Event, Mode, Severity, rule_for

EVERYWHERE = list(itertools.product(Mode, (False, True)))
_REFUSED = "refused"

# (event, armed) → where each mode goes: a mode, None for "stays", or refused. `others` stands for modes not listed.
EXPECTED: dict[tuple[Event, bool], dict[str, str | None]] = {
    (Event.ARM, False): {"land": "hold", "return": "hold", "follow": "hold", "others": None},
    (Event.ARM, True): {"others": None},
    (Event.DISARM, False): {"others": "hold"},
    (Event.DISARM, True): {"others": "hold"},
    (Event.TAKEOFF, False): {"others": _REFUSED},
    (Event.TAKEOFF, True): {"others": "takeoff"},
    (Event.TAKEOFF_DONE, False): {"others": _REFUSED},
    (Event.TAKEOFF_DONE, True): {"takeoff": "hold", "others": _REFUSED},
    (Event.OFFBOARD, False): {"refuel": None, "others": "offboard"},
    (Event.OFFBOARD, True): {"refuel": None, "others": "offboard"},
    (Event.HOLD, False): {"others": "hold"},
    (Event.HOLD, True): {"others": "hold"},
    (Event.LAND, False): {"others": "land"},
    (Event.LAND, True): {"others": "land"},
    (Event.RETURN, False): {"others": "return"},
    (Event.RETURN, True): {"others": "return"},
    (Event.HOME_REACHED, False): {"others": _REFUSED},
    (Event.HOME_REACHED, True): {"return": "land", "others": _REFUSED},
    (Event.TOUCHDOWN, False): {"others": _REFUSED},
    (Event.TOUCHDOWN, True): {"land": None, "mission": "hold", "others": _REFUSED},
    (Event.REFUEL, False): {"others": _REFUSED},
    (Event.REFUEL, True): {"offboard": "refuel", "refuel": "refuel", "others": _REFUSED},
    (Event.REFUEL_END, False): {"refuel": "offboard", "others": _REFUSED},
    (Event.REFUEL_END, True): {"refuel": "offboard", "others": _REFUSED},
    (Event.BATTERY_EMPTY, False): {"others": _REFUSED},
    (Event.BATTERY_EMPTY, True): {"land": _REFUSED, "others": "land"},
    (Event.GCS_LOST, False): {"others": _REFUSED},
    (Event.GCS_LOST, True): {"land": _REFUSED, "return": _REFUSED, "others": "return"},
    (Event.SETPOINTS_LOST, False): {"others": _REFUSED},
    (Event.SETPOINTS_LOST, True): {"offboard": "hold", "refuel": "hold", "others": _REFUSED},
    (Event.MISSION, False): {"others": "mission"},
    (Event.MISSION, True): {"others": "mission"},
    (Event.MISSION_DONE, False): {"mission": "hold", "others": _REFUSED},
    (Event.MISSION_DONE, True): {"mission": "hold", "others": _REFUSED},
    (Event.FOLLOW, False): {"others": _REFUSED},
    (Event.FOLLOW, True): {"others": "follow"},
    (Event.GUIDED, False): {"takeoff": None, "offboard": None, "refuel": None, "guided": None, "others": "guided"},
    (Event.GUIDED, True): {"takeoff": None, "offboard": None, "refuel": None, "guided": None, "others": "guided"},
    (Event.GUIDED_HOLD, False): {"others": "guided"},
    (Event.GUIDED_HOLD, True): {"others": "guided"},
    (Event.CRASHED, False): {"others": _REFUSED},
    (Event.CRASHED, True): {"others": "hold"},
    (Event.GPS_LOST, False): {"others": _REFUSED},
    (Event.GPS_LOST, True): {"land": _REFUSED, "others": "land"},
    (Event.FENCE_HOLD, False): {"others": _REFUSED},
    (Event.FENCE_HOLD, True): {"land": _REFUSED, "return": _REFUSED, "others": "hold"},
    (Event.FENCE_RETURN, False): {"others": _REFUSED},
    (Event.FENCE_RETURN, True): {"land": _REFUSED, "return": _REFUSED, "others": "return"},
}


def test_expectations_cover_every_event_in_both_armings() -> None:
    assert set(EXPECTED) == set(itertools.product(Event, (False, True)))


@pytest.mark.parametrize("event", Event)
@pytest.mark.parametrize(("mode", "armed"), EVERYWHERE)
def test_event_in_mode_and_arming_leads_where_it_should(event: Event, mode: Mode, armed: bool) -> None:
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
    [(Event.ARM, True), (Event.DISARM, False), (Event.TOUCHDOWN, False), (Event.CRASHED, False)],
)
def test_only_arm_disarm_touchdown_and_crash_change_the_arming(event: Event, arming: bool) -> None:
    assert {rule.arming for rule in RULES if rule.event is event} <= {arming, None}
    changing = {rule.event for rule in RULES if rule.arming is not None}
    assert changing == {Event.ARM, Event.DISARM, Event.TOUCHDOWN, Event.CRASHED}


def test_worst_failsafe_comes_first() -> None:
    landing = (Event.BATTERY_EMPTY, Event.GPS_LOST)
    returning = (Event.GCS_LOST, Event.FENCE_RETURN)
    assert (*landing, *returning, Event.FENCE_HOLD, Event.SETPOINTS_LOST) == FAILSAFES


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
        Event.BATTERY_EMPTY: Severity.CRITICAL,
        Event.GPS_LOST: Severity.CRITICAL,
        Event.GCS_LOST: Severity.WARNING,
        Event.FENCE_RETURN: Severity.WARNING,
        Event.FENCE_HOLD: Severity.WARNING,
        Event.SETPOINTS_LOST: Severity.WARNING,
    }
    assert (STAND_DOWN.mode, STAND_DOWN.arming, STAND_DOWN.severity) == (Mode.HOLD, False, Severity.WARNING)


def test_every_rule_that_changes_something_has_words_that_fit_a_statustext() -> None:
    for rule in (*RULES, STAND_DOWN):
        changes = rule.mode is not None or rule.arming is not None
        assert bool(rule.text) == changes
        assert len(rule.text) <= 50


def test_every_rule_decides_somewhere() -> None:
    deciding = {id(rule_for(event, mode, armed)) for event in Event for mode, armed in EVERYWHERE}
    assert all(id(rule) in deciding for rule in RULES)


def test_every_mode_can_be_left_for_land_and_hold() -> None:
    for mode, armed in EVERYWHERE:
        assert rule_for(Event.LAND, mode, armed) is not None
        assert rule_for(Event.HOLD, mode, armed) is not None
    assert {Mode.OFFBOARD, Mode.REFUEL} == STEERED
    assert STEERED.isdisjoint(RESTING)
