"""Tables 1 and 2: the four beams, their ratios, and what the printed heads and captions would make of them."""

from __future__ import annotations

from varistiff.elastic.leaf import Leaf
from varistiff.materials import Material, find_material
from varistiff.papers.claims import load_claims
from varistiff.papers.dos_santos_2019.elastica import defined_load, load_limit
from varistiff.papers.dos_santos_2019.paper_values import (
    ACTIVE_LENGTHS,
    BEAMS,
    FORCES,
    MODULUS_UNIT,
    PRINTED_MODULUS_UNIT,
)

PAPER = "dos_santos_2019"
SHEAR_COEFFICIENT = 5.0 / 6.0  # of a rectangle


def leaf(beam: str, *, modulus_unit: float = MODULUS_UNIT) -> Leaf:
    """Beam of Table 1 with its cross-section read as thickness x width, E in ``modulus_unit`` [Pa]; length by mass.

    Parameters
    ----------
    beam : key of ``BEAMS``
    modulus_unit : GPa; the printed MPa shows what follows from it
    """
    row = BEAMS[beam]
    return Leaf(
        youngs_modulus=row.modulus * modulus_unit,
        width=row.second_side,
        thickness=row.first_side,
        length=beam_length(beam=beam),
    )


def material(beam: str) -> Material:
    """The beam's material in varistiff's table."""
    return find_material(BEAMS[beam].material)


def beam_length(*, beam: str) -> float:
    """Whole length [m] from the printed mass and cross-section with the density of varistiff's table."""
    row, density = BEAMS[beam], material(beam).density
    assert density is not None  # every metal of the table has one
    return row.mass / (density.value * row.first_side * row.second_side)


def ratio(*, beam: str, active_length: str, over: str) -> float:
    """A cell of Table 2: active length over ``width`` or ``thickness``."""
    element = leaf(beam)
    return float(ACTIVE_LENGTHS[active_length] / getattr(element, over))


def ratios_by_printed_head() -> float:
    """Margin of Table 1's head, w x h: of the cell of Table 2 that it misses most; positive if it gives them all."""
    swapped = {"width": "thickness", "thickness": "width"}
    return min(
        claim.allowance - abs(ratio(**{**claim.arguments, "over": swapped[claim.arguments["over"]]}) - claim.numbers[0])
        for claim in load_claims(PAPER)
        if claim.computation == "beams.ratio"
    )


def ratios_by_caption() -> float:
    """Margin of Table 2's caption, width and thickness *to* length; positive if that gives every cell."""
    return min(
        claim.allowance - abs(1.0 / ratio(**claim.arguments) - claim.numbers[0])
        for claim in load_claims(PAPER)
        if claim.computation == "beams.ratio"
    )


def modulus_in_megapascal() -> float:
    """Margin of E in MPa: the load limit less the least alpha_0 of the experiment; negative: no equilibrium at all."""
    least = min(
        defined_load(
            FORCES[0],
            active_length=length,
            flexural_rigidity=leaf(beam, modulus_unit=PRINTED_MODULUS_UNIT).flexural_rigidity,
        )
        for beam in BEAMS
        for length in ACTIVE_LENGTHS.values()
    )
    return load_limit()[0] - least


def least_slenderness() -> float:
    """Least active length over thickness of the experiment."""
    return min(ratio(beam=beam, active_length=length, over="thickness") for beam in BEAMS for length in ACTIVE_LENGTHS)


def thinness() -> float:
    """Least width or active length over thickness, less four: a quarter is taken as much smaller."""
    return min(least_slenderness(), *(leaf(beam).width / leaf(beam).thickness for beam in BEAMS)) - 4.0


def number_of_materials() -> float:
    """Number of different materials in Table 1."""
    return float(len({row.material for row in BEAMS.values()}))


def reach() -> float:
    """Shortest beam [m], less the longer active length."""
    return min(beam_length(beam=beam) for beam in BEAMS) - max(ACTIVE_LENGTHS.values())


def shear_share(beam: str, slenderness: float) -> float:
    """Shear deflection over bending deflection of an end-loaded cantilever, 3 E I/(k G A L^2), of linear theory.

    Parameters
    ----------
    beam : key of ``BEAMS``; E and G from varistiff's table of materials
    slenderness : length over thickness
    """
    properties = material(beam)
    assert properties.youngs_modulus is not None  # every metal of the table has both
    assert properties.shear_modulus is not None
    return (
        0.25 * properties.youngs_modulus.value / (SHEAR_COEFFICIENT * properties.shear_modulus.value * slenderness**2)
    )


def shear_neglected() -> float:
    """One per cent, less the largest share of shear in the deflections of the experiment."""
    return 0.01 - max(shear_share(beam, least_slenderness()) for beam in BEAMS)


def shear_seen_by_experiment() -> float:
    """Largest force that shear can change in the experiment [N], less the least of the printed errors."""
    share = max(shear_share(beam, least_slenderness()) for beam in BEAMS)
    return share * max(FORCES) - min(row.rms_error for row in BEAMS.values())
