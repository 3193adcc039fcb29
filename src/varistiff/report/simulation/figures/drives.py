"""What each drive gives and takes: torque, current, voltage, power."""

from __future__ import annotations

from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import WANTED, Panel, Trace, draw_panels
from varistiff.report.style import BLUE, GREEN, INK, ORANGE, PURPLE, Drawing, styled


def draw_drive(run: Run) -> Drawing | None:
    """Draw the drive that moves the joint; None where it does nothing."""
    return _draw(run, "drive", "Drive")


def draw_setting(run: Run) -> Drawing | None:
    """Draw the drive that moves the setting; None where it does nothing."""
    return _draw(run, "setting", "Setting drive")


def _draw(run: Run, drive: str, title: str) -> Drawing | None:
    panels = [panel for panel in (_effort(run, drive), *_electrical(run, drive)) if panel is not None]
    if not panels:
        return None
    with styled():
        figure = draw_panels(run, panels, title)
    shown = " and ".join([", ".join(panel.name.lower() for panel in panels[:-1]), panels[-1].name.lower()][-2:])
    shown = shown.removeprefix(" and ")
    limited = any(abs(limit) < float("inf") for panel in panels for limit in panel.limits)
    caption = f"{title}: {shown} over time"
    caption += ", with the limits of the drive." if limited else "."
    if any(panel.name == "Power" for panel in panels):
        caption += " Electrical power is drawn from the bus; below zero it is given back."
    return Drawing(f"{drive}_drive" if drive == "setting" else "drive", title, figure, caption)


def _effort(run: Run, drive: str) -> Panel | None:
    """Torque at the drive's output, or force of a drive that moves a length."""
    torque, command = run.telling(f"{drive}_torque"), run.telling(f"{drive}_command")
    if torque is None and command is None:
        return None
    unit = run.unit(f"{drive}_torque")
    traces = []
    if torque is not None:
        traces.append(Trace(torque, "at the output", BLUE))
    if command is not None:
        traces.append(Trace(command, "commanded", INK, WANTED, 1.3))
    name = "Force" if unit.strip() == "N" else "Torque"
    return Panel(name, unit, tuple(traces), run.limits(f"{drive}_torque"))


def _electrical(run: Run, drive: str) -> list[Panel]:
    panels = []
    for name, label, colour in (
        ("current", "motor", ORANGE),
        ("voltage", "motor", GREEN),
        ("power", "electrical", PURPLE),
    ):
        values = run.telling(f"{drive}_{name}")
        if values is not None:
            traces = (Trace(values, label, colour),)
            key = f"{drive}_{name}"
            panels.append(Panel(name.capitalize(), run.unit(key), traces, run.limits(key)))
    return panels
