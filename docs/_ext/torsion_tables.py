"""The tables of the torsion pages: constants of sections, and Table I of Schuy et al. (2013)."""

from __future__ import annotations

import math
from collections.abc import Sequence

from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013 import table_one as computed
from varistiff.papers.schuy_2013.corrected_reading import RAIL_WIDTH, search
from varistiff.papers.schuy_2013.rails import splined_section
from varistiff.sections import P3G, P4C, HollowCircle, Section

NAMES = tuple(computed.KINDS)
RATIO = paper.HOLLOW_RATIO
RAIL_HEIGHT = 0.00225  # m, as in examples/splined_tube.yaml


def examples() -> dict[str, Section]:
    """Return sections that no handbook has."""
    return {
        "P3G, $D_m$ = 20 mm, $e$ = 0.8 mm": P3G(mean_diameter=0.020, eccentricity=0.0008),
        "P4C, $d_i$ = 21 mm, $d_a$ = 25 mm, $e$ = 3.5 mm": P4C(
            inner_diameter=0.021, outer_diameter=0.025, eccentricity=0.0035
        ),
        "hollow circle, 11 and 8.7 mm": HollowCircle(outer_radius=0.011, inner_radius=0.0087),
        "the same with six rails of 7 mm by 2.25 mm, fillet 0.5 mm": splined_section(
            width=RAIL_WIDTH, height=RAIL_HEIGHT, fillet=0.0005
        ),
        "the same with a fillet of 0 mm": splined_section(width=RAIL_WIDTH, height=RAIL_HEIGHT, fillet=0.0),
    }


def sections_table() -> str:
    """Return numbers of solved sections: what there is no handbook for."""
    rows = []
    for name, section in examples().items():
        found = section.properties()
        modulus = f"{1e9 * found.torsion_modulus:.1f}" if found.torsion_modulus else "0: the ideal stress is unbounded"
        error = "exact" if found.error == 0.0 else f"{found.error:.0e}"
        rows.append((name, f"{1e6 * found.area:.2f}", f"{1e12 * found.torsion_constant:.1f}", modulus, error))
    return _table(("section", "area, mm²", "$J$, mm⁴", "$W$, mm³", "stated error of $J$"), rows)


def table_one() -> str:
    """Return Table I: printed values beside ours."""
    modulus = search().shear_modulus
    hollow, solid = (1e3 * computed.radius(ratio=ratio, shear_modulus=modulus) for ratio in (RATIO, 0.0))
    sizes = [1e3 * computed.across_flats(section=name, shear_modulus=modulus) for name in NAMES]
    rows = [
        (
            "dimension printed, mm",
            f"$R$ = {1e3 * paper.TABLE_RADIUS:.1f}",
            *(f"$b$ = {1e3 * paper.ACROSS_FLATS[name]:.1f}" for name in NAMES),
        ),
        (
            f"computed at $G$ = {1e-9 * modulus:.2f} GPa, mm",
            f"{hollow:.3f} hollow, {solid:.3f} solid",
            *(f"{size:.3f}" for size in sizes),
        ),
        ("$c_g = J/b^4$ printed", "$\\pi/32$", *(f"{paper.STIFFNESS_FACTORS[name]:.3f}" for name in NAMES)),
        ("computed", f"{math.pi / 32.0:.5f}", *(f"{computed.stiffness_factor(section=name):.5f}" for name in NAMES)),
        ("$c_r = W/b^3$ printed", "$\\pi/16$", *(f"{paper.RESISTANCE_FACTORS[name]:.3f}" for name in NAMES)),
        ("computed", f"{math.pi / 16.0:.5f}", *(f"{computed.resistance_factor(section=name):.5f}" for name in NAMES)),
        ("$G$ that rounds to the printed dimension, GPa", *_intervals()),
    ]
    return _table(("", "circle", *NAMES), rows)


def _intervals() -> list[str]:
    """Shear moduli for which the exact dimension rounds to the printed one."""
    hollow, solid = (computed.cylinder_interval(ratio=ratio) for ratio in (RATIO, 0.0))
    polygons = [computed.polygon_interval(section=name, exact=True) for name in NAMES]
    return [f"{_span(hollow)} hollow, {_span(solid)} solid", *(_span(one) for one in polygons)]


def _span(pair: tuple[float, float]) -> str:
    return f"{1e-9 * pair[0]:.3f} to {1e-9 * pair[1]:.3f}"


def common_modulus() -> str:
    """Return the shear moduli that fit all four dimensions of Table I, with exact and with printed factors."""
    rows = []
    for words, exact in (("exact", True), ("as printed", False)):
        found = [computed.common_modulus(ratio=ratio, exact=exact) for ratio in (RATIO, 0.0)]
        rows.append((words, *("none" if one is None else f"{_span(one)} GPa" for one in found)))
    return _table(("factors $c_g$", "cylinder hollow, $\\lambda = 0.5$", "cylinder solid"), rows)


def stress_ratios() -> str:
    """Return the largest stress of each section over that of the circle, for several readings of the paper."""
    modulus = search().shear_modulus
    hollow, solid = (1e3 * computed.radius(ratio=ratio, shear_modulus=modulus) for ratio in (RATIO, 0.0))
    equal = computed.stress_ratio_at_equal_stiffness
    rows = [
        ("Table I", *(f"{100.0 * paper.STRESS_RATIOS[name]:.0f} %" for name in NAMES)),
        ("printed dimensions and factors, circle solid", *(_percent(computed.stress_ratio(section=n)) for n in NAMES)),
        (
            "printed dimensions and factors, circle hollow",
            *(_percent(computed.stress_ratio_hollow(section=name)) for name in NAMES),
        ),
        (
            f"computed, circle hollow, $R$ = {hollow:.2f} mm: every section equally stiff",
            *(_percent(equal(section=name, ratio=RATIO)) for name in NAMES),
        ),
        (
            f"computed, circle solid, $R$ = {solid:.2f} mm: every section equally stiff",
            *(_percent(equal(section=name, ratio=0.0)) for name in NAMES),
        ),
        (
            f"computed, solid circle of the hollow one's $R$ = {hollow:.2f} mm",
            *(_percent(equal(section=name, ratio=0.0, size_ratio=RATIO)) for name in NAMES),
        ),
    ]
    return _table(("reading", *NAMES), rows)


def _percent(ratio: float) -> str:
    return f"{100.0 * ratio:.1f} %"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(row) + " |" for row in (head, *rows)]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])
