"""Position wanted and reached, the error, and what pushes from outside."""

from __future__ import annotations

from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import WANTED, Panel, Trace, draw_panels
from varistiff.report.style import BLUE, INK, ORANGE, PURPLE, VERMILION, Drawing, styled


def draw(run: Run) -> Drawing | None:
    """Draw the position of link and drive over time; None without a link."""
    link, drive, wanted = run.given("link"), run.telling("drive"), run.given("wanted_position")
    if link is None:
        return None
    unit = run.unit("link")
    traces = [Trace(link, "link", BLUE, width=2.4)]
    if drive is not None:
        traces.insert(0, Trace(drive, "drive", ORANGE, width=1.5))
    if wanted is not None:
        traces.append(Trace(wanted, "wanted", INK, WANTED, 1.5))
    panels = [Panel("Position", unit, tuple(traces), run.limits("link"))]
    if wanted is not None:
        panels.append(Panel("Error", unit, (Trace(wanted - link, "wanted minus\nlink", VERMILION),)))
    pushing = run.telling("external_torque")
    if pushing is not None:
        unit = run.unit("external_torque")
        panels.append(Panel("External load", unit, (Trace(pushing, "resists the\nlink where > 0", PURPLE),)))
    with styled():
        figure = draw_panels(run, panels, "Position")
    caption = "Position of the link" + (" and of the drive" if drive is not None else "")
    caption += " over time, and how far it is from what was wanted." if wanted is not None else " over time."
    return Drawing("tracking", "Position", figure, caption)
