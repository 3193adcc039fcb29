"""What section 3 concludes from Table 3, from the table's own cells and from the printed joint."""

from __future__ import annotations

import math

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.stiffness import rest_stiffness
from varistiff.papers.wang_2024.table_3 import OTHERS, load_table_3, splits


def bandwidth_is_large() -> tuple[float, float]:
    """Logarithm of the joint's stiffness bandwidth over the widest of vsaUT-II, REGT-VSA and CLSM-VSA.

    The paper does not define bandwidth. Low end: ratio of largest to smallest stiffness, the joint from 6 to 25 mm,
    the others as Table 3 is most likely read; it is free of E, b and h. High end: difference, with the printed leaf.
    """
    row = load_table_3().row("stiffness")
    others = [row.interval(key) for key in ("vsaut_ii", "regt_vsa", "clsm_vsa")]
    soft, stiff = (float(rest_stiffness(length)) for length in (paper.LENGTH_MAX, paper.LENGTH_MIN))
    by_ratio = math.log(stiff / soft) - max(math.log(high / low) for low, high in others)
    by_width = math.log(stiff - soft) - max(math.log(high - low) for low, high in others)
    return min(by_ratio, by_width), max(by_ratio, by_width)


def _ranks(row: str) -> tuple[float, float]:
    """How many of the other joints have a larger number in a row, less how many have a smaller one.

    The least and the largest over every way to cut the row's digits into cells.
    """
    cells = load_table_3().row(row)
    own = cells.number("proposed")
    cuts = [[float(cell) for cell in cut] for cut in splits(cells.run or "", len(OTHERS), cells.holds)]
    ranks = [float(sum(value > own for value in cut) - sum(value < own for value in cut)) for cut in cuts]
    return min(ranks), max(ranks)


def regulation_is_fast() -> float:
    """Joints of Table 3 that regulate more slowly than the proposed one, less those that are faster; the worst cut."""
    return _ranks("regulation_time")[0]


def weight_is_large() -> tuple[float, float]:
    """Joints of Table 3 that are lighter than the proposed one, less those that are heavier; over all cuts."""
    least, largest = _ranks("weight")
    return 0.0 - largest, 0.0 - least


def reconfigurable_without_disassembly() -> float:
    """1 minus the number of other joints in Table 3 that are reconfigured without disassembly."""
    row = load_table_3().row("reconfigurable")
    return 1.0 - sum(row.cells[key].printed == "yes" for key in OTHERS)


def half_of_one_turn() -> float:
    """Half the rotation that Table 2 prints, 0 to 360 degrees [rad]."""
    return math.pi
