"""Chains from a wanted stiffness to the coordinate of the setting drive."""

from __future__ import annotations

from abc import abstractmethod

import equinox as eqx

from varistiff.dynamics.control.controller import Number, Scalar


class StiffnessChain(eqx.Module):
    """What a stiffness controller believes: stiffness and setting drive, in both directions."""

    @abstractmethod
    def motion(self, stiffness: Number, deflection: Number) -> Scalar:
        """Coordinate z [rad or m] that gives a stiffness [N m/rad or N/m] at a deflection [rad or m].

        A stiffness beyond the used range is taken as the nearer end of that range.
        """

    @abstractmethod
    def stiffness(self, motion: Number, deflection: Number) -> Scalar:
        """Stiffness [N m/rad or N/m] that the controller believes in at a coordinate [rad or m]."""

    @abstractmethod
    def reach(self) -> tuple[Scalar, Scalar]:
        """Least and largest stiffness at rest [N m/rad or N/m] of the used range."""
