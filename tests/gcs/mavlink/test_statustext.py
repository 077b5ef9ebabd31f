"""Texts in chunks as vehicles send them; what a PX4 says is as one was heard to say it."""

from __future__ import annotations

import itertools
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v10 import ardupilotmega as mavlink1
from pymavlink.dialects.v20 import ardupilotmega as mavlink2

from gcs.mavlink import codec
from gcs.mavlink.statustext import CHUNK_BYTES, MOST_BYTES, PATIENCE_S, TextChunk, Texts, chunk_of, recorded
from simvehicle.mavlink import codec as vehicle_codec
from simvehicle.mavlink import dispatcher

FIRST = "Arming denied: Resolve system health failures firs"


def chunk(text: str | bytes, text_id: int = 0, seq: int = 0, severity: int = 2) -> TextChunk:
    return TextChunk(severity, text if isinstance(text, bytes) else text.encode(), text_id, seq)


def chunks(text: bytes, text_id: int) -> list[TextChunk]:
    """As MAVLink asks: the last one is not full."""
    return [chunk(text[at : at + 50], text_id, at // 50) for at in range(0, len(text) + 1, 50)]


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
    assert texts.add(chunk(FIRST), 1.0) == [(2, FIRST)]
    assert texts.add(chunk(FIRST[::-1], severity=6), 1.0) == [(2, FIRST)]
    assert texts.add(chunk("Short", severity=6), 1.1) == [(6, FIRST[::-1]), (6, "Short")]


def test_a_text_whose_end_is_lost_is_told_as_far_as_it_came_before_the_next() -> None:
    texts = Texts()
    texts.add(chunk(FIRST, 3), 1.0)
    assert texts.add(chunk("Armed", 4, severity=6), 1.1) == [(2, FIRST), (6, "Armed")]


def test_endless_chunks_are_one_text_of_bounded_length() -> None:
    texts, told = Texts(), []
    for seq in range(5000):
        told += texts.add(chunk("x" * CHUNK_BYTES, 7, seq if not seq else seq % 255 or 1), 0.001 * seq)
    assert told == [(2, "x" * MOST_BYTES)]
    assert texts.overdue(99.0) == []
    assert texts.add(chunk("Next", 7), 99.0) == [(2, "Next")]


WORDS = st.text(st.characters(exclude_categories=("Cs", "Cc", "Z"), exclude_characters="\0"), min_size=1)


@settings(max_examples=100)
@given(WORDS.filter(lambda text: len(text.encode()) < MOST_BYTES - 50), st.randoms(), st.integers(1, 65535))
def test_any_text_comes_whole_in_whatever_order_its_chunks_come(text: str, rng: Any, text_id: int) -> None:
    sent = chunks(text.encode(), text_id)
    rng.shuffle(sent)
    texts, told = Texts(), []
    for at, one in enumerate(sent):
        assert not told
        told += texts.add(one, 1.0)
        if at < len(sent) - 1:
            told += texts.add(one, 1.0)  # it comes twice
    assert told == [(2, text)]


@settings(max_examples=50)
@given(st.integers(2, 8), st.data())
def test_the_place_of_each_lost_run_of_chunks_is_marked(count: int, data: st.DataObject) -> None:
    sent = chunks(b"".join(bytes([65 + k]) * 50 for k in range(count)) + b"end", 9)
    kept = data.draw(st.sets(st.integers(0, count - 1), max_size=count - 1)) | {count}
    texts = Texts()
    for seq in data.draw(st.permutations(sorted(kept))):
        assert texts.add(sent[seq], 1.0) == []
    runs = [list(run) for _, run in itertools.groupby(range(count + 1), key=kept.__contains__)]
    expected = "".join("…" if run[0] not in kept else "".join(sent[k].text.decode() for k in run) for run in runs)
    assert texts.overdue(1.0 + PATIENCE_S) == [(2, expected)]


def test_a_character_that_lies_across_two_chunks_is_one() -> None:
    text = "a" * 49 + "ö" + "b" * 10
    assert list(recorded((0.0, one) for one in chunks(text.encode(), 3))) == [(0.0, 2, text)]


@pytest.mark.parametrize("raw", [b"", b"Armed", b"n" * 49, b"n" * 50, "Höhe 12 m ✓".encode(), b"old\0hidden"])
def test_a_frame_of_either_version_holds_pymavlinks_bytes(raw: bytes) -> None:
    for module, extra in ((mavlink1, ()), (mavlink2, (513, 3))):
        packed = module.MAVLink_statustext_message(4, raw, *extra).pack(module.MAVLink(None, 1, 1))
        split = codec.split(bytes(packed))
        (frame,) = split.frames + split.older
        assert chunk_of(frame) == (4, raw.ljust(50, b"\0"), *(extra or (0, 0)))
        content = codec.fields(frame)
        assert content.text == raw.partition(b"\0")[0].decode()
    assert Texts().add(chunk(raw[:49]), 0.0) == [(2, raw[:49].partition(b"\0")[0].decode())]


def test_bytes_that_are_no_utf_8_are_marked_and_cost_no_more() -> None:
    assert Texts().add(chunk("Höhe 12 m".encode("latin1")), 0.0) == [(2, "H\ufffdhe 12 m")]


@settings(max_examples=50)
@given(WORDS)
def test_what_a_simulated_vehicle_says_comes_whole(text: str) -> None:
    text = text.encode()[: MOST_BYTES - 50].decode("utf-8", "ignore")
    texts, told = Texts(), []
    for message in dispatcher._status_texts(6, text, 4):
        raw = vehicle_codec.encode(message, seq=0, sysid=1, compid=1)
        told += texts.add(chunk_of(codec.split(raw).frames[0]), 0.0)
    assert told + texts.give_up() == [(6, text)]
