"""One point of a leaf device by beam theory and by the solid, side by side."""

from __future__ import annotations

import time
from dataclasses import dataclass

from varistiff.actuators.actuator import Actuator
from varistiff.fe.leaf_devices import beam_answer, energy_of, load_of, problems_of, stiffness_of
from varistiff.fe.leaf_problem import LeafProblem, LeafResult
from varistiff.fe.leaf_solve import Progress, solve
from varistiff.fe.leaf_store import recall, remember


@dataclass(frozen=True)
class LeafCheck:
    """Elastica against solid at one point; SI units of the device.

    ``plain`` is the solid with Poisson's ratio 0, the independent check of the elastica: it differs from it by shear
    and thickness only, about 0.6 (h/L)^2 of the load of a cantilever. ``solid`` has the material's ratio: it says how
    far the plate effect (the leaf cannot bend across its width at clamp and contact) moves the truth, by a factor
    between 1 and 1/(1 - nu^2). Each holds one result a leaf.
    """

    deflection: float
    setting: float
    poissons_ratio: float
    beam_load: float
    beam_stiffness: float
    beam_energy: float
    beam_stress: float
    plain: tuple[LeafResult, ...]
    solid: tuple[LeafResult, ...]
    seconds: float

    @property
    def plain_load(self) -> float:
        """Load of the solid with Poisson's ratio 0."""
        return load_of(self.plain)

    @property
    def solid_load(self) -> float:
        """Load of the solid."""
        return load_of(self.solid)

    @property
    def plain_stiffness(self) -> float:
        """Tangent stiffness of the solid with Poisson's ratio 0."""
        return stiffness_of(self.plain)

    @property
    def solid_stiffness(self) -> float:
        """Tangent stiffness of the solid."""
        return stiffness_of(self.solid)

    @property
    def solid_energy(self) -> float:
        """Energy of the solid [J]."""
        return energy_of(self.solid)

    @property
    def solid_stress(self) -> float:
        """Largest bending stress of any leaf [Pa], off the clamp by ``stress_distance`` of the results."""
        return max(result.stress for result in self.solid)

    @property
    def error(self) -> float:
        """Error of the solid's load by refinement, relative to the sum of the leaves' absolute loads."""
        return _error(self.solid)

    @property
    def plain_error(self) -> float:
        """The same for Poisson's ratio 0."""
        return _error(self.plain)


def _error(results: tuple[LeafResult, ...]) -> float:
    whole = sum(abs(result.load) for result in results)
    return sum(result.error * abs(result.load) for result in results) / whole


def _solved(problem: LeafProblem, tolerance: float, progress: Progress | None, fresh: bool) -> LeafResult:
    kept = None if fresh else recall(problem, tolerance=tolerance)
    if kept is not None:
        return kept
    result = solve(problem, tolerance=tolerance, progress=progress)
    remember(result, tolerance=tolerance)
    return result


def check(
    actuator: Actuator,
    deflection: float,
    setting: float,
    *,
    poissons_ratio: float,
    tolerance: float = 0.005,
    fresh: bool = False,
    progress: Progress | None = None,
) -> LeafCheck:
    """Elastica, solid with Poisson's ratio 0 and solid at one point.

    Parameters
    ----------
    actuator : RollerBeam, AntagonisticLeaves or SliderLeafJoint
    deflection, setting : of the device, SI
    poissons_ratio : of the leaf's material [-]
    tolerance : relative, of every leaf's load
    fresh : whether to solve again what an earlier run has kept
    progress : told one line after every level

    Raises
    ------
    InputError : as ``problems_of`` and ``solve``
    """
    begun = time.perf_counter()
    beam, _ = beam_answer(actuator, deflection, setting)

    def solved(ratio: float) -> tuple[LeafResult, ...]:
        problems = problems_of(actuator, deflection, setting, poissons_ratio=ratio)
        return tuple(_solved(problem, tolerance, progress, fresh) for problem in problems)

    plain = solved(0.0)
    return LeafCheck(
        deflection=deflection,
        setting=setting,
        poissons_ratio=poissons_ratio,
        beam_load=beam.load,
        beam_stiffness=beam.stiffness,
        beam_energy=beam.energy,
        beam_stress=beam.stress,
        plain=plain,
        solid=plain if poissons_ratio == 0.0 else solved(poissons_ratio),
        seconds=time.perf_counter() - begun,
    )
