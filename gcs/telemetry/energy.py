"""How a battery is accounted, from whatever an autopilot reports of it (docs/protocol/energy.md#energy-accounting).

Three meters of the energy drawn, the best first; a vehicle's source is the best one that has spoken within GAP_S:

1. energy_consumed: the autopilot's own total;
2. current_voltage: its power V I, integrated by trapezoids over its samples in session time;
3. battery_remaining: the sum of all falls of the share that is left, times the capacity. Its steps are whole per cent.

Rules:
- Energy drawn never falls. When the source changes it goes on from where it was, with the new meter's progress since.
- Samples of power more than GAP_S apart are bridged by the mean of both ends, which is a trapezoid too: a per cent of
  most batteries is more than what a short gap can be wrong by. Each bridge is a fact.
- A total that falls back while the vehicle is disarmed is an autopilot that was restarted: it goes on from the old one.
- A share that rises is no energy drawn back. Energy that the vehicle itself says it received raises what is expected of
  it. On the ground, disarmed, a rise is first explained by energy that was booked for it elsewhere (a base), and what
  is left, from SWAP_SHARE of the capacity on, is a battery that was swapped: a fact, with the energy that it brought.
- The first share says what the battery held at the start, unless the vehicle has said so.

The rules are compiled: a session calls them with each report (from its frame: gcs/telemetry/readings.py) and a reader
with all reports between two other messages. An account is a struct, in energy.pxd. NaN stands for what is not known.
"""

from __future__ import annotations

from enum import StrEnum
from typing import Any

import numpy as np
from cython.cimports.gcs.telemetry.energy import (
    COUNTED,
    DRAWN,
    IMPOSSIBLE_POWER,
    IMPOSSIBLE_TOTAL,
    METERS,
    MOST_HISTORY,
    NONE,
    POWER,
    SECOND_HAND,
    SHARE,
    TOTAL,
    Outcome,
    _blank,
    accounts_of,
)
from cython.cimports.gcs.telemetry.plausibility import countable
from cython.cimports.libc.math import INFINITY, NAN, fabs, isnan
from numpy.typing import NDArray

from gcs.telemetry.plausibility import MOST_W, STEP_J

GAP_S = 5.0
_GAP_S = GAP_S
_SWAP_SHARE = 0.2
_SWAP_AFTER_S = 30.0  # [choice] since it was last armed: no battery is changed, and no autopilot booted, more quickly
_RESTART_J = 1000.0  # a total that falls by less has been overtaken on the air
_POWER_WINDOW_S = 5.0
_STEPS_WINDOW_S = 120.0  # power by battery_remaining is estimated from the steps of so long a time: they are few
_JUMP_J = 1000.0  # [choice] far above the 100 J in which a total is told, far below what a fault of a battery takes
_MOST_W, _STEP_J = MOST_W, STEP_J


class EnergySource(StrEnum):
    """Which of an autopilot's words the energy drawn is read from; the best first."""

    NONE = "none"
    ENERGY_CONSUMED = "energy_consumed"
    CURRENT_VOLTAGE = "current_voltage"
    BATTERY_REMAINING = "battery_remaining"


SOURCES = tuple(EnergySource)
# MOST_HISTORY reports are enough for the mean power of either window: of more the oldest are forgotten.

ACCOUNT = np.asarray(_blank()).dtype
"""The struct Account as NumPy has it."""


def new_account(capacity_j: float, initial_j: float, *, from_now: bool = False) -> NDArray[Any]:
    """(1,) an account before its first report; `initial_j` holds until the first share says better."""
    account = np.zeros(1, ACCOUNT)
    for name in ("meters_j", "anchors_j", "first_hand_s", "sample_s", "expected_j", "share"):
        account[name] = NAN
    account["spoke_s"] = account["armed_s"] = -INFINITY
    account["believed_j"] = account["told_j"] = INFINITY
    account["capacity_j"], account["initial_j"] = capacity_j, initial_j
    account["from_now"], account["swappable"] = from_now, True
    return account


