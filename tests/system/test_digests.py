"""One digest on every processor: sessions flown as if the machine's had fewer instructions."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from sessions import DIGESTS, GCS

SIMPLER = {
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F",
    "NPY_DISABLE_CPU_FEATURES": " ".join(np.show_config(mode="dicts")["SIMD Extensions"].get("found", ())),
}
"""Environment in which the C library and NumPy take what every processor of this architecture can do."""


def flown(scenario: str, out: Path, environment: dict[str, str]) -> str:
    command = [*GCS, "run", scenario, "--lockstep", "--quiet", "--no-report", "--out", str(out / "flown")]
    subprocess.run(command, env={**os.environ, **environment}, check=True, capture_output=True)
    digest: str = json.loads((out / "flown" / "summary.json").read_text())["digest"]
    return digest.removeprefix("sha256:")[:8]


@pytest.mark.parametrize("scenario", DIGESTS)
def test_a_session_has_one_digest_on_every_processor(scenario: str, tmp_path: Path) -> None:
    assert flown(scenario, tmp_path, SIMPLER) == DIGESTS[scenario]


def test_with_all_of_this_processors_instructions_too(tmp_path: Path) -> None:
    """Of the paper's plant; tests/system/test_wheel.py flies the demo so."""
    assert flown("paper/example4", tmp_path, {}) == DIGESTS["paper/example4"]
