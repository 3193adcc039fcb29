"""Energy and voltage of the storage."""

from __future__ import annotations

from varistiff.report.simulation.figures.stiffness import varies
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import Panel, Trace, draw_panels
from varistiff.report.style import BLUE, GREEN, Drawing, styled

TITLE = "Storage"


def draw(run: Run) -> Drawing | None:
    """Draw energy and voltage over time; None where the storage has no content that changes."""
    energy, voltage = run.telling("storage_energy"), run.telling("storage_voltage")
    if energy is None or not varies(energy):
        return None
    traces = (Trace(energy, "stored", BLUE),)
    panels = [Panel("Energy", run.unit("storage_energy"), traces, run.limits("storage_energy"))]
    if voltage is not None:
        traces = (Trace(voltage, "open circuit", GREEN),)
        panels.append(Panel("Voltage", run.unit("storage_voltage"), traces, run.limits("storage_voltage")))
    with styled():
        figure = draw_panels(run, panels, TITLE)
    return Drawing("storage", TITLE, figure, "Energy in the storage and its voltage over time.")
