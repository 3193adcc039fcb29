"""A leaf device by beam theory and in three dimensions."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from varistiff.actuators.actuator import Actuator
from varistiff.characteristic.evaluate import evaluate
from varistiff.fe.comparison import Comparison, Method
from varistiff.fe.leaf_check import LeafCheck


def compare_leaves(
    actuator: Actuator,
    points: Sequence[tuple[float, float]],
    check: Callable[[int, float, float], LeafCheck],
) -> Comparison:
    """Load by the design's own theory, by the elastica, by the solid without lateral contraction, and by the solid.

    Parameters
    ----------
    points : (deflection, setting), SI
    check : the solver, called with the number of the point, its deflection and its setting
    """
    checks = [check(number, *point) for number, point in enumerate(points)]
    deflection, setting = np.array([(one.deflection, one.setting) for one in checks]).T
    unknown = np.full(len(checks), np.nan)
    own = np.asarray(evaluate(actuator, deflection, setting).load)
    elastica = np.array([one.beam_load for one in checks])
    plain, plain_errors = np.array([(one.plain_load, one.plain_error) for one in checks]).T
    solid, errors = np.array([(one.solid_load, one.error) for one in checks]).T
    methods = [Method("design", "the design's theory", own, unknown)]
    if not np.allclose(own, elastica, rtol=1e-9):  # a small-deflection theory
        methods.append(Method("elastica", "elastica", elastica, unknown))
    methods += [
        Method("solid_plain", "3-D, Poisson's ratio 0", plain, plain_errors),
        Method("solid", "3-D", solid, errors),
    ]
    torque = actuator.deflection_unit == "rad"
    return Comparison(
        quantity="torque" if torque else "force",
        unit="N*m" if torque else "N",
        setting=setting,
        deflection=deflection,
        methods=tuple(methods),
        remarks=tuple(_remarks(checks)),
        leaf=checks[-1].solid[0],
    )


def _remarks(checks: Sequence[LeafCheck]) -> list[str]:
    nu = checks[0].poissons_ratio
    said = [
        "With Poisson's ratio 0 the solid is the independent check of the elastica: they differ by shear and "
        "thickness only.",
        f"With the material's ratio {nu:.3g} a wide leaf is stiffer, because clamp and contact keep it from bending "
        f"across its width: by a factor of at most 1/(1 - nu^2) = {1.0 / (1.0 - nu * nu):.4g}.",
    ]
    stress = [(one.solid_stress / one.beam_stress - 1.0, one) for one in checks if one.beam_stress > 0.0]
    if stress:
        worst, one = max(stress, key=lambda pair: abs(pair[0]))
        distance = 1e3 * one.solid[0].stress_distance
        said.append(
            f"Largest bending stress in the solid, at least {distance:.3g} mm off the clamp whose edge is singular: at "
            f"most {100.0 * worst:+.2g} % from the elastica's; most of it is the plate effect at the clamp."
        )
    return said
