"""What a result says of itself."""

from __future__ import annotations

import math
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from varistiff.actuators.actuator import Actuator

SIGN_CONVENTION = (
    "deflection = drive angle minus link angle (the spring's stretch); load = dV/d(deflection) acts on the link in its "
    "positive direction and back on the drive; adjusting load = dV/d(setting) > 0: the stiffness drive must push in "
    "the positive direction of the setting to hold it; stiffness is the tangent stiffness d2V/d(deflection)2"
)


def package_versions(packages: Sequence[str]) -> list[str]:
    """Name and version of varistiff and of the packages given, in that order."""
    versions = []
    for package in ("varistiff", *packages):
        try:
            versions.append(f"{package} {version(package)}")
        except PackageNotFoundError:
            versions.append(f"{package} (not installed as a package)")
    return versions


def provenance(actuator: Actuator, *, packages: Sequence[str] = ("jax", "numpy", "xarray")) -> dict[str, Any]:
    """Kind, signs, versions, papers and strength, as attributes of a dataset.

    Parameters
    ----------
    packages : whose versions matter to the numbers, beside varistiff's own
    """
    strength = actuator.strength
    versions = package_versions(packages)
    return {
        "Conventions": "CF-1.11",
        "kind": actuator.kind,
        "sign_convention": SIGN_CONVENTION,
        "versions": ", ".join(versions),
        "varistiff_version": versions[0].removeprefix("varistiff "),
        "references": " ".join(actuator.references),
        "broken_assumption": actuator.broken_assumption,
        **({} if strength is None or not math.isfinite(strength) else {"strength": float(strength)}),
    }
