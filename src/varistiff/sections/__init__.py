"""Cross-sections in torsion, one shape per file."""

from varistiff.sections.circle import Circle
from varistiff.sections.hollow_circle import HollowCircle

__all__ = ["Circle", "HollowCircle"]
