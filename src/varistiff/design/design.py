"""A design: what a user brings, validated and frozen, and the few questions one asks of it."""

from __future__ import annotations

import html
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from varistiff.core.errors import InputError
from varistiff.core.textfile import printable_path
from varistiff.design.build import build
from varistiff.design.read import read_spec
from varistiff.design.resolve import canonical, design_hash, resolved, unlimited
from varistiff.design.section_spec import OutlineSpec, SplinedTubeSpec
from varistiff.design.spec import (
    AntagonisticLeavesSpec,
    AnyActuatorSpec,
    DesignSpec,
    LeafSpec,
    SeriesElasticSpec,
    SliderLeafJointSpec,
    TorsionTubeSpec,
)
from varistiff.materials import Material, find_material, read_materials

if TYPE_CHECKING:
    import numpy.typing as npt
    import xarray as xr

    from varistiff.actuators.actuator import Actuator
    from varistiff.characteristic.evaluate import Points

Progress = Callable[[int, int], None]

_SLENDERNESS_LIMIT = 5.4  # dos Santos and Richter 2019: below it shear deformation is not negligible


@dataclass(frozen=True)
class Design:
    """A variable stiffness actuator as its file states it; ``load`` makes one.

    Parameters
    ----------
    name : title
    path : file it was read from, as the user wrote it
    text : the file's text
    spec : the validated file, in SI units
    elements : the actuator's spec with its material's values filled in, in SI units
    material : of the elastic element, where it has one
    """

    name: str
    path: str
    text: str = field(repr=False)
    spec: DesignSpec = field(repr=False)
    elements: AnyActuatorSpec = field(repr=False)
    material: Material | None = field(default=None, repr=False)

    @property
    def kind(self) -> str:
        """Kind of actuator."""
        return self.elements.kind

    @cached_property
    def actuator(self) -> Actuator:
        """The actuator, ready to compute; the first access imports JAX."""
        try:
            return build(self.elements)
        except InputError as error:
            raise error.located(file=self.path) from None

    @cached_property
    def hash(self) -> str:
        """SHA-256 of the canonical spec: changes with values, not with layout, comments, units or name."""
        return design_hash(self.elements)

    @property
    def canonical(self) -> str:
        """The text that ``hash`` is taken of."""
        return canonical(self.elements)

    @property
    def deflection_unit(self) -> str:
        """SI unit of the deflection: "rad" for a joint, "m" for a linear spring."""
        return "m" if isinstance(self.elements, AntagonisticLeavesSpec) else "rad"

    @property
    def setting_unit(self) -> str | None:
        """SI unit of the setting: "m", "rad", or None for a kind without one."""
        if isinstance(self.elements, SeriesElasticSpec):
            return None
        disc = isinstance(self.elements, SliderLeafJointSpec) and self.elements.driven_by == "disc"
        return "rad" if disc else "m"

    @property
    def deflection_range(self) -> tuple[float, float]:
        """Smallest and largest deflection of the map, in SI units."""
        return self.elements.deflection.bounds

    @property
    def setting_range(self) -> tuple[float, float] | None:
        """Smallest and largest setting of the map, in SI units; None for a kind without a setting."""
        if isinstance(self.elements, SeriesElasticSpec):
            return None
        return self.elements.setting.bounds

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """What is allowed but probably not meant, one sentence each."""
        return tuple(_warnings(self.elements))

    def evaluate(self, deflection: npt.ArrayLike, setting: npt.ArrayLike | None = None) -> Points:
        """Return status, energy, load, stiffness, adjusting load and stress at points.

        Parameters
        ----------
        deflection : drive angle minus link angle [rad], or the stretch of a linear spring [m]; any shape
        setting : [m] or [rad], broadcast against the deflection; left out for a kind without a setting

        Raises
        ------
        InputError : a setting is missing, or given to a kind that has none
        """
        from varistiff.characteristic.evaluate import evaluate

        if setting is None and self.setting_unit is not None:
            raise InputError(f"the setting is missing; a {self.kind} needs one in {self.setting_unit}", file=self.path)
        if setting is not None and self.setting_unit is None:
            raise InputError(f"a {self.kind} has no setting; leave it out", file=self.path)
        return evaluate(self.actuator, deflection, setting)

    def map(
        self,
        *,
        deflection_points: int = 201,
        setting_points: int = 101,
        progress: bool | Progress = False,
    ) -> xr.Dataset:
        """Return the characteristic map over the design's ranges as a labelled dataset.

        Parameters
        ----------
        deflection_points, setting_points : size of the even grid, each at least 2
        progress : True shows a bar; a function is called with (points done, points in all)
        """
        import numpy as np

        from varistiff.characteristic.map import characteristic_map

        for name, points in (("deflection_points", deflection_points), ("setting_points", setting_points)):
            if points < 2:
                raise InputError(f"is {points}; allowed is 2 or more", field=name)
        deflection = np.linspace(*self.deflection_range, deflection_points)
        bounds = self.setting_range
        setting = None if bounds is None else np.linspace(*bounds, setting_points)
        with _shown(progress) as report:
            return characteristic_map(
                self.actuator,
                deflection=deflection,
                setting=setting,
                attrs=self.attributes,
                progress=report,
            )

    @property
    def attributes(self) -> dict[str, str]:
        """What a dataset says about the design it comes from."""
        return {"title": self.name, "kind": self.kind, "design": self.text, "design_hash": self.hash}

    def __repr__(self) -> str:
        deflection = _range(self.deflection_range, self.deflection_unit)
        setting = _range(self.setting_range, self.setting_unit)
        ranges = f"deflection {deflection}, setting {setting}"
        return f"<Design {self.name!r}: {self.kind}, {ranges}, hash {self.hash[:12]}>"

    def _repr_html_(self) -> str:
        rows = {
            "kind": self.kind,
            "deflection": _range(self.deflection_range, self.deflection_unit),
            "setting": _range(self.setting_range, self.setting_unit),
            "file": self.path,
            "hash": self.hash[:12],
            **{f"warning {number}": text for number, text in enumerate(self.warnings, start=1)},
        }
        cells = "".join(
            f"<tr><th style='text-align:left'>{html.escape(key)}</th>"
            f"<td style='text-align:left'>{html.escape(value)}</td></tr>"
            for key, value in rows.items()
        )
        return f"<table><caption>{html.escape(self.name)}</caption>{cells}</table>"


