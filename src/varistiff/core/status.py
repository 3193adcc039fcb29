"""Status of one evaluated point, each with its remedy."""

from __future__ import annotations

from enum import IntEnum


class Status(IntEnum):
    """What may be believed of one point of a map; the first that applies is reported.

    The integer values are stable: they are written to netCDF files as flag values.
    """

    OK = 0
    NO_SOLUTION = 1
    ELEMENT_TOO_SHORT = 2
    NO_CONTACT = 3
    OUTSIDE_VALIDITY = 4
    YIELDED = 5

    @property
    def label(self) -> str:
        """Name as written to files: lower case with underscores."""
        return self.name.lower()

    @property
    def meaning(self) -> str:
        """One sentence: what the status says."""
        return _MEANINGS[self]

    @property
    def remedy(self) -> str:
        """One sentence: what a designer can do about it."""
        return _REMEDIES[self]


_MEANINGS = {
    Status.OK: "The model holds and every number is converged.",
    Status.NO_SOLUTION: "No stable equilibrium exists, or no mechanism has this setting; the numbers are NaN.",
    Status.ELEMENT_TOO_SHORT: "The elastic element is shorter than this point needs; the numbers are NaN.",
    Status.NO_CONTACT: "The drive does not touch the elastic element; load, stiffness and energy are exactly zero.",
    Status.OUTSIDE_VALIDITY: "An assumption of the model is broken; what numbers there are must not be trusted.",
    Status.YIELDED: "The stress in the elastic element exceeds its yield strength.",
}

_REMEDIES = {
    Status.OK: "Nothing to do.",
    Status.NO_SOLUTION: "Reduce the deflection, or choose a setting inside the mechanism's travel.",
    Status.ELEMENT_TOO_SHORT: "Lengthen the element, or reduce the largest setting or deflection.",
    Status.NO_CONTACT: "Reduce the clearance or preload the element if play is unwanted.",
    Status.OUTSIDE_VALIDITY: "Reduce the deflection, or change the mechanism or theory so that it holds.",
    Status.YIELDED: "Reduce the deflection or the thickness, lengthen the element or choose a stronger material.",
}
