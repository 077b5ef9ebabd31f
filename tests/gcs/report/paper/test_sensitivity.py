"""Plans and combinations of what is not printed: lengths known from elsewhere, orders by hand."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from gcs.report.paper import sensitivity


def test_plans_are_example_1s_and_come_to_the_end(tmp_path: Path) -> None:
    """146 whole steps, 14.5 m from (0,0,0), as docs/model/planner.md#potential-field has it."""
    whole = sensitivity.planned((0.0, 0.0, 0.0), full_steps=True)
    assert len(whole) == 146
    assert np.linalg.norm(whole, axis=1) == pytest.approx(1.0)
    assert 0.1 * whole.sum(axis=0) == pytest.approx([10.0, 10.0, 3.0], abs=0.11)
    lengths = sensitivity.write_plans(tmp_path / "plans.json")
    content = json.loads((tmp_path / "plans.json").read_text(encoding="utf-8"))
    assert np.array(content["start_velocity_nwu"]).shape == (18, 3)
    shrinking, full = (np.array(plan["velocity_nwu"]) for plan in content["plans"])
    assert shrinking.shape == full.shape == (18, max(lengths["shrinking"]), 3)
    assert full[7, :146] == pytest.approx(whole)
    assert not full[7, 146:].any()


def energies(used: np.ndarray) -> dict[str, np.ndarray]:
    """One variant whose vehicles (18,) use so much per step, and one measure."""
    steps = np.arange(1, 301)
    return {
        "energy": used[np.newaxis, :, np.newaxis, np.newaxis] * steps,
        "step_s": np.array([0.1]),
        "plan": np.array(["whole"]),
        "gain_set": np.array(["paper"]),
        "yaw_rad": np.array([1.0]),
        "measures": np.array(["thrust"]),
    }


def test_winner_and_orders_by_hand() -> None:
    used = np.linspace(2.0, 3.4, 18)
    used[7] = 1.0  # vehicle 8 least
    used[15:] = [3.0, 1.0, 2.0]  # Example 2: order 2, 3, 1
    found = list(sensitivity.combinations(energies(used), {"whole": [100, 100, 100]}))
    assert len(found) == 7
    assert {one.winner_3 for one in found} == {8}
    assert {one.order_2 for one in found} == {(2, 3, 1)}
    fifths = [one for one in found if one.orders_4]
    assert len(fifths) == 2
    assert {order for one in fifths for order in one.orders_4} == {(5, 4, 2, 1, 3)}  # who uses most first
    study = sensitivity.study(energies(used), {"whole": [100, 100, 100]})
    assert study.measured["sens-ex3-papers"].value == 1.0
    assert study.measured["sens-ex4-papers"].value == 0.0
    assert ["8", "0, 0, 0", "2, 2, 2", "100.0 %"] in [list(row) for row in study.tables[0].rows]


def test_a_shorter_own_way_uses_less() -> None:
    found = list(sensitivity.combinations(energies(np.ones(18)), {"whole": [120, 100, 110]}))
    by_end = {one.choice["counted"]: one for one in found}
    assert by_end["up to its own arrival"].winner_3 == 6
    assert by_end["up to its own arrival"].order_2 == (2, 3, 1)
    assert by_end["up to the last arrival"].winner_3 == 1
