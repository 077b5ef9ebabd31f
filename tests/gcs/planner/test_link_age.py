"""Silence, told by how old reports usually are."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import pytest

from gcs.planner.link_age import LinkAge, SlowLinks

PERIOD_S = 0.1


def silent_at(ages_s: Iterable[float]) -> list[bool]:
    """Whether the vehicle is silent, period by period, where its reports are so old."""
    link, told = LinkAge(1), []
    for age_s in ages_s:
        link.receive(np.array([age_s]), PERIOD_S)
        told.append(bool(link.silent[0]))
    return told


def outage(before: list[float]) -> int:
    """Periods without a report until a vehicle is silent whose reports were so old before."""
    told = silent_at(before + [before[-1] + PERIOD_S * k for k in range(1, 15)])[len(before) - 1 :]
    return told.index(True)


def test_a_link_that_brings_a_report_each_period_is_out_after_four_without() -> None:
    assert outage([0.0] * 300) == 4


@pytest.mark.parametrize("delay_s", [0.2, 0.5])
def test_delay_alone_is_no_silence(delay_s: float) -> None:
    assert outage([delay_s] * 200) == pytest.approx((0.2 + 0.5 * delay_s) / PERIOD_S, abs=1.0)


def test_losses_that_were_seen_before_are_no_silence() -> None:
    """Three reports in ten are lost: gaps of up to 0.5 s are usual."""
    rng = np.random.default_rng(1)
    ages: list[float] = []
    for lost in rng.random(3000) < 0.3:
        ages.append(ages[-1] + PERIOD_S if lost and ages else 0.0)
    assert np.mean(silent_at(ages)) < 3e-3


def test_a_second_without_a_report_is_silence_on_any_link() -> None:
    assert outage([0.1 * (k % 10) for k in range(200)] + [0.0]) <= 11


def test_who_is_back_is_not_silent() -> None:
    assert silent_at([0.0] * 5 + [0.1 * k for k in range(1, 300)] + [0.0])[-2:] == [True, False]


@pytest.mark.parametrize(
    ("ages_s", "slow"),
    [
        ([0.5] * 20, True),
        ([0.0] * 20, False),
        ([0.0, 0.5, 0.5, 0.5] * 20, False),
        ([0.0] * 20 + [0.1 * k for k in range(1, 15)], False),
        ([0.5] * 20 + [0.0], False),
        ([], False),
    ],
)
def test_a_link_is_slow_whose_newest_reports_are_old(ages_s: list[float], slow: bool) -> None:
    links = SlowLinks(1)
    for age_s in ages_s:
        links.receive(np.array([age_s]), PERIOD_S)
    assert links.slow().tolist() == [slow]