def count(
    one: Any, t_s: float, consumed_j: float, power_w: float, remaining: float, second_hand: bool, armed: bool
) -> Any:
    """As `take`, of an account's record."""
    bridged_s, gained_j = NAN, NAN
    total, power, share = not isnan(consumed_j), not isnan(power_w), not isnan(remaining)
    if fabs(power_w) > _MOST_W:
        return Outcome(IMPOSSIBLE_POWER, bridged_s, gained_j)
    if total:
        if not countable(consumed_j, one.believed_j, t_s - one.believed_s, max(_STEP_J, one.capacity_j)):
            return Outcome(IMPOSSIBLE_TOTAL, bridged_s, gained_j)
        one.believed_j, one.believed_s = consumed_j, t_s
    if isnan(one.first_hand_s):
        one.first_hand_s = t_s
    if second_hand and t_s - one.first_hand_s <= _GAP_S:
        return Outcome(SECOND_HAND, bridged_s, gained_j)
    before_j = one.before_j
    if total:
        _total(one, consumed_j, armed)
        one.spoke_s[TOTAL] = t_s
    if power:
        bridged_s = _integrate(one, t_s, max(power_w, 0.0))
        one.spoke_s[POWER] = t_s
    left_j = remaining * one.capacity_j
    if share:
        one.share = remaining
        gained_j = _fall(one, t_s, left_j, armed)
        one.spoke_s[SHARE] = t_s
    if (total or power or share) and not second_hand:
        one.first_hand_s = t_s
    became = COUNTED
    for best in range(TOTAL, METERS):
        if t_s - one.spoke_s[best] <= _GAP_S:
            if (total and best == TOTAL) or (power and best == POWER) or (share and best == SHARE):
                _draw(one, best)
                became = DRAWN
            break
    if one.initial_known:
        one.initial_j -= one.before_j - before_j  # it was reported when the vehicle was switched on
    elif share:
        one.initial_j = left_j + one.drawn_j + one.given_j - one.received_j
        one.initial_known = 1
    if not isnan(gained_j):
        gained_j = min(gained_j, one.capacity_j - (one.initial_j + one.received_j - one.drawn_j - one.given_j))
        one.initial_j += gained_j
    if armed:
        one.armed_s = t_s
    return Outcome(became, bridged_s, gained_j)


def mean_power(one: Any, now_s: float) -> Any:
    """Bring the mean power of the last while up to a report whose fate is DRAWN, over steps of the energy drawn
    where it moves in steps; whether another source is read now.

    A jump is no power: where a report with a power comes, and more than twice what the power amounted to is gone,
    charge was lost at once; the last mean holds until reports after it give another.
    """
    other = one.power_source != one.source
    if other:
        one.power_source = one.source
        one.history = 0
    in_steps = one.source == SHARE
    newest = (one.oldest + one.history - 1) % MOST_HISTORY
    if in_steps and one.history > 0 and one.drawn_then_j[newest] == one.drawn_j:
        return other
    metered_j = one.meters_j[POWER] - one.metered_then_j
    if one.spoke_s[POWER] == now_s and one.drawn_j - one.drawn_then_j[newest] > 2.0 * metered_j + _JUMP_J:
        one.history = 0
    one.metered_then_j = one.meters_j[POWER]
    if one.history == MOST_HISTORY:
        one.oldest = (one.oldest + 1) % MOST_HISTORY
        one.history -= 1
    newest = (one.oldest + one.history) % MOST_HISTORY
    one.drawn_at_s[newest], one.drawn_then_j[newest] = now_s, one.drawn_j
    one.history += 1
    window_s = _STEPS_WINDOW_S if in_steps else _POWER_WINDOW_S
    while one.history > 2 and now_s - one.drawn_at_s[(one.oldest + 1) % MOST_HISTORY] >= window_s:
        one.oldest = (one.oldest + 1) % MOST_HISTORY
        one.history -= 1
    span_s = now_s - one.drawn_at_s[one.oldest]
    if span_s > 0.0:
        one.power_w = (one.drawn_j - one.drawn_then_j[one.oldest]) / span_s
    return other


