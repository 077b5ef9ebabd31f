"""Verdicts by hand; the table is whole, and what comes of it keeps to the schema that ships."""

import hashlib
import json
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from gcs.report.paper import claims, make, page
from gcs.report.paper.claims import Claim, judge
from gcs.report.paper.study import Measurement, Table, Value

BEFORE = "2c97ff53cc025d6c14d86fe328edd0886943948df1d8e4a891b2134b500dd311"
"""Of ids and tolerances, as they were committed first."""


def claim(accept: dict[str, Any] | None) -> Claim:
    return Claim("a", "7(b)", "example1", "It <holds>.", "0.5", "0.1", "measured so", accept)


@pytest.mark.parametrize(
    ("accept", "value", "verdict"),
    [
        ({"at_most": 0.02}, 0.02, "agrees"),
        ({"at_most": 0.02}, 0.021, "differs"),
        ({"at_least": 0.9}, 0.9, "agrees"),
        ({"at_least": 0.9}, 0.89, "differs"),
        ({"equals": 8}, 8, "agrees"),
        ({"equals": 8}, 1, "differs"),
        ({"equals": [5, 1, 4, 2, 3]}, (5, 1, 4, 2, 3), "agrees"),
        ({"equals": [5, 1, 4, 2, 3]}, [5, 1, 4, 3, 2], "differs"),
        ({"bands": [[40, 60], [112, None]]}, [40.0, 1e9], "agrees"),
        ({"bands": [[40, 60], [112, None]]}, [60.1, 111.9], "differs"),
        ({"rising_by": 1.05}, [50.0, 70.0, 90.0], "agrees"),
        ({"rising_by": 1.05}, [50.0, 50.0, 90.0], "differs"),
        ({"at_most": 1.0}, float("inf"), "differs"),
        ({"at_most": 1.0}, float("nan"), "differs"),
        ({"at_most": 1.0}, None, "cannot be compared"),
        (None, 3.0, "cannot be compared"),
    ],
)
def test_a_verdict_follows_from_the_tolerance_alone(accept: dict[str, Any] | None, value: Value, verdict: str) -> None:
    assert judge(claim(accept), Measurement(value)).verdict == verdict


def test_the_reason_names_what_lies_outside_and_keeps_the_note() -> None:
    judged = judge(claim({"bands": [[40, 60], [112, None]]}), Measurement([50.0, 54.07], "near tie"))
    assert judged.why == "54.07 is outside 112 to infinity; near tie"


def test_what_is_not_finite_is_left_out_of_the_file() -> None:
    row = judge(claim({"at_most": 1.0}), Measurement(float("inf"))).row()
    assert row["measured"] is None
    assert "bounds" in row["why"]


def test_each_claim_of_the_table_is_whole_and_belongs_to_a_part() -> None:
    table = claims.load()
    assert len({one.id for one in table}) == len(table)
    assert sum(not one.later for one in table) == 51
    assert {one.part for one in table} == set(make.PARTS)
    assert all(all((one.figure, one.claim, one.paper, one.tolerance, one.criterion)) for one in table)


def test_the_tolerances_are_those_that_were_written_down_before_anything_was_measured() -> None:
    table = json.dumps([[one.id, one.accept] for one in claims.load() if not one.later], sort_keys=True)
    assert hashlib.sha256(table.encode()).hexdigest() == BEFORE


def test_what_is_not_the_papers_is_called_ours() -> None:
    table = {one.id: one for one in claims.load()}
    assert "Table I" in table["fig3a-rules"].ours
    for one in table.values():
        assert "tau^(1/p)" not in one.paper
        assert "tau^(1/p)" not in one.criterion or "tau^(1/p)" in one.ours or "tau^(1/2)" in one.criterion
        assert "as eq. 21 reads" not in one.claim
    row = judge(table["chatter-explicit"], Measurement(57.0)).row()
    assert "explicit steps" in row["ours"]


def test_each_reason_belongs_to_a_claim_and_is_given_where_it_differs_alone() -> None:
    known = claims.reasons()
    assert known.keys() <= {one.id for one in claims.load()}
    (differs,) = (one for one in claims.load() if one.id == "loops-order")
    judged = judge(differs, Measurement(0.25), known)
    assert judged.reason == known["loops-order"]
    assert judged.row()["reason"] == "the paper contradicts itself"
    assert judged.line.endswith("(the paper contradicts itself).")
    assert "reason" not in judge(differs, Measurement(1.5), known).row()
    assert judge(differs, Measurement(0.25)).reason == claims.REAL


def test_the_file_keeps_to_the_schema(tmp_path: Path) -> None:
    judged = [judge(one, Measurement(1.0)) for one in claims.load() if one.accept is None or "at_most" in one.accept]
    judged.append(judge(claim({"equals": [1, 2]}), Measurement([2, 1]), claims.reasons()))
    claims.write(judged, tmp_path)
    schema = json.loads(resources.files("gcs").joinpath("schemas/claims.schema.json").read_text(encoding="utf-8"))
    content = json.loads((tmp_path / "claims.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    validator.validate(content)
    assert len(content["later_claims"]) == sum(one.claim.later for one in judged) > 0
    for wrong in ({"verdict": "perhaps"}, {"reason": "bad luck"}):
        assert not validator.is_valid(content | {"claims": [content["claims"][0] | wrong]})


def test_the_page_needs_no_network_and_shows_each_claim_with_its_verdict(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'/>", encoding="utf-8")
    judged = [judge(claim({"at_most": 0.02}), Measurement(0.3, "worst & last")), judge(claim(None), Measurement(None))]
    table = Table("numbers", ["a", "b"], [["1", "<2>"]])
    section = page.Section("example1", "Example 1", judged, [page.Image(tmp_path / "a.svg", "a < b")], [table])
    page.write(tmp_path / "index.html", [section], when="today", wall_s=1.0)
    text = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "It &lt;holds&gt;." in text
    assert "worst &amp; last" in text
    assert "&lt;2&gt;" in text
    assert text.count("differs</span>") == 3  # the counts of both tables at the top, and the claim
    assert "none of the other reasons explains it" in text
    assert "Differences: a real difference: 1" in text
    assert 'src="data:image/svg+xml;base64,' in text
    assert "http" not in text
    assert page.counted(judged) == {"agrees": 0, "differs": 1, "cannot be compared": 1}


def test_parts_are_chosen_by_name_or_by_figure_in_the_order_of_the_page() -> None:
    assert make.chosen(None) == list(make.PARTS)
    assert make.chosen("fig13, fig7,fig8") == ["example1", "fig13"]
    with pytest.raises(ValueError, match="no part 'fig99'; choose from example1"):
        make.chosen("fig99")
