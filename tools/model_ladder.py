"""Compute the model ladder of docs/model_ladder.md: its table and its figure.

Run ``python tools/model_ladder.py``; a test holds the page against what this computes.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np

from varistiff.actuators import RollerBeam
from varistiff.characteristic.ladder import RUNGS, Ladder, model_ladder
from varistiff.report import style

PAGE = Path(__file__).parents[1] / "docs/model_ladder.md"
FIGURE = PAGE.parent / "images/model_ladder.svg"
CLAMP_RADIUS = 0.025  # Wang et al. (2024), Table 2


def ladders() -> dict[str, Ladder]:
    """The two joints; the roller beam with its clamp at the joint has the same ladder at every setting."""
    assert RollerBeam.kind == "roller_beam"  # importing the actuators has switched JAX to double precision
    cases = {"roller beam, any setting": model_ladder(
        radius=0.4, length=0.4, flexural_rigidity=12.98, deflection_max=math.radians(90.0), points=1800
    )}  # fmt: skip
    for millimetres, last in ((6.0, 8.0), (15.0, 14.0), (25.0, 20.0)):
        length = 1e-3 * millimetres
        cases[f"slider leaf joint, {millimetres:.0f} mm"] = model_ladder(
            radius=CLAMP_RADIUS + length,
            length=length,
            flexural_rigidity=0.429,
            deflection_max=math.radians(last),
            points=1800,
        )
    return cases


def table(cases: dict[str, Ladder]) -> str:
    """Largest deflection with at most 1 % error, in degrees, torque and stiffness apart."""
    lines = ["| theory | " + " | ".join(cases) + " |", "|---|" + "---|" * len(cases)]
    for index, name in enumerate(RUNGS):
        cells = []
        for ladder in cases.values():
            rung = ladder.rungs[index]
            good = [ladder.good_to(rung, quantity) for quantity in ("torque", "stiffness")]
            cells.append(" / ".join(_angle(reached, float(ladder.deflection[-1])) for reached in good))
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _angle(reached: float, last: float) -> str:
    if reached == 0.0:
        return "never"
    return f"{'≥ ' if reached == last else ''}{math.degrees(reached):.1f}°"


def figure(cases: dict[str, Ladder]) -> style.Drawing:
    """Absolute error over deflection for the roller beam and the slider leaf joint at 25 mm."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import FuncFormatter

    shown = {
        "Roller beam": cases["roller beam, any setting"],
        "Slider leaf joint, 25 mm": cases["slider leaf joint, 25 mm"],
    }
    colours = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE, style.ORANGE)
    dashes = ("solid", (0, (5, 1.5)), (0, (1.2, 1.4)), (0, (5, 1.5, 1.2, 1.5)), (0, (9, 2)))
    with style.styled():
        drawing = Figure(figsize=(9.2, 7.4))
        axes = drawing.subplots(2, 2, sharey=True, sharex="col")
        for column, (title, ladder) in enumerate(shown.items()):
            for row, quantity in enumerate(("torque", "stiffness")):
                panel = axes[row, column]
                for rung, colour, dash in zip(ladder.rungs[:-1], colours, dashes, strict=True):
                    error = 100.0 * np.abs(ladder.error(rung, quantity))
                    panel.plot(np.degrees(ladder.deflection), error, color=colour, linestyle=dash, label=rung.name)
                panel.axhline(1.0, color=style.SOFT, linewidth=1.0)
                panel.set_yscale("log")
                panel.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
                panel.set_ylim(0.01, 200.0)
                panel.set_xlim(0.0, 60.0 if column == 0 else 15.0)  # beyond, the exact stiffness nears zero
                if column == 0:
                    panel.set_ylabel(f"error in {quantity} [%]")
                if row == 0:
                    panel.set_title(title)
                else:
                    panel.set_xlabel("deflection [deg]")
        handles, labels = axes[0, 0].get_legend_handles_labels()
        drawing.legend(handles, labels, loc="lower center", ncols=3, bbox_to_anchor=(0.5, 0.005))
        drawing.subplots_adjust(left=0.095, right=0.975, top=0.945, bottom=0.165, hspace=0.12, wspace=0.06)
    caption = "Error of five simple theories against the exact elastica; the grey line is 1 %."
    return style.Drawing("model_ladder", "Model ladder", drawing, caption)


def main() -> None:
    cases = ladders()
    text = PAGE.read_text(encoding="utf-8")
    rows = table(cases)
    print(rows)
    text = re.sub(r"(<!-- ladder -->\n).*?(<!-- end -->)", lambda m: m[1] + rows + "\n" + m[2], text, flags=re.S)
    PAGE.write_text(text, encoding="utf-8")
    FIGURE.parent.mkdir(exist_ok=True)
    drawn = figure(cases)
    FIGURE.write_text(drawn.svg(), encoding="utf-8")


if __name__ == "__main__":
    main()
