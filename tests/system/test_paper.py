"""`gcs paper` as a program: a cheap part of it, whole."""

from __future__ import annotations

import json
import re
import subprocess
from importlib import resources
from pathlib import Path

import jsonschema
import pytest
from commands import gcs
from sessions import DIGESTS, GCS

pytestmark = pytest.mark.timeout(450)

PARTS = "example2,fig3,fig6,loops"


def paper(*options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*GCS, "paper", *options], capture_output=True, text=True, check=False, timeout=400)


def page_of(out: Path) -> str:
    return (out / "index.html").read_text(encoding="utf-8")


@pytest.mark.slow
def test_a_part_of_it_is_flown_measured_judged_and_drawn(tmp_path: Path) -> None:
    out = tmp_path / "page"
    done = paper("--out", str(out), "--only", PARTS)
    assert done.returncode == 0, done.stderr
    assert str(out / "index.html") in done.stdout
    told = re.findall(r"^  (\S.*)$", done.stdout, re.MULTILINE)
    content = json.loads((out / "claims.json").read_text(encoding="utf-8"))
    schema = json.loads(resources.files("gcs").joinpath("schemas/claims.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(schema).validate(content)
    measured = {claim["claim"]: claim for claim in content["claims"]}
    assert (len(content["claims"]), len(content["later_claims"])) == (14, 5)
    assert measured["Every vehicle ends on the desired speed."]["verdict"] == "agrees"
    both = content["claims"] + content["later_claims"]
    assert all(claim["measured"] is not None for claim in both)
    differ = [claim for claim in both if claim["verdict"] == "differs"]
    assert differ
    assert all(claim["reason"] in page_of(out) for claim in differ)
    assert [(claim["claim"] in line, claim["figure"] in line) for claim, line in zip(differ, told, strict=True)] == [
        (True, True)
    ] * len(differ)
    flown = json.loads((out / "sessions" / "example2" / "summary.json").read_text())
    assert flown["outcome"] == "met"
    assert flown["digest"].startswith(f"sha256:{DIGESTS['paper/example2']}")
    figures = {path.stem for path in out.glob("*.svg")}
    assert figures == {path.stem for path in out.glob("*.png")} == {"fig9a", "fig9b", "fig9c", "fig3a", "fig3b", "fig6"}
    page = page_of(out)
    assert page.count("data:image/svg+xml") == len(figures)
    assert all(claim["verdict"] in page for claim in both)


def test_an_existing_folder_and_an_unknown_part_are_refused_before_anything_flies(tmp_path: Path) -> None:
    (tmp_path / "page").mkdir()
    done = gcs("paper", "--out", str(tmp_path / "page"), "--only", "example1")
    assert done.returncode == 2
    assert "exists already" in done.stderr
    assert not list((tmp_path / "page").iterdir())
    done = gcs("paper", "--out", str(tmp_path / "other"), "--only", "fig99")
    assert done.returncode == 2
    assert "no part 'fig99'" in done.stderr
    assert not (tmp_path / "other").exists()
