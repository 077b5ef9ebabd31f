"""What a process gathers before it forks others is the same memory, whether or not the kernel has huge pages."""

from __future__ import annotations

import numpy as np

from skytender.loading import HUGE_BYTES, gathered

SEED = 12


def test_gathered_memory_holds_what_it_held_and_can_be_written() -> None:
    content = np.random.default_rng(SEED).integers(0, 256, 4 * HUGE_BYTES, np.uint8)
    before = content.tobytes()
    gathered()
    assert content.tobytes() == before
    content[::4096] ^= 255
    assert np.array_equal(content[1:4096], np.frombuffer(before, np.uint8)[1:4096])
    assert content[4096] == before[4096] ^ 255
