"""One digest on every processor: sessions flown as if the machine's had fewer instructions.

`test_demo.py` flies the demo so; `test_wheel.py` and `test_paper.py` fly with all of this processor's instructions.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from sessions import DIGESTS, SIMPLER, fly_apart


@pytest.mark.parametrize("scenario", ["paper/example1", "paper/example3", "paper/example4"])
def test_a_session_has_one_digest_on_every_processor(
    scenario: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, value in SIMPLER.items():
        monkeypatch.setenv(name, value)
    outcome = fly_apart(scenario, tmp_path, "--lockstep", "--quiet")
    assert outcome.summary["digest"].startswith(f"sha256:{DIGESTS[scenario]}")
