"""Seven numbers of the roller beam against 40 digits, on a seeded sample of devices and points."""

from __future__ import annotations

import math
from types import ModuleType

import numpy as np
import pytest

from varistiff.actuators import RollerBeam, SingleLower, SingleUpper, SwivellingPair
from varistiff.characteristic.evaluate import evaluate
from varistiff.elastic.leaf import Leaf

BEAM = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316)
FAR, NEAR = 1e-11, 1e-7  # shares of F, L, F x_r, F, V, F x_r^2; NEAR within 1e-3 rad of contact and fold


def _random(rng: np.random.Generator) -> dict[str, float]:
    return {
        "mounting_angle": float(rng.uniform(-0.2, 0.2)),
        "clamp_offset_along": float(rng.uniform(-0.05, 0.05)),
        "clamp_offset_across": float(rng.uniform(-0.02, 0.02)),
    }


def _arranged(rng: np.random.Generator, kind: int) -> tuple[SingleLower | SingleUpper | SwivellingPair, float, bool]:
    offset, size = float(rng.uniform(-0.02, 0.02)), float(rng.uniform(0.0005, 0.02))
    if kind == 0:
        return SingleLower(offset=offset, radius=size), size + BEAM.thickness / 2, False
    if kind == 1:
        return SingleUpper(offset=offset, radius=size), size + BEAM.thickness / 2, True
    return SwivellingPair(offset=offset, clearance=size / 10), -size / 10, kind == 3


@pytest.mark.parametrize("kind", range(4), ids=["lower", "upper", "swivelling up", "swivelling down"])
def test_digits(reference: ModuleType, kind: int) -> None:
    """Random offsets, radii, settings and angles from rest to past the fold; at least half of them in contact."""
    rng = np.random.default_rng(20 + kind)
    solved = 0
    for _ in range(24):
        offsets = _random(rng)
        rollers, radius, upper = _arranged(rng, kind)
        setting = float(rng.uniform(0.15, 0.6))
        deflection = float(rng.uniform(-0.1, 1.8)) * (-1 if upper else 1)
        here = evaluate(RollerBeam(beam=BEAM, rollers=rollers, **offsets), [deflection], [setting])
        try:
            exact = reference.joint(
                setting,
                deflection,
                flexural_rigidity=BEAM.flexural_rigidity,
                radius=radius,
                roller_offset=rollers.offset,
                upper=upper,
                **offsets,
            )
        except reference.BeyondFoldError:
            assert here.status[0] == 1
            continue
        except reference.NoContactError:
            # the other roller of a swivelling pair may touch instead
            assert here.status[0] == 3 or (kind > 1 and np.sign(here.details["root_moment"][0]) == np.sign(kind - 2.5))
            continue
        assert here.status[0] == 0
        solved += 1
        force, slope = float(exact.force), abs(float(exact.slope))
        share = FAR if 1e-3 < slope < math.radians(165) else NEAR
        pairs = {
            "slope": (here.details["contact_slope"][0], exact.slope, slope),
            "force": (here.details["contact_force"][0], exact.force, force),
            "length": (here.details["active_length"][0], exact.length, float(exact.length)),
            "moment": (here.load[0], exact.moment, force * setting),
            "thrust": (here.adjusting_load[0], exact.thrust, force),
            "energy": (here.energy[0], exact.energy, float(exact.energy)),
            "stiffness": (here.stiffness[0], exact.stiffness, force * setting**2),
        }
        for name, (found, wanted, scale) in pairs.items():
            assert abs(float(found - wanted)) <= share * scale, (name, offsets, deflection, setting)
    assert solved >= 12
