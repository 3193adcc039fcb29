"""Walking as a load case: representative cycles of human joints, with their sources."""

from varistiff.dynamics.gait.knee import KneeGait, knee_gait

__all__ = ["KneeGait", "knee_gait"]
