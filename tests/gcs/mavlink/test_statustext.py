"""Texts in chunks as vehicles send them; what a PX4 says is as one was heard to say it."""

from types import SimpleNamespace

import pytest

from gcs.mavlink.statustext import CHUNK_CHARACTERS, MOST_CHARACTERS, PATIENCE_S, Texts

FIRST = "Arming denied: Resolve system health failures firs"


def chunk(text: str, text_id: int = 0, seq: int = 0, severity: int = 2) -> SimpleNamespace:
    return SimpleNamespace(severity=severity, text=text, id=text_id, chunk_seq=seq)


@pytest.mark.parametrize("text_id", [0, 7])
def test_a_px4s_text_is_one_also_where_it_is_its_first_and_has_the_id_0(text_id: int) -> None:
    texts = Texts()
    assert texts.add(chunk(FIRST, text_id), 1.0) == []
    assert texts.add(chunk("t\t", text_id, 1), 1.0) == [(2, "Arming denied: Resolve system health failures first")]
    assert texts.overdue(9.0) == []


@pytest.mark.parametrize("text_id", [0, 7])
def test_a_text_that_fills_its_last_chunk_is_told_a_moment_later(text_id: int) -> None:
    texts = Texts()
    assert texts.add(chunk(FIRST, text_id), 1.0) == []
    assert texts.overdue(1.0 + 0.9 * PATIENCE_S) == []
    assert texts.overdue(1.0 + PATIENCE_S) == [(2, FIRST)]
    assert texts.overdue(9.0) == []


def test_two_full_texts_without_an_id_are_two() -> None:
    texts = Texts()
    assert texts.add(chunk(FIRST), 1.0) == []
    assert texts.add(chunk(FIRST[::-1], severity=6), 1.0) == [(2, FIRST)]
    assert texts.add(chunk("Short", severity=6), 1.1) == [(6, FIRST[::-1]), (6, "Short")]


def test_a_text_whose_end_is_lost_is_told_as_far_as_it_came_before_the_next() -> None:
    texts = Texts()
    texts.add(chunk(FIRST, 3), 1.0)
    assert texts.add(chunk("Armed", 4, severity=6), 1.1) == [(2, FIRST), (6, "Armed")]


def test_endless_chunks_are_one_text_of_bounded_length() -> None:
    texts, told = Texts(), []
    for seq in range(5000):
        told += texts.add(chunk("x" * CHUNK_CHARACTERS, 7, seq % 255 or 1), 0.001 * seq)
    assert told == [(2, "x" * MOST_CHARACTERS)]
    assert texts.overdue(99.0) == []
    assert texts.add(chunk("Next", 7), 99.0) == [(2, "Next")]


def test_chunks_of_other_ids_after_an_endless_text_are_heard() -> None:
    texts = Texts()
    for seq in range(20):
        texts.add(chunk("x" * CHUNK_CHARACTERS, 7, seq), 0.0)
    assert texts.add(chunk("Other", 8), 0.1) == [(2, "Other")]
