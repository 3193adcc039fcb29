"""What the computed torsion figures share: the plastics of the material table, and how they are drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from varistiff.materials.table import builtin_materials
from varistiff.report.style import BLUE, GREEN, ORANGE, PURPLE, VERMILION

SAFETY = 2.0
NAMES = {"pe": "PE-HD", "pa2200": "PA 2200", "pom": "POM-C", "peek": "PEEK", "tpu": "TPU 80 A"}
LOOKS = {
    "pe": (BLUE, "solid"),
    "pa2200": (VERMILION, (0, (6, 2))),
    "pom": (GREEN, (0, (6, 2, 1.2, 2))),
    "peek": (PURPLE, (0, (2.5, 1.5))),
    "tpu": (ORANGE, (0, (1.2, 1.4))),
}


@dataclass(frozen=True)
class Plastic:
    """Name, shear modulus [Pa], allowed shear stress [Pa], and how its line looks."""

    name: str
    shear_modulus: float
    allowed: float
    colour: str
    dashes: object


def plastics() -> list[Plastic]:
    """Return the plastics, allowed up to yield_strength/sqrt(3) over the safety factor."""
    table = builtin_materials()
    found = []
    for key, name in NAMES.items():
        modulus, strength = table[key].shear_modulus, table[key].yield_strength
        if modulus is None or strength is None:
            raise ValueError(f"the material table gives no modulus or no strength of {key}")
        colour, dashes = LOOKS[key]
        found.append(Plastic(name, modulus.value, strength.value / math.sqrt(3.0) / SAFETY, colour, dashes))
    return found


def smallest_radius(torque: float, allowed: float) -> float:
    """Radius of a solid circle that carries a torque [N m] at the allowed shear stress [Pa], in m."""
    return (2.0 * torque / (math.pi * allowed)) ** (1.0 / 3.0)


def legend(figure: Figure, *, x: float) -> None:
    """Name the lines in the free column on the right."""
    handles = [Line2D([], [], color=one.colour, linestyle=one.dashes, label=one.name) for one in reversed(plastics())]
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(x, 0.91), handlelength=2.6)
