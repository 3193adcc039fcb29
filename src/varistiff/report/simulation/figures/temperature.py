"""How warm the motors get."""

from __future__ import annotations

from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import Panel, Trace, draw_panels
from varistiff.report.style import ORANGE, PURPLE, Drawing, styled

TITLE = "Temperature of the windings"


def draw(run: Run) -> Drawing | None:
    """Draw the rise of each winding over ambient, with its limit; None where nothing warms."""
    panels = []
    for drive, title, colour in (("drive", "Drive", ORANGE), ("setting", "Setting drive", PURPLE)):
        name = f"{drive}_temperature"
        rise = run.telling(name)
        if rise is not None:
            traces = (Trace(rise, "above ambient", colour),)
            panels.append(Panel(title, run.unit(name), traces, run.limits(name)))
    if not panels:
        return None
    with styled():
        figure = draw_panels(run, panels, TITLE)
    return Drawing("temperature", TITLE, figure, "Temperature of the motor windings above ambient over time.")
