"""How loudly the words of vehicles are told; the severities are MAVLink's."""

from gcs.telemetry.events import level_of


def test_errors_are_critical_warnings_are_warnings_and_the_rest_is_information() -> None:
    told = [level_of(severity) for severity in range(8)]
    assert told == ["critical"] * 4 + ["warning"] + ["info"] * 3
