"""The tables of the torsion pages, computed: constants of sections, and Table I of Schuy et al. (2013)."""

from __future__ import annotations

import math
from collections.abc import Sequence

from varistiff.sections import P3G, P4C, Hexagon, HollowCircle, Octagon, Section, SplinedTube, Square

STIFFNESS, LENGTH, MODULUS = 350.0, 0.010, 0.63e9  # N m/rad, m, Pa
RATIO = 0.5  # inner to outer radius of the paper's cylinder
HALF_DIGIT = 0.05e-3  # the paper rounds to 0.1 mm
KINDS = {"square": Square, "hexagon": Hexagon, "octagon": Octagon}
PRINTED = {  # across flats [m], c_g, c_r, stress ratio [%]
    "square": (14.1e-3, 0.141, 0.208, 128.0),
    "hexagon": (14.8e-3, 0.115, 0.188, 122.0),
    "octagon": (15.1e-3, 0.108, 0.185, 117.0),
}
RADIUS = 7.8e-3  # printed
EXAMPLES: dict[str, Section] = {
    "P3G, $D_m$ = 20 mm, $e$ = 0.8 mm": P3G(mean_diameter=0.020, eccentricity=0.0008),
    "P4C, $d_i$ = 21 mm, $d_a$ = 25 mm, $e$ = 3.5 mm": P4C(
        inner_diameter=0.021, outer_diameter=0.025, eccentricity=0.0035
    ),
    "hollow circle, 11 and 8.7 mm": HollowCircle(outer_radius=0.011, inner_radius=0.0087),
    "the same with six rails of 7 mm by 2.25 mm, fillet 0.5 mm": SplinedTube(
        outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.007, rail_height=0.00225, root_fillet=0.0005
    ),
    "the same with a fillet of 0 mm": SplinedTube(
        outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.007, rail_height=0.00225, root_fillet=0.0
    ),
}


def factors(name: str) -> tuple[float, float]:
    """J/b^4 and W/b^3 of a regular polygon, b across flats."""
    unit = KINDS[name](across_flats=1.0)
    return unit.torsion_constant, unit.torsion_modulus


def across_flats(name: str) -> float:
    """Distance of parallel sides with which the section has the stiffness asked for [m]."""
    return (STIFFNESS * LENGTH / MODULUS / factors(name)[0]) ** 0.25


def radius(ratio: float) -> float:
    """Outer radius of the circle, hollow by ``ratio``, with which it has the stiffness asked for [m]."""
    return (2.0 * STIFFNESS * LENGTH / MODULUS / (math.pi * (1.0 - ratio**4))) ** 0.25


def sections_table() -> str:
    """Return numbers of solved sections: what there is no handbook for."""
    rows = []
    for name, section in EXAMPLES.items():
        found = section.properties()
        modulus = f"{1e9 * found.torsion_modulus:.1f}" if found.torsion_modulus else "0: the ideal stress is unbounded"
        error = "exact" if found.error == 0.0 else f"{found.error:.0e}"
        rows.append((name, f"{1e6 * found.area:.2f}", f"{1e12 * found.torsion_constant:.1f}", modulus, error))
    return _table(("section", "area, mm²", "$J$, mm⁴", "$W$, mm³", "stated error of $J$"), rows)


def table_one() -> str:
    """Return Table I: printed values beside ours."""
    names = list(KINDS)
    ours = {name: factors(name) for name in names}
    rows = [
        (
            "dimension printed, mm",
            f"$R$ = {1e3 * RADIUS:.1f}",
            *(f"$b$ = {1e3 * PRINTED[name][0]:.1f}" for name in names),
        ),
        (
            "computed at $G$ = 0.63 GPa, mm",
            f"{1e3 * radius(RATIO):.3f} hollow, {1e3 * radius(0.0):.3f} solid",
            *(f"{1e3 * across_flats(name):.3f}" for name in names),
        ),
        ("$c_g = J/b^4$ printed", "$\\pi/32$", *(f"{PRINTED[name][1]:.3f}" for name in names)),
        ("computed", f"{math.pi / 32.0:.5f}", *(f"{ours[name][0]:.5f}" for name in names)),
        ("$c_r = W/b^3$ printed", "$\\pi/16$", *(f"{PRINTED[name][2]:.3f}" for name in names)),
        ("computed", f"{math.pi / 16.0:.5f}", *(f"{ours[name][1]:.5f}" for name in names)),
        ("$G$ that rounds to the printed dimension, GPa", *_intervals()),
    ]
    return _table(("", "circle", *names), rows)


def _intervals() -> list[str]:
    """Shear moduli for which the exact dimension rounds to the printed one."""
    hollow, solid = (_interval(math.pi / 2.0 * (1.0 - ratio**4), RADIUS) for ratio in (RATIO, 0.0))
    polygons = [_interval(factors(name)[0], PRINTED[name][0]) for name in KINDS]
    return [f"{_span(hollow)} hollow, {_span(solid)} solid", *(_span(one) for one in polygons)]


def _interval(factor: float, size: float) -> tuple[float, float]:
    low, high = (STIFFNESS * LENGTH / (factor * (size + way * HALF_DIGIT) ** 4) for way in (1.0, -1.0))
    return low, high


def _span(pair: tuple[float, float]) -> str:
    return f"{1e-9 * pair[0]:.3f} to {1e-9 * pair[1]:.3f}"


def common_modulus() -> str:
    """Return the shear moduli that fit all four dimensions of Table I, with exact and with printed factors."""
    rows = []
    for words, of in (("exact", lambda name: factors(name)[0]), ("as printed", lambda name: PRINTED[name][1])):
        found = [_interval(of(name), PRINTED[name][0]) for name in KINDS]
        spans = []
        for ratio in (RATIO, 0.0):
            every = [*found, _interval(math.pi / 2.0 * (1.0 - ratio**4), RADIUS)]
            low, high = max(one[0] for one in every), min(one[1] for one in every)
            spans.append(f"{_span((low, high))} GPa" if low < high else "none")
        rows.append((words, *spans))
    return _table(("factors $c_g$", "cylinder hollow, $\\lambda = 0.5$", "cylinder solid"), rows)


def stress_ratios() -> str:
    """Return the largest stress of each section over that of the circle, for several readings of the paper."""
    hollow, solid = radius(RATIO), radius(0.0)
    exact = {name: factors(name)[1] * across_flats(name) ** 3 for name in KINDS}
    rounded = {name: PRINTED[name][2] * PRINTED[name][0] ** 3 for name in KINDS}
    full, open_ = 0.5 * math.pi, 0.5 * math.pi * (1.0 - RATIO**4)
    readings = [
        ("printed dimensions and factors, circle solid", full * RADIUS**3, rounded),
        ("printed dimensions and factors, circle hollow", open_ * RADIUS**3, rounded),
        (
            f"computed, circle hollow, $R$ = {1e3 * hollow:.2f} mm: every section equally stiff",
            open_ * hollow**3,
            exact,
        ),
        (f"computed, circle solid, $R$ = {1e3 * solid:.2f} mm: every section equally stiff", full * solid**3, exact),
        (f"computed, solid circle of the hollow one's $R$ = {1e3 * hollow:.2f} mm", full * hollow**3, exact),
    ]
    rows = [("Table I", *(f"{PRINTED[name][3]:.0f} %" for name in KINDS))]
    rows += [(words, *(f"{100.0 * w / moduli[name]:.1f} %" for name in KINDS)) for words, w, moduli in readings]
    return _table(("reading", *KINDS), rows)


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(row) + " |" for row in (head, *rows)]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])
