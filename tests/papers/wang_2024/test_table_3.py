"""Table 3 as data: what is printed, what is ambiguous, what follows."""

from __future__ import annotations

import math

import pytest
from pydantic import ValidationError

from varistiff.papers.claims import load_claims
from varistiff.papers.wang_2024 import comparison
from varistiff.papers.wang_2024.table_3 import OTHERS, Row, load_table_3, parse_interval, splits, table_3_markdown


def test_every_row_has_five_cells_and_every_joint_a_source() -> None:
    table = load_table_3()
    assert len(table.rows) == 9
    assert [table.joints[key].reference for key in OTHERS] == [20, 23, 31, 29]
    assert all(joint.publication for joint in table.joints.values())


@pytest.mark.parametrize(
    ("key", "readings"), [("stiffness", 12), ("regulation_time", 2), ("torque", 35), ("weight", 2)]
)
def test_runs_of_digits_have_more_than_one_reading(key: str, readings: int) -> None:
    row = load_table_3().row(key)
    cuts = list(splits(str(row.run), len(OTHERS), row.holds))
    assert len(cuts) == readings
    assert all("".join(cut) == row.run for cut in cuts)
    likely = tuple(row.cells[joint].printed for joint in OTHERS)
    assert likely in cuts
    # seven gaps between eight digits, three cuts: every cut of the torques is a reading
    assert key != "torque" or readings == math.comb(7, 3)


def test_unambiguous_cells_are_parsed_as_printed() -> None:
    for row in load_table_3().rows:
        for cell in row.cells.values():
            if cell.value is not None:
                assert float(cell.printed.lstrip("±N× ")) == cell.value
            if cell.interval is not None and "(" not in cell.printed:
                assert parse_interval(cell.printed) == cell.interval


def test_a_wrong_reading_is_refused() -> None:
    good = load_table_3().row("weight").model_dump()
    good["cells"]["regt_vsa"]["printed"] = "4.4"
    with pytest.raises(ValidationError, match="can be read as"):
        Row.model_validate(good)


def test_ranks_over_every_cut_by_hand() -> None:
    # 0.34 s: 0.9, 0.5 and 0.49 or 90.49 are more, 0.09 or 0.0 is less
    assert comparison.regulation_is_fast() == 3 - 1
    # 4 kg: 2.5, 2.08 and 1.78 are less and 4.5 is more, or 2.5 and 2.0 less, 4.5 and 81.78 more
    assert comparison.weight_is_large() == (2 - 2, 3 - 1)


def test_table_3_has_twice_the_range_of_motion_of_table_2() -> None:
    (printed,) = (claim for claim in load_claims("wang_2024") if claim.id == "rotation_range")
    one_turn = float(str(printed.published))  # from 0
    both_ways = 2.0 * load_table_3().row("motion").number("proposed")
    assert both_ways == 2.0 * one_turn
    assert comparison.half_of_one_turn() == pytest.approx(0.5 * one_turn * printed.factor, rel=1e-15)


def test_bandwidth_depends_on_what_the_word_means() -> None:
    low, high = comparison.bandwidth_is_large()
    # ratio: l_2^2/l_1^3 at 6 and 25 mm, free of the leaf, against 948/0.7
    assert low == pytest.approx(math.log((31.0**2 / 6.0**3) / (50.0**2 / 25.0**3) / (948.0 / 0.7)), rel=1e-9)
    assert low < 0.0 < high


def test_markdown_marks_what_is_ambiguous() -> None:
    text = table_3_markdown()
    assert "20–236 †" in text
    assert "N × (206 to 5728)" in text
    assert "36220-inf." in text
    rows = [line for line in text.splitlines() if line.startswith("|")]
    assert {line.count("|") for line in rows} == {8}
