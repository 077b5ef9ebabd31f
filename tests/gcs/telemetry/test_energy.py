"""Energy from what autopilots report: integrals against closed forms, messages as pymavlink makes them."""

from __future__ import annotations

import itertools
import math
import random
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import battery, codec
from gcs.mavlink.battery import BatteryReport, BatteryReports
from gcs.telemetry.battery_account import GIVEN, RECEIVED, BatteryAccount, Fact
from gcs.telemetry.energy import GAP_S, MOST_HISTORY, SOURCES, EnergySource

CAPACITY_J = 100_000.0
CELLS = [65535] * 10
TOTALS = st.sampled_from([0.0, 100.0, 5000.0, 60_000.0, 1e6])
POWERS = st.sampled_from([-50.0, 0.0, 120.0, 4000.0, 2e5])
SHARES = st.sampled_from([0.0, 0.3, 0.31, 0.9, 1.0])
WORDS = st.tuples(*(st.one_of(st.none(), one) for one in (TOTALS, POWERS, SHARES)), st.booleans(), st.booleans())


def told(kind: str, **changed: Any) -> Any:
    """A message's fields as they come off the wire, packed by pymavlink."""
    cls = getattr(mav, f"MAVLink_{kind.lower()}_message")
    content = dict.fromkeys(cls.fieldnames, 0) | changed
    raw = cls(**{name: content[name] for name in cls.fieldnames}).pack(mav.MAVLink(None, srcSystem=3, srcComponent=1))
    (frame,) = codec.split(bytes(raw)).frames
    return codec.fields(frame)


def status(**changed: Any) -> BatteryReport:
    quiet = {"energy_consumed": -1, "current_battery": -1, "battery_remaining": -1, "voltages": CELLS}
    return battery.battery_status(told("BATTERY_STATUS", **(quiet | {"voltages_ext": [0] * 4} | changed)), 2.0)


def power(time_s: float, power_w: float | None, remaining: float | None = None) -> BatteryReport:
    return BatteryReport(time_s, None, power_w, remaining)


def share(time_s: float, remaining: float) -> BatteryReport:
    return BatteryReport(time_s, None, None, remaining)


def new(capacity_j: float = CAPACITY_J) -> BatteryAccount:
    return BatteryAccount(capacity_j, capacity_j)


def heard(*reports: BatteryReport, armed: bool = True) -> tuple[BatteryAccount, list[Fact]]:
    account = new()
    for report in reports:
        assert not account.report(report, armed=armed)
    return account, account.facts


# MAVLink's units


def test_a_battery_status_is_read_in_si() -> None:
    """Four cells of 3.9 V at 12.5 A are 195 W; 73 hJ; 64 %."""
    report = status(
        voltages=[3900] * 4 + [65535] * 6, current_battery=1250, energy_consumed=73, battery_remaining=64
    )  # fmt: skip
    assert (report.time_s, report.consumed_j) == (2.0, 7300.0)
    assert report.power_w == pytest.approx(195.0)
    assert report.remaining == pytest.approx(0.64)


def test_fourteen_cells_are_summed() -> None:
    assert status(voltages=[4000] * 10, voltages_ext=[4000] * 4, current_battery=100).power_w == pytest.approx(56.0)


def test_more_cells_count_only_after_ten() -> None:
    report = status(voltages=[4000] * 3 + [65535] * 7, voltages_ext=[4000] * 4, current_battery=100)
    assert report.power_w == pytest.approx(12.0)


def test_further_cells_that_an_older_firmware_marks_as_missing_are_none() -> None:
    """PX4 filled all fields with UINT16_MAX before it knew the extension's meaning of 0."""
    report = status(voltages=[4000] * 10, voltages_ext=[4000, 65535, 65535, 65535], current_battery=100)
    assert report.power_w == pytest.approx(44.0)


def test_a_pack_above_65_v_spreads_over_two_cells() -> None:
    """The message's definition: cell 0 at 65534 mV, the rest in cell 1."""
    assert status(voltages=[65534, 4466] + [65535] * 8, current_battery=100).power_w == pytest.approx(70.0)


