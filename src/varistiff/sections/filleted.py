"""The section to quote a stress of, where the one that was asked for has none."""

from __future__ import annotations

from varistiff.core.errors import InputError
from varistiff.sections.section import Section
from varistiff.sections.splined_tube import SplinedTube

SHARE = 0.2  # of the smaller of rail height and width


def filleted(section: Section) -> SplinedTube | None:
    """Return a splined tube with sharp roots again, with a root fillet; None for every other section.

    The fillet is a fifth of the smaller of rail height and width, or less where the rails leave less room.

    >>> tube = SplinedTube(
    ...     outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.004, rail_height=0.0025, root_fillet=0.0
    ... )
    >>> rounded = filleted(tube)
    >>> rounded.root_fillet
    0.0005
    """
    if not isinstance(section, SplinedTube) or section.root_fillet > 0.0:
        return None
    radius = SHARE * min(section.rail_height, section.rail_width)
    for _ in range(6):
        try:
            return SplinedTube(
                outer_radius=section.outer_radius,
                inner_radius=section.inner_radius,
                rails=section.rails,
                rail_width=section.rail_width,
                rail_height=section.rail_height,
                root_fillet=radius,
            )
        except InputError:
            radius *= 0.5
    return None
