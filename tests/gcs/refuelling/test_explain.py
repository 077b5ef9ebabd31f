"""Competition and services for a person: numbers that agree with geometry, and sentences that say the reason."""

import math
from dataclasses import replace

import pytest
from views import snapshot, view

from gcs.mavlink.command_protocol import CommandResult, CommandTarget
from gcs.refuelling.bidding import CompetitionState
from gcs.refuelling.explain import acknowledged, competition_of, history_of, rendezvous_ned, why
from gcs.refuelling.service import Phase, Service
from gcs.scenario.model import CompetitionRules, RefuellingRules

RULES = RefuellingRules(hold_s=1.0, reserve_s=20.0)
COMPETITION = CompetitionRules(bids="need", dwell_s=2.0, decide_within_s=30.0)
RECEIVER = view(3, p_ned=(10.0, 0.0, -4.0), v_ned=(0.0, 1.0, 0.0))
TANKER = view(20, "tanker", p_ned=(0.0, 0.0, -5.2))


def service(by: str = "competition", **changed: object) -> Service:
    made = Service(1, 3, 20, by, {3: 1.0}, 90.0, need=0.71, share=0.93, meets_in_s=14.0)
    return replace(made, **changed)  # type: ignore[arg-type]


def test_the_place_of_meeting_is_where_both_arrive_at_once() -> None:
    place = rendezvous_ned(service(), snapshot(RECEIVER, TANKER), 1.2, 2.0)
    assert place is not None
    # From 10 m ahead, crossing at 1 m/s: 4 t² = 100 + t², t = √(100/3).
    assert place == pytest.approx((10.0, (100.0 / 3.0) ** 0.5, -5.2))


def test_once_joined_the_place_is_above_the_receiver() -> None:
    assert rendezvous_ned(service(phase=Phase.TRANSFER), snapshot(RECEIVER, TANKER), 1.2, 2.0) == (10.0, 0.0, -5.2)
    lost = snapshot(RECEIVER._replace(p_ned=None), TANKER)
    assert rendezvous_ned(service(), lost, 1.2, 2.0) is None


@pytest.mark.parametrize(
    ("by", "words"),
    [
        ("competition", "its need 0.71 is the largest and it held 93 % of the competition for 2 s"),
        ("timeout", "no vehicle held 90 % of the competition within 30 s"),
        ("urgency", "it would be empty within 21 s of the rendezvous"),
        ("operator", "the operator asked for it"),
        ("policy", "the policy winner_take_all chose it"),
    ],
)
def test_why_is_one_sentence_with_the_reason_and_the_time_left(by: str, words: str) -> None:
    text = why(service(by), snapshot(RECEIVER, TANKER), RULES, COMPETITION)
    assert text.startswith("Pursuer 3 is refuelled next: ")
    assert words in text
    assert text.endswith("; tanker 20 meets it in 4 s.")  # decided at 90 s with 14 s to go, and it is 100 s
    joined = replace(service(by), phase=Phase.TRANSFER, joined_at_s=99.0)
    later = why(joined, snapshot(RECEIVER, TANKER), RULES, COMPETITION)
    assert "meets" not in later
    assert later.startswith("Pursuer 3 is refuelled now: ")


def test_why_by_effort_names_what_competed() -> None:
    rules = COMPETITION.model_copy(update={"bids": "effort"})
    text = why(service(share=0.99991), snapshot(RECEIVER, TANKER), RULES, rules)
    assert "had used most control effort since it last received energy, and held 99.99 % of the competition" in text


@pytest.mark.parametrize(
    ("gain", "words"),
    [
        (math.inf, "if another were served first, at least 1.0 vehicles more would likely be lost (its need 0.71)"),
        (4.0, "if another were served first, 0.5 vehicles more would likely be lost"),
        (0.0, "no order of services that begins with another is likely to lose fewer vehicles"),
        (None, "it won the competition of the vehicles"),
    ],
)
def test_why_by_losses_says_how_many_vehicles_more_would_be_lost(gain: float | None, words: str) -> None:
    rules = COMPETITION.model_copy(update={"bids": "losses"})
    assert words in why(service(gain=gain), snapshot(RECEIVER, TANKER), RULES, rules)


def test_the_runner_up_is_the_next_behind_the_leader() -> None:
    competition_state = CompetitionState({1: 0.2, 2: 0.9, 3: 0.5}, {1: 0.1, 2: 1.0, 3: 0.8}, {}, 2, 0.8)
    told = competition_of(competition_state, COMPETITION)
    assert (told["leader"], told["runner_up"], told["share"], told["threshold"]) == (2, 3, 0.8, 0.9)
    assert told["v"] == {"1": 0.2, "2": 0.9, "3": 0.5}
    nobody = competition_of(CompetitionState(), COMPETITION)
    assert (nobody["leader"], nobody["runner_up"], nobody["share"]) == (None, None, None)


def test_the_history_is_the_last_twenty_that_ended() -> None:
    services = [service(number=k, phase=Phase.DONE, ended_by="full") for k in range(25)] + [service()]
    told = history_of(services)
    assert len(told) == 20
    assert told[0]["reason"] == "full"


def result(outcome: str, code: int | None, token: str) -> CommandResult:
    return CommandResult(176, CommandTarget(3, 1), outcome, code, 4, token)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("ended", "text"),
    [
        (result("accepted", 0, "operator hold"), "Hold accepted"),
        (result("rejected", 1, "operator return"), "Return refused: temporarily rejected"),
        (result("timeout", None, "operator land"), "Land was not acknowledged, though it was sent 4 times"),
        (result("accepted", 0, "pilot arm"), "Command 176 (pilot arm) was accepted"),
        (result("rejected", 2, "pilot arm"), "Command 176 (pilot arm) was refused (result 2, denied)"),
        (result("timeout", None, "pilot arm"), "Command 176 (pilot arm) timed out"),
    ],
)
def test_acknowledgements_are_told_in_words(ended: CommandResult, text: str) -> None:
    assert acknowledged(ended) == text
