"""How well each vehicle is heard, so far and lately."""

import numpy as np
import pytest

from gcs.frame_spans import FrameSpans
from gcs.link.quality import LinkQuality, copies
from gcs.mavlink.datagram import AnswerRuns
from gcs.mavlink.frame_runs import COLUMNS, FIRST, LAST, SYSID
from gcs.mavlink.gaps import GapCounter


class Radio:
    """Numbers of two vehicles' frames, ten a second each; of vehicle 2 the first `lost` of a second never come."""

    def __init__(self) -> None:
        self.gaps = GapCounter()
        self.quality = LinkQuality(self.gaps)
        self.sent = 0

    def second(self, lost: int = 0) -> None:
        now_s = self.sent / 10 + 1.0
        for k in range(self.sent, self.sent + 10):
            self.gaps.feed(1, 1, k % 256)
            if k % 10 >= lost:
                self.gaps.feed(2, 1, k % 256)
        self.quality.count(1, 10, now_s)
        self.quality.count(2, 10 - lost, now_s)
        self.sent += 10


def test_the_share_is_that_of_the_last_ten_seconds() -> None:
    radio = Radio()
    assert radio.quality.lost_share(2) is None
    radio.second()
    assert radio.quality.lost_share(2) == 0.0
    for _ in range(30):
        radio.second(lost=4)
    assert radio.quality.lost_share(2) == pytest.approx(0.4)
    assert radio.quality.lost_share(1) == 0.0
    for _ in range(11):
        radio.second()
    assert radio.quality.lost_share(2) == 0.0
    assert radio.quality.lost(2) == 120


def test_one_that_says_nothing_any_more_has_no_share() -> None:
    radio = Radio()
    radio.second()
    for k in range(2, 30):
        radio.quality.count(2, 0, float(k))
    assert radio.quality.lost_share(2) is None


def runs(*frames: tuple[int, int]) -> AnswerRuns:
    """Runs of so many frames, as (system id, number)."""
    rows = np.zeros((len(frames), COLUMNS), np.int64)
    for row, (sysid, count) in zip(rows, frames, strict=True):
        row[SYSID], row[FIRST], row[LAST] = sysid, 3, 3 + count
    return AnswerRuns(FrameSpans(b"", np.empty((0, 2), np.int64)), rows)


def test_runs_count_as_frames_one_by_one_do_also_where_none_or_another_vehicle_answers() -> None:
    together, one_by_one = Radio(), Radio()
    for tick in range(1, 400):
        now_s = 0.1 * tick
        answers = [] if tick == 57 else [(1, 4)] if tick < 120 else [(1, 4), (2, 2)]
        together.quality.count_runs(runs(*answers), now_s)
        for sysid, count in answers:
            one_by_one.quality.count(sysid, count, now_s)
        if tick % 50 == 0:
            for radio in (together, one_by_one):
                radio.gaps.lost_of[1] = radio.gaps.lost_of.get(1, 0) + 5
        if not 119 < tick < 131:  # one that joins is sampled with the others
            assert together.quality.lost_share(1) == one_by_one.quality.lost_share(1)
            assert together.quality.lost_share(2) == one_by_one.quality.lost_share(2)


@pytest.mark.parametrize("share", [0.05, 0.1, 0.2, 0.3])
def test_of_all_copies_at_most_three_in_a_hundred_are_lost_and_no_more_are_sent_than_that_needs(share: float) -> None:
    assert share ** copies(share) <= 0.03 + 1e-12
    assert share ** (copies(share) - 1) > 0.03


def test_a_good_link_gets_one_and_a_dead_one_three() -> None:
    assert [copies(share) for share in (None, 0.0, 0.049, 0.9, 1.0)] == [1, 1, 1, 3, 3]
