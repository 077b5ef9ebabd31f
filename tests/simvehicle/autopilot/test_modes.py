"""The table of modes, read as a table and held against what the issue says of modes and failsafes."""

import itertools

import pytest

from simvehicle.autopilot.modes import FAILSAFES, RULES, STAND_DOWN, Mode, Severity, Trigger, rule_for

EVERYWHERE = list(itertools.product(Mode, (False, True)))
REFUSED = "refused"

# Where an event leads from each mode: a mode, None for "stays", or refused. `others` stands for modes not listed.
ARMED_OR_NOT: dict[Trigger, dict[str, str | None]] = {
    Trigger.DISARM: {"others": "hold"},
    Trigger.OFFBOARD: {"refuel": None, "others": "offboard"},
    Trigger.HOLD: {"others": "hold"},
    Trigger.LAND: {"others": "land"},
    Trigger.RETURN: {"others": "return"},
    Trigger.REFUEL_END: {"refuel": "offboard", "others": REFUSED},
    Trigger.MISSION: {"others": "mission"},
    Trigger.MISSION_DONE: {"mission": "hold", "others": REFUSED},
    Trigger.GUIDED: {"takeoff": None, "offboard": None, "refuel": None, "guided": None, "others": "guided"},
    Trigger.GUIDED_HOLD: {"others": "guided"},
}
ONLY_ARMED: dict[Trigger, dict[str, str | None]] = {
    Trigger.TAKEOFF: {"others": "takeoff"},
    Trigger.TAKEOFF_DONE: {"takeoff": "hold", "others": REFUSED},
    Trigger.HOME_REACHED: {"return": "land", "others": REFUSED},
    Trigger.TOUCHDOWN: {"land": None, "mission": "hold", "others": REFUSED},
    Trigger.REFUEL: {"offboard": "refuel", "refuel": "refuel", "others": REFUSED},
    Trigger.BATTERY_EMPTY: {"land": REFUSED, "others": "land"},
    Trigger.GCS_LOST: {"land": REFUSED, "return": REFUSED, "others": "return"},
    Trigger.SETPOINTS_LOST: {"offboard": "hold", "refuel": "hold", "others": REFUSED},
    Trigger.FOLLOW: {"others": "follow"},
    Trigger.CRASHED: {"others": "hold"},
    Trigger.GPS_LOST: {"land": REFUSED, "others": "land"},
    Trigger.FENCE_HOLD: {"land": REFUSED, "return": REFUSED, "others": "hold"},
    Trigger.FENCE_RETURN: {"land": REFUSED, "return": REFUSED, "others": "return"},
}
ARMS: dict[bool, dict[str, str | None]] = {
    False: {"land": "hold", "return": "hold", "follow": "hold", "others": None},
    True: {"others": None},
}


def leads(event: Trigger, armed: bool) -> dict[str, str | None]:
    """Where it leads from each mode."""
    if event is Trigger.ARM:
        return ARMS[armed]
    if event in ONLY_ARMED:
        return ONLY_ARMED[event] if armed else {"others": REFUSED}
    return ARMED_OR_NOT[event]


@pytest.mark.parametrize("event", Trigger)
def test_event_in_mode_and_arming_leads_where_it_should(event: Trigger) -> None:
    for mode, armed in EVERYWHERE:
        row = leads(event, armed)
        wanted = row.get(mode, row["others"])
        rule = rule_for(event, mode, armed)
        assert (REFUSED if rule is None else rule.mode) == wanted, (mode, armed)


def test_only_arm_disarm_touchdown_and_crash_change_the_arming() -> None:
    assert {(rule.event, rule.arming) for rule in RULES if rule.arming is not None} == {
        (Trigger.ARM, True), (Trigger.DISARM, False), (Trigger.TOUCHDOWN, False), (Trigger.CRASHED, False),
    }  # fmt: skip


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
