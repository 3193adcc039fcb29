"""From SI numbers to what people read: degrees, millimetres, megapascals, and four significant digits."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Display:
    """Multiply an SI value by ``factor`` to have it in ``unit``."""

    factor: float
    unit: str

    def text(self, value: float | None) -> str:
        """Value with its unit."""
        number_text = number(None if value is None else value * self.factor)
        return f"{number_text} {self.unit}".strip() if number_text != MISSING else MISSING


MISSING = "\N{EM DASH}"
_DOT = "\N{MIDDLE DOT}"

# SI unit: (largest magnitude in SI below which the choice holds, factor, unit to show), tried in order
_CHOICES: dict[str, tuple[tuple[float, float, str], ...]] = {
    "rad": ((math.inf, 180.0 / math.pi, "deg"),),
    "m": ((math.inf, 1e3, "mm"),),
    "m^2": ((math.inf, 1e6, "mm²"),),
    "m^3": ((math.inf, 1e9, "mm³"),),
    "m^4": ((math.inf, 1e12, "mm⁴"),),
    "Pa": ((math.inf, 1e-6, "MPa"),),
    "J": ((0.2, 1e3, "mJ"), (1e4, 1.0, "J"), (math.inf, 1e-3, "kJ")),
    "N": ((0.02, 1e3, "mN"), (1e4, 1.0, "N"), (math.inf, 1e-3, "kN")),
    "N*m": ((0.02, 1e3, f"mN{_DOT}m"), (1e4, 1.0, f"N{_DOT}m"), (math.inf, 1e-3, f"kN{_DOT}m")),
    "N*m/rad": ((1e5, 1.0, f"N{_DOT}m/rad"), (math.inf, 1e-3, f"kN{_DOT}m/rad")),
    "N/m": ((1e6, 1e-3, "N/mm"), (math.inf, 1e-6, "kN/mm")),
    "1/m": ((math.inf, 1.0, "1/m"),),
    "1": ((math.inf, 1.0, ""),),
}


def display(unit: str, magnitude: float = 1.0) -> Display:
    """Unit that people read for an SI unit, given the largest magnitude that is shown with it."""
    plain = unit.replace(_DOT, "*").strip()
    if plain in ("N m", "N m/rad", "N m rad-1", "N m rad^-1"):
        plain = "N*m" if plain == "N m" else "N*m/rad"
    for below, factor, name in _CHOICES.get(plain, ()):
        if abs(magnitude) < below or below == math.inf:
            return Display(factor, name)
    return Display(1.0, plain)


def number(value: float | None) -> str:
    """Four significant digits, a real minus sign, no exponent where a person would not write one."""
    if value is None or math.isnan(value):
        return MISSING
    if math.isinf(value):
        return "infinite" if value > 0.0 else "\N{MINUS SIGN}infinite"
    if value == 0.0:
        return "0"
    exponent = math.floor(math.log10(abs(value)))
    if exponent >= 6 or exponent < -4:
        mantissa, power = f"{value:.3e}".split("e")
        text = f"{mantissa.rstrip('0').rstrip('.')}e{int(power)}"
    else:
        text = f"{value:.{max(3 - exponent, 0)}f}"
        if "." in text:
            text = text.rstrip("0").rstrip(".")
    return text.replace("-", "\N{MINUS SIGN}")