@pytest.mark.parametrize(
    "unknown", [{"current_battery": -1}, {"current_battery": -100}, {"voltages": CELLS}, {"voltages": [0] * 10}]
)
def test_power_is_unknown_without_current_or_voltage(unknown: dict[str, Any]) -> None:
    full = {"voltages": [16000, *CELLS[1:]], "current_battery": 1000}
    assert status(**full).power_w == pytest.approx(160.0)
    assert status(**(full | unknown)).power_w is None


@pytest.mark.parametrize(("percent", "expected"), [(-1, None), (0, 0.0), (100, 1.0), (101, None), (-128, None)])
def test_a_share_that_is_none_is_not_told(percent: int, expected: float | None) -> None:
    assert status(battery_remaining=percent).remaining == expected


def test_a_sys_status_tells_the_same_at_second_hand() -> None:
    content = told("SYS_STATUS", voltage_battery=15600, current_battery=1250, battery_remaining=64)
    report = battery.sys_status(content, 2.0)
    assert report.power_w == pytest.approx(195.0)
    assert report.remaining == pytest.approx(0.64)
    assert report.second_hand
    assert report.consumed_j is None
    content = told("SYS_STATUS", voltage_battery=65535, current_battery=1250, battery_remaining=-1)
    assert battery.sys_status(content, 2.0) == BatteryReport(2.0, None, None, None, second_hand=True)


# current times voltage


def test_a_ramp_is_integrated_exactly_whatever_the_spacing() -> None:
    """100 W + 7 W/s · t over 0..20 s: 2000 + 7·200 J."""
    rng = random.Random(4)
    times = sorted({0.0, 20.0, *(rng.uniform(0.0, 20.0) for _ in range(40))})
    account, facts = heard(*(power(t, 100.0 + 7.0 * t) for t in times))
    assert account.drawn_j == pytest.approx(2000.0 + 1400.0, rel=1e-12)
    assert account.source == "current_voltage"
    assert not facts


def test_a_sine_is_integrated_within_the_trapezoid_rules_bound() -> None:
    """∫ 200 + 100 sin t over 0..2π is 400π; the rule is off by at most (b-a) h²/12 max|f''|."""
    n = 200
    h = 2.0 * math.pi / n
    account, _ = heard(*(power(h * k, 200.0 + 100.0 * math.sin(h * k)) for k in range(n + 1)))
    assert abs(account.drawn_j - 400.0 * math.pi) <= 2.0 * math.pi * h * h / 12.0 * 100.0


def test_a_gap_is_bridged_by_the_mean_of_both_ends_and_told() -> None:
    account, facts = heard(power(0.0, 100.0), power(1.0, 100.0), power(11.0, 300.0), power(12.0, 300.0))
    assert account.drawn_j == pytest.approx(100.0 + 200.0 * 10.0 + 300.0)
    assert [fact.text for fact in facts] == ["No current or voltage for 10.0 s: bridged by the mean of both ends"]


def test_samples_that_are_late_or_twice_draw_nothing() -> None:
    account, _ = heard(power(0.0, 100.0), power(2.0, 100.0), power(2.0, 900.0), power(1.0, 900.0), power(3.0, 100.0))
    assert account.drawn_j == pytest.approx(300.0)


def test_a_charging_current_is_no_energy_drawn_back() -> None:
    account, _ = heard(power(0.0, 100.0), power(1.0, 100.0), power(1.5, -400.0), power(3.0, -400.0))
    assert account.drawn_j == pytest.approx(100.0 + 25.0)


# which source


def test_the_autopilots_own_total_goes_before_everything() -> None:
    reports = [BatteryReport(float(t), 500.0 * t, 100.0, 1.0 - 0.01 * t) for t in range(5)]
    account, _ = heard(*reports)
    assert (account.source, account.drawn_j) == (EnergySource.ENERGY_CONSUMED, 2000.0)
    assert account.power_w == pytest.approx(500.0)