def _draw(one: Any, best: int) -> None:
    """Let the energy drawn go on by what the best meter went on since its anchor.

    Lesser meters' anchors move along, so that they would go on from here; a better one that is silent keeps its own,
    for it will know what was drawn meanwhile.
    """
    if one.source != best:
        if one.source == NONE:
            one.before_j = one.meters_j[best] if one.from_now else 0.0
            one.anchors_j[best], one.at_anchors_j[best] = one.before_j, 0.0
        one.source = best
    if not isnan(one.anchors_j[best]):
        one.drawn_j = max(one.drawn_j, one.at_anchors_j[best] + one.meters_j[best] - one.anchors_j[best])
    for source in range(best, METERS):
        if not isnan(one.meters_j[source]):
            one.anchors_j[source], one.at_anchors_j[source] = one.meters_j[source], one.drawn_j


def _total(one: Any, consumed_j: float, armed: bool) -> None:
    if not armed and consumed_j < min(one.total_j - _RESTART_J, 0.5 * one.total_j):
        one.before_restart_j += one.total_j
        one.total_j = 0.0
    one.total_j = max(one.total_j, consumed_j)
    one.meters_j[TOTAL] = one.before_restart_j + one.total_j


def _integrate(one: Any, t_s: float, power_w: float) -> Any:
    """Span in s that had to be bridged, or NaN."""
    span_s = t_s - one.sample_s
    if isnan(span_s):
        one.meters_j[POWER] = 0.0
    elif span_s <= 0.0:
        return NAN
    else:
        one.meters_j[POWER] += 0.5 * (one.sample_w + power_w) * span_s
    one.sample_s, one.sample_w = t_s, power_w
    return span_s if span_s > _GAP_S else NAN


def _fall(one: Any, t_s: float, left_j: float, armed: bool) -> Any:
    """J that a swapped battery brought, or NaN."""
    moved_j = one.received_j - one.booked_j - one.given_j
    if isnan(one.expected_j):
        one.expected_j = one.initial_j + moved_j if one.initial_known else left_j
        one.moved_j, one.seen_booked_j = moved_j, one.booked_j
        one.meters_j[SHARE] = 0.0
    one.expected_j += moved_j - one.moved_j
    one.unseen_j += one.booked_j - one.seen_booked_j
    one.moved_j, one.seen_booked_j = moved_j, one.booked_j
    rise_j = left_j - one.expected_j
    if rise_j <= 0.0:
        one.meters_j[SHARE] -= rise_j
        one.expected_j = left_j
    elif not armed:
        gained_j = rise_j - one.unseen_j
        if one.swappable and gained_j >= _SWAP_SHARE * one.capacity_j:
            one.expected_j, one.unseen_j = left_j, 0.0
            return gained_j if t_s - one.armed_s >= _SWAP_AFTER_S else NAN
        if one.unseen_j > 0.0:
            one.expected_j, one.unseen_j = left_j, max(one.unseen_j - rise_j, 0.0)
    return NAN


def take(
    account: NDArray[Any],
    t_s: float,
    consumed_j: float,
    power_w: float,
    remaining: float,
    second_hand: bool,
    armed: bool,
) -> tuple[int, float, float]:
    """Count one report: its fate; then NaN, or the span in s over which power was bridged, and the J that a swapped
    battery brought."""
    one = accounts_of(account)
    outcome = count(one, t_s, consumed_j, power_w, remaining, second_hand, armed)
    if outcome.became == DRAWN:
        mean_power(one, t_s)
    return outcome.became, outcome.bridged_s, outcome.gained_j


def take_all(
    account: NDArray[Any],
    t_s: NDArray[np.float64],
    consumed_j: NDArray[np.float64],
    power_w: NDArray[np.float64],
    remaining: NDArray[np.float64],
    second_hand: NDArray[np.uint8],
    armed: bool,
    left_j: NDArray[np.float64],
) -> None:
    """Count reports (n,) in their order; `left_j` (n,) becomes the energy in the battery after each, NaN where a report
    does not count."""
    one = accounts_of(account)
    for i in range(t_s.shape[0]):
        outcome = count(one, t_s[i], consumed_j[i], power_w[i], remaining[i], second_hand[i], armed)
        left_j[i] = NAN
        if outcome.became >= COUNTED:
            left_j[i] = one.initial_j + one.received_j - one.drawn_j - one.given_j
