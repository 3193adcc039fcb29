"""Cross-sections in torsion, one shape per file; a shape is imported where it is first asked for."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from varistiff.sections.circle import Circle
    from varistiff.sections.ellipse import Ellipse
    from varistiff.sections.hexagon import Hexagon
    from varistiff.sections.hollow_circle import HollowCircle
    from varistiff.sections.octagon import Octagon
    from varistiff.sections.p3g import P3G
    from varistiff.sections.p4c import P4C
    from varistiff.sections.polygon import Polygon
    from varistiff.sections.rectangle import Rectangle
    from varistiff.sections.section import Section
    from varistiff.sections.splined_tube import SplinedTube
    from varistiff.sections.square import Square
    from varistiff.sections.triangle import Triangle

__all__ = [
    "P3G",
    "P4C",
    "Circle",
    "Ellipse",
    "Hexagon",
    "HollowCircle",
    "Octagon",
    "Polygon",
    "Rectangle",
    "Section",
    "SplinedTube",
    "Square",
    "Triangle",
]

_FILES = {"HollowCircle": "hollow_circle", "SplinedTube": "splined_tube"}


def __getattr__(name: str) -> Any:  # the shapes bring in JAX, which reading a design file does not need
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_FILES.get(name, name.lower())}"), name)
