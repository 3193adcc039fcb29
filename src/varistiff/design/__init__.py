"""Design files: from YAML with units in words to a validated, frozen design."""

from varistiff.design.design import Design, load

__all__ = ["Design", "load"]
