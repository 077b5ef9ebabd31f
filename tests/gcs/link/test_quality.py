"""How well each vehicle is heard, so far and lately."""

import pytest

from gcs.link.quality import LinkQuality, copies
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


def test_what_is_lost_is_counted_by_vehicle() -> None:
    radio = Radio()
    radio.second()
    for _ in range(5):
        radio.second(lost=3)
    assert (radio.quality.lost(1), radio.quality.lost(2)) == (0, 15)
    assert radio.gaps.lost == 15


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


@pytest.mark.parametrize("share", [0.05, 0.1, 0.2, 0.3])
def test_of_all_copies_at_most_three_in_a_hundred_are_lost_and_no_more_are_sent_than_that_needs(share: float) -> None:
    assert share ** copies(share) <= 0.03 + 1e-12
    assert share ** (copies(share) - 1) > 0.03


def test_a_good_link_gets_one_and_a_dead_one_three() -> None:
    assert [copies(share) for share in (None, 0.0, 0.049, 0.9, 1.0)] == [1, 1, 1, 3, 3]