def load(path: str | os.PathLike[str], *, materials: str | os.PathLike[str] | None = None) -> Design:
    """Return the design of a file.

    Parameters
    ----------
    path : design file, YAML with units in words
    materials : file with your own materials, in place of the design's ``materials_file``

    Raises
    ------
    InputError : one line with file, field, what is wrong and what is allowed
    """
    if not isinstance(path, str | os.PathLike):
        raise InputError(f"load takes the path of a design file, not a {type(path).__name__}")
    spec, text = read_spec(path)
    return design_of(spec, text=text, path=path, materials=materials)


def design_of(
    spec: DesignSpec, *, text: str, path: str | os.PathLike[str], materials: str | os.PathLike[str] | None = None
) -> Design:
    """Return the design of a validated spec.

    Parameters
    ----------
    spec, text : as they stand in a file
    path : of that file; what the spec names lies relative to it
    materials : as in ``load``

    Raises
    ------
    InputError : a material or an outline that is wrong
    """
    file = printable_path(os.fspath(path))
    own = _own_materials(spec, Path(path), materials)
    try:
        elements = resolved(spec.actuator, own, directory=Path(path).parent)
    except InputError as error:
        raise error.located(file=file) from None
    return Design(
        name=spec.name, path=file, text=text, spec=spec, elements=elements, material=_material(spec.actuator, own)
    )


@contextmanager
def _shown(progress: bool | Progress) -> Iterator[Progress | None]:
    """Give what ``evaluate`` calls after each block of points."""
    if not isinstance(progress, bool):
        yield progress
        return
    if not progress:
        yield None
        return
    from rich.progress import Progress as Bar

    with Bar(transient=True) as bar:
        task = bar.add_task("map")
        yield lambda done, total: bar.update(task, completed=done, total=total)


def _own_materials(
    spec: DesignSpec, path: Path, materials: str | os.PathLike[str] | None
) -> Mapping[str, Material] | None:
    if materials is not None:
        return read_materials(materials)
    if spec.materials_file is None:
        return None
    return read_materials(path.parent / spec.materials_file)


def _material(spec: AnyActuatorSpec, own: Mapping[str, Material] | None) -> Material | None:
    for part in (spec, getattr(spec, "beam", None), getattr(spec, "leaf", None)):
        if isinstance(part, TorsionTubeSpec | LeafSpec) and part.material is not None:
            return find_material(part.material, extra=own)
    return None


def _range(bounds: tuple[float, float] | None, unit: str | None) -> str:
    return "none" if bounds is None else f"{bounds[0]:.6g} to {bounds[1]:.6g} {unit}"


def _warnings(elements: AnyActuatorSpec) -> list[str]:
    found: list[str] = []
    for name in ("beam", "leaf"):
        leaf: Any = getattr(elements, name, None)
        if isinstance(leaf, LeafSpec) and leaf.length is not None:
            slenderness = leaf.length / leaf.thickness
            if slenderness < _SLENDERNESS_LIMIT:
                found.append(
                    f"actuator.{name}: length/thickness is {slenderness:.3g}, below {_SLENDERNESS_LIMIT}: "
                    "the model leaves out shear deformation, which is not small here"
                )
    joint = elements if isinstance(elements, SliderLeafJointSpec) else None
    if joint is not None and joint.groove is not None and not joint.groove.meets_each_angle_once(joint.clamp_radius):
        found.append("actuator.groove: meets a disc angle twice; it limits the active length but gives no disc angle")
    tube = elements if isinstance(elements, TorsionTubeSpec) else None
    if tube is not None and tube.length is not None and tube.setting.max > tube.length:
        found.append("actuator.setting.max: is above the element's length: points beyond are element_too_short")
    if tube is not None and _has_sharp_root(tube):
        found.append(
            "actuator.section: a sharp re-entrant corner: the ideal stress is unbounded there, inf under load, and "
            "nothing is reported as yielded; give it a fillet"
        )
    return [*found, *unlimited(elements)]


def _has_sharp_root(tube: TorsionTubeSpec) -> bool:
    section = tube.section
    if isinstance(section, SplinedTubeSpec):
        return section.root_fillet == 0.0
    if isinstance(section, OutlineSpec):
        from varistiff.sections.boundary import sharp_corners
        from varistiff.sections.outline import Outline

        return any(corner.is_reentrant for corner in sharp_corners(Outline(section.loops)))
    return False