def test_a_share_is_what_is_left_where_nothing_else_is_told() -> None:
    account, _ = heard(*(share(10.0 * k, 0.80 - 0.01 * k) for k in range(11)))
    assert account.source == "battery_remaining"
    assert account.drawn_j == pytest.approx(0.10 * CAPACITY_J)
    assert account.power_w == pytest.approx(100.0)  # 1 % of 100 kJ every 10 s


@pytest.mark.parametrize("seed", range(6))
def test_power_is_the_mean_of_the_last_while(seed: int) -> None:
    """Held against a list of what had been drawn when, with sources that come and go."""
    rng = random.Random(seed)
    account, history, source, power_w = new(), list[tuple[float, float]](), "none", 0.0
    every_s, t_s, total_j, left = rng.choice([0.01, 0.5, 3.0]), 0.0, 0.0, 0.9
    for k in range(1500):
        t_s += every_s * rng.choice([1.0, 1.0, 1.0, 0.0, 2.0])
        total_j += rng.choice([0.0, 10.0, 25.0])
        left -= rng.choice([0.0, 0.0, 0.0, 0.0002])
        told = BatteryReport(t_s, *((total_j, None, None), (None, 300.0, None), (None, None, left))[k // 200 % 3])
        before_j = account.drawn_j
        account.report(told, armed=True)
        word = ("energy_consumed", "current_voltage", "battery_remaining")[k // 200 % 3]
        assert account.drawn_j >= before_j
        if account.account["source"][0] == SOURCES.index(EnergySource(word)):  # its word was among the report's
            if word != source:
                source, history = word, []
            steps = word == "battery_remaining"
            if not (steps and history and history[-1][1] == account.drawn_j):
                history = [*history, (t_s, account.drawn_j)][-MOST_HISTORY:]
                while len(history) > 2 and t_s - history[1][0] >= (120.0 if steps else 5.0):
                    history.pop(0)
                if t_s > history[0][0]:
                    power_w = (account.drawn_j - history[0][1]) / (t_s - history[0][0])
        assert (account.source, account.power_w) == (source, power_w)
    assert power_w > 0.0


@pytest.mark.parametrize("every_s", [0.5, 5.0])
def test_charge_that_is_lost_at_once_is_no_power(every_s: float) -> None:
    """A hovering vehicle draws 210 W, by its total in steps of 100 J; at 55 s half of its charge is gone."""
    account, lost_j = new(60_000.0), 30_000.0
    for k in range(1, round(90.0 / every_s)):
        t_s = k * every_s
        consumed_j = 100.0 * math.floor((210.0 * t_s + (lost_j if t_s >= 55.0 else 0.0)) / 100.0)
        assert not account.report(BatteryReport(t_s, consumed_j, 210.0, None), armed=True)
        if t_s > 10.0:
            assert account.power_w == pytest.approx(210.0, abs=100.0 / 5.0), t_s
    assert account.remaining_j == 60_000.0 - consumed_j


def test_nothing_told_is_no_source() -> None:
    account, _ = heard(status())
    assert (account.source, account.drawn_j, account.power_w) == (EnergySource.NONE, 0.0, 0.0)


def test_a_source_that_falls_silent_gives_its_place_and_not_a_joule_is_lost_or_counted_twice() -> None:
    """100 W throughout, told by the total until 10 s, then by V·I alone, then by both again."""
    reports = [BatteryReport(float(t), 100.0 * t if t <= 10 or t > 30 else None, 100.0, None) for t in range(41)]
    account = new()
    sources = []
    for report in reports:
        account.report(report, armed=True)
        sources.append((report.time_s, str(account.source)))
    assert account.drawn_j == pytest.approx(4000.0)
    assert dict(sources)[10.0 + GAP_S] == "energy_consumed"
    assert dict(sources)[11.0 + GAP_S] == "current_voltage"
    assert dict(sources)[31.0] == "energy_consumed"


def test_a_total_that_comes_late_does_not_bring_what_was_drawn_before_the_first_word() -> None:
    account, _ = heard(*(power(float(t), 100.0) for t in range(11)), BatteryReport(11.0, 50_000.0, 100.0, None))
    drawn_j = account.drawn_j
    account.report(BatteryReport(12.0, 50_100.0, 100.0, None), armed=True)
    assert drawn_j == pytest.approx(1000.0)
    assert account.drawn_j == pytest.approx(1100.0)


def test_sys_status_counts_only_while_battery_status_is_silent() -> None:
    def second_hand(t: float, power_w: float) -> BatteryReport:
        return BatteryReport(t, None, power_w, None, second_hand=True)

    account, _ = heard(second_hand(0.0, 900.0), power(1.0, 100.0), second_hand(1.5, 900.0), power(2.0, 100.0))
    assert account.drawn_j == pytest.approx(100.0)
    alone, _ = heard(*(second_hand(float(t), 50.0) for t in range(21)))
    assert alone.source == "current_voltage"
    assert alone.drawn_j == pytest.approx(50.0 * (20.0 - (GAP_S + 1.0)))  # it is waited for first


def test_energy_drawn_never_falls_whatever_is_reported() -> None:
    rng = random.Random(11)
    account, before_j = new(), 0.0
    for k in range(2000):
        total_j, power_w, left = (
            rng.choice([None, value]) for value in (rng.uniform(0, 1e5), rng.uniform(-500, 500), rng.random())
        )
        account.counter(rng.choice([RECEIVED, GIVEN]), rng.randint(0, 900), 0.7 * k)
        account.book(3)
        report = BatteryReport(0.7 * k + rng.uniform(-3, 9), total_j, power_w, left, second_hand=rng.random() < 0.3)
        account.report(report, armed=rng.random() < 0.5)
        assert account.drawn_j >= before_j
        before_j = account.drawn_j


# restarts, swaps, bases


def test_an_autopilot_that_was_restarted_goes_on_from_its_old_total() -> None:
    account = new()
    for t, total_j in enumerate((0.0, 20_000.0, 0.0, 500.0)):
        account.report(BatteryReport(float(t), total_j, None, None), armed=False)
    assert account.drawn_j == 20_500.0


def test_a_frame_that_was_overtaken_is_no_restart() -> None:
    account, _ = heard(*(BatteryReport(0.5 * k, j, None, None) for k, j in enumerate((0.0, 900.0, 100.0, 950.0))),
                         armed=False)  # fmt: skip
    assert account.drawn_j == 950.0


def test_a_swapped_battery_is_a_fact_with_what_it_brought() -> None:
    account, facts = heard(share(0.0, 0.5), share(10.0, 0.3), share(20.0, 0.95), share(30.0, 0.90), armed=False)
    (fact,) = facts
    assert fact.gained_j == pytest.approx(0.65 * CAPACITY_J)
    assert "swapped" in fact.text
    assert account.drawn_j == pytest.approx(0.25 * CAPACITY_J)
    # initial 50 kJ + 65 kJ = drawn 25 kJ + remaining 90 kJ
    assert 0.5 * CAPACITY_J + fact.gained_j - account.drawn_j == pytest.approx(0.9 * CAPACITY_J)


def test_no_battery_is_swapped_in_the_air_nor_by_a_small_rise() -> None:
    _, facts = heard(share(0.0, 0.3), share(10.0, 0.95), armed=True)
    assert not facts
    _, facts = heard(share(0.0, 0.30), share(10.0, 0.45), armed=False)
    assert not facts


@pytest.mark.parametrize(("boots_s", "gained_j"), [(6.0, []), (60.0, [70_000.0])])
def test_an_autopilot_that_booted_in_flight_takes_its_battery_for_full_and_brings_none(
    boots_s: float, gained_j: list[float]
) -> None:
    """As an ArduCopter does: its own total begins anew, and its share at 100 %."""
    account = new()
    for t, left in enumerate((0.50, 0.40, 0.30)):
        account.report(BatteryReport(float(t), CAPACITY_J * (0.5 - left), None, left), armed=True)
    account.report(BatteryReport(2.0 + boots_s, 0.0, None, 1.00), armed=False)
    account.report(BatteryReport(3.0 + boots_s, 0.0, None, 1.00), armed=False)
    account.report(BatteryReport(50.0 + boots_s, 10_000.0, None, 0.90), armed=True)
    assert [fact.gained_j for fact in account.facts] == pytest.approx(gained_j)
    assert account.drawn_j == pytest.approx(30_000.0)
    assert account.remaining_j == pytest.approx(20_000.0 + sum(gained_j))


def test_no_battery_brings_more_than_fits_into_the_capacity() -> None:
    """By its own total it drew 10 kJ, by its share 40: what is left is 90 kJ of 100."""
    account = new()
    for t, (total_j, left) in enumerate(((0.0, 1.00), (10_000.0, 0.60))):
        account.report(BatteryReport(float(t), total_j, None, left), armed=True)
    account.report(BatteryReport(90.0, 10_000.0, None, 1.00), armed=False)
    assert [fact.gained_j for fact in account.facts] == [pytest.approx(10_000.0)]
    assert account.remaining_j == pytest.approx(CAPACITY_J)


def test_a_share_that_flickers_is_not_drawn_over_and_over() -> None:
    account, _ = heard(*(share(float(k), 0.50 - 0.01 * (k % 2)) for k in range(100)))
    assert account.drawn_j == pytest.approx(0.01 * CAPACITY_J)


def test_energy_received_in_the_air_is_expected_and_not_drawn() -> None:
    account = new()
    account.report(share(0.0, 0.40), armed=True)
    account.counter(RECEIVED, 0, 0.0)
    account.counter(RECEIVED, 25_000, 1.0)
    account.report(share(1.0, 0.60), armed=True)
    assert account.drawn_j == pytest.approx(5_000.0)  # 40 kJ + 25 kJ - 60 kJ


@pytest.mark.parametrize("consumed_j", [None, 130_000.0])
def test_what_had_moved_when_a_vehicle_is_first_heard_of_is_in_its_first_share(consumed_j: float | None) -> None:
    """At 60 % its counters say that 90 kJ came and 20 kJ went, and 5 kJ come later: it has 65 % less 3 kJ drawn."""

    def report(time_s: float, drawn_j: float, remaining: float) -> BatteryReport:
        return BatteryReport(time_s, None if consumed_j is None else consumed_j + drawn_j, None, remaining)

    account = new()
    account.report(report(0.0, 0.0, 0.60), armed=True)
    account.counter(RECEIVED, 90_000, 0.2)
    account.counter(GIVEN, 20_000, 0.2)
    account.report(report(0.5, 1_000.0, 0.59), armed=True)
    assert account.remaining_j == pytest.approx(59_000.0)
    account.counter(RECEIVED, 95_000, 3.0)
    account.report(report(4.0, 3_000.0, 0.62), armed=True)
    assert account.remaining_j == pytest.approx(62_000.0)
    assert account.drawn_j == pytest.approx(3_000.0 + (consumed_j or 0.0))


@pytest.mark.parametrize("rises", [True, False])
def test_what_a_base_booked_counts_once_whether_the_autopilots_share_rises_or_not(rises: bool) -> None:
    """40 %, 30 kJ booked on the ground, then 10 kJ flown: drawn is 10 kJ, and no battery was swapped."""
    account = new()
    account.report(share(0.0, 0.40), armed=False)
    for k in range(1, 31):
        account.book(1000)
        account.report(share(float(k), 0.40 + 0.01 * k if rises else 0.40), armed=False)
    top = 0.70 if rises else 0.40
    for k in range(1, 11):
        account.report(share(60.0 + k, top - 0.01 * k), armed=True)
    assert not account.facts
    assert account.drawn_j == pytest.approx(10_000.0)


def test_a_battery_that_is_swapped_at_the_base_gains_only_what_the_book_does_not_explain() -> None:
    account = new()
    account.report(share(0.0, 0.20), armed=False)
    account.book(50_000)
    account.report(share(30.0, 1.00), armed=False)
    assert [fact.gained_j for fact in account.facts] == [pytest.approx(30_000.0)]


def test_a_px4_without_a_current_sensor_is_read_by_its_share() -> None:
    """As a PX4 1.17 in its own simulator says it: minus one ampere all the while, and half of its charge gone."""
    account = new(1000.0)
    for second, percent in enumerate((100, 75, 50)):
        content = status(voltages=[16200, *CELLS[1:]], current_battery=-100, battery_remaining=percent)
        account.report(content._replace(time_s=float(second)), armed=True)
    assert (str(account.source), account.drawn_j) == ("battery_remaining", pytest.approx(500.0))


def test_what_an_autopilot_drew_before_the_session_is_not_the_sessions() -> None:
    """Switched on long ago, 50 kJ of 100 drawn; 700 J more until the end. A parameter may tell its charge at first."""
    for told_charge in (False, True):
        account = BatteryAccount(CAPACITY_J, CAPACITY_J, from_now=True)
        if told_charge:
            account.parameter("SIM_BAT_INIT_J", CAPACITY_J)
        for time_s, consumed_j in ((1.0, 50_000.0), (2.0, 50_300.0), (3.0, 50_700.0)):
            account.report(BatteryReport(time_s, consumed_j, None, 1.0 - consumed_j / CAPACITY_J), armed=True)
        assert account.drawn_j == pytest.approx(700.0)
        assert account.initial_j == pytest.approx(50_000.0)
        assert account.remaining_j == pytest.approx(49_300.0)


def test_what_cannot_be_is_not_taken_in_and_named() -> None:
    account, _ = heard(BatteryReport(0.0, 100.0, 50.0, None))
    assert "draws 2e+05 W" in account.report(BatteryReport(1.0, 200.0, 2e5, None), armed=True)
    assert "drawn 1e+06 J" in account.report(BatteryReport(1.0, 1e6, 50.0, None), armed=True)  # a MW since then
    assert "given -1 J" in account.counter(GIVEN, -1, 1.0)
    assert "holds 0 J" in account.parameter("SIM_BAT_CAP_J", 0.0)
    assert (account.drawn_j, account.given_j, account.capacity_j) == (100.0, 0, CAPACITY_J)


@pytest.mark.parametrize(("loss_j", "believed"), [(8e6, True), (1.7e7, False)])
def test_a_battery_may_lose_at_once_what_it_holds_and_no_more(loss_j: float, believed: bool) -> None:
    account = new(1.6e7)
    account.report(BatteryReport(1.0, 1000.0, None, None), armed=True)
    assert (not account.report(BatteryReport(1.5, 1000.0 + loss_j, None, None), armed=True)) is believed


# one by one, as a session hears them, and all at once, as a reader takes them


@given(st.lists(WORDS))
def test_reports_taken_at_once_leave_what_each_of_them_would(words: list[Any]) -> None:
    """A recording's reports, cut where the vehicle was armed or disarmed; NaN after those that do not count."""
    one_by_one, at_once = BatteryAccount(CAPACITY_J, 0.0, from_now=True), BatteryAccount(CAPACITY_J, 0.0, from_now=True)
    for armed, group in itertools.groupby(enumerate(words), key=lambda word: word[1][-1]):
        told = [BatteryReport(1.7 * k, *(word[:3]), second_hand=word[3]) for k, word in group]
        columns = [np.array(column, dtype=np.float64) for column in zip(*told, strict=True)]
        left_j = at_once.reports(BatteryReports(*columns[:4], columns[4] > 0.0), armed=armed)
        for report, at_once_j in zip(told, left_j, strict=True):
            one_by_one.report(report, armed=armed)
            assert np.isnan(at_once_j) or at_once_j == one_by_one.remaining_j
        assert at_once.remaining_j == one_by_one.remaining_j
