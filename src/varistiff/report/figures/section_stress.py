"""Shear stress over the cross-section of a torsion element."""

from __future__ import annotations

import math

import matplotlib
import numpy as np
import xarray as xr
from matplotlib import patheffects
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from varistiff.actuators.actuator import Actuator
from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.core.errors import InputError
from varistiff.report.display import display
from varistiff.report.figures.field import NUMBERS
from varistiff.report.section_field import SectionField, section_field
from varistiff.report.style import INK, VERMILION, WIDTH, Drawing, styled
from varistiff.report.view import View
from varistiff.sections.filleted import filleted
from varistiff.sections.properties import SectionProperties
from varistiff.sections.section import Section

MM, MPA = 1e3, 1e-6
TITLE = "Shear stress over the section"
NEAR = (0.5, 1.5)  # the strength over the largest stress, for which the colour bar shows it
CLIPPED = 99.5  # percentile of the area at which the colours end where the stress is unbounded
ROUND = ("circle", "hollow_circle")


def draw(actuator: Actuator, dataset: xr.Dataset) -> Drawing | None:
    """Draw the section's stress at the largest ok torque of the map.

    None for a kind without torsion, and for a section with too many corners to have its stress point by point.
    """
    if not isinstance(actuator, TorsionTube):
        return None
    view = View.of(dataset)
    torque = np.abs(np.atleast_2d(np.asarray(dataset["torque"].values, float)))[view.ok]
    largest = float(torque.max()) if torque.size and torque.max() > 0.0 else 1.0
    section, strength = actuator.section, view.strength
    found = section.properties()
    try:
        field = section_field(section)
    except InputError:
        return None
    top = colour_top(field, found) * largest * MPA
    shown = None if strength is None else strength * MPA
    near = found.torsion_modulus > 0.0 and shown is not None and NEAR[0] < shown / top < NEAR[1]
    with styled():
        figure, axes, side = _sheet(field)
        image = paint(axes, field, torque=largest, top=max(top, 1.03 * shown) if near and shown is not None else top)
        if section.shape not in ROUND:
            mark(axes, found)
        _label(axes)
        bar = figure.colorbar(image, cax=side, extend="neither" if found.torsion_modulus > 0.0 else "max")
        bar.outline.set_linewidth(0.6)
        bar.ax.set_ylabel("Shear stress [MPa]", labelpad=8)
        bar.ax.yaxis.set_major_formatter(NUMBERS)
        if near and shown is not None:
            side.axhline(shown, color=VERMILION, linewidth=3.0)
    caption = f"Shear stress over the section at {display('N*m', largest).text(largest)}"
    caption += ", the largest torque of an ok point. " if torque.size else ". "
    caption += _words(section, found, largest, strength)
    if near and shown is not None:
        caption += f" The orange line on the scale is the shear yield strength, {display('Pa').text(strength)}."
    return Drawing("section_stress", TITLE, figure, caption)


def colour_top(field: SectionField, found: SectionProperties) -> float:
    """Stress over torque at which the colours end [1/m^3]: the largest, or where there is none most of the area's."""
    if found.torsion_modulus > 0.0:
        return 1.0 / found.torsion_modulus
    return float(np.nanpercentile(field.values, CLIPPED))


def paint(axes: Axes, field: SectionField, *, torque: float, top: float, offset: float = 0.0) -> AxesImage:
    """Colour a section by its shear stress from 0 to ``top`` [MPa]; axes in mm, moved right by ``offset`` [mm]."""
    path = Path(np.asarray(field.path.vertices) * MM + np.array([offset, 0.0]), field.path.codes)
    left, right, bottom, upper = (MM * value for value in field.extent)
    image = axes.imshow(
        field.filled * torque * MPA,
        origin="lower",
        extent=(left + offset, right + offset, bottom, upper),
        cmap=matplotlib.colormaps["cividis"],
        vmin=0.0,
        vmax=top,
        interpolation="bilinear",
        zorder=2.0,
    )
    edge = PathPatch(path, facecolor="none", edgecolor=INK, linewidth=1.0, zorder=3.0)
    axes.add_artist(edge)  # the axes have their limits: add_patch would look for the path's, slowly
    image.set_clip_path(edge)
    return image


def mark(axes: Axes, found: SectionProperties, *, offset: float = 0.0) -> None:
    """Ring the points of largest stress."""
    x, y = np.array(found.stress_points).T * MM
    axes.plot(
        x + offset,
        y,
        linestyle="none",
        marker="o",
        markersize=12.0,
        markerfacecolor="none",
        markeredgecolor=VERMILION,
        markeredgewidth=1.6,
        zorder=4.0,
        clip_on=False,
        path_effects=[patheffects.withStroke(linewidth=3.2, foreground="white")],
    )


def _sheet(field: SectionField) -> tuple[Figure, Axes, Axes]:
    """Axes of one scale both ways in the shape of the section, and the ones of the colour bar."""
    left, right, bottom, top = field.extent
    room = 0.06 * max(right - left, top - bottom)
    wide, tall = right - left + 2.0 * room, top - bottom + 2.0 * room
    across = min(0.62 * WIDTH, 4.2 * wide / tall)
    along = max(across * tall / wide, 1.2)
    height = along + 1.15
    figure = Figure(figsize=(WIDTH, height))
    axes = figure.add_axes((0.118, 0.68 / height, across / WIDTH, along / height))
    axes.set_xlim(MM * (left - room), MM * (right + room))
    middle, half = 0.5 * (bottom + top), 0.5 * wide * along / across
    axes.set_ylim(MM * (middle - half), MM * (middle + half))
    axes.grid(visible=False)
    side = figure.add_axes((0.118 + across / WIDTH + 0.035, 0.68 / height, 0.026, along / height))
    return figure, axes, side


def _label(axes: Axes) -> None:
    axes.set(xlabel="x [mm]", ylabel="y [mm]", title=TITLE)
    axes.xaxis.set_major_formatter(NUMBERS)
    axes.yaxis.set_major_formatter(NUMBERS)


def _words(section: Section, found: SectionProperties, torque: float, strength: float | None) -> str:
    if found.torsion_modulus > 0.0:
        text = display("Pa").text(torque / found.torsion_modulus)
        place = "along the whole rim" if section.shape in ROUND else "at the ringed points"
        return f"The largest, {text}, is reached {place}."
    words = (
        "At the ringed sharp corners the ideal stress is unbounded; the colours end at the stress that"
        f" {100.0 - CLIPPED:.2g} % of the area exceeds, and no point can count as yielded."
    )
    rounded = filleted(section)
    if rounded is None:
        return words
    stress = torque / rounded.torsion_modulus
    words += f" With a root fillet of {display('m').text(rounded.root_fillet)} the largest stress at this torque would"
    words += f" be {display('Pa').text(stress)}"
    if strength is not None and math.isfinite(strength):
        words += f", {'above' if stress > strength else 'below'} the shear yield strength of"
        words += f" {display('Pa').text(strength)}"
    return words + "."
