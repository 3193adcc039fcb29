"""Small maps of every kind, computed once for all tests of the report."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
import xarray as xr

from varistiff.design.design import Design, load

LEAF = "{youngs_modulus: 206 GPa, width: 25 mm, thickness: 1 mm, yield_strength: 1400 MPa%s}"
BEAM = "{youngs_modulus: 194 GPa, width: 25.45 mm, thickness: 3.16 mm, length: 0.90 m, yield_strength: 500 MPa}"

ACTUATORS = {
    "series_elastic": "{kind: series_elastic, stiffness: 160 N*m/rad, deflection: {min: -10 deg, max: 10 deg}}",
    "maccepa": "{kind: maccepa, spring_rate: 394 N/m, lever_length: 36 mm, anchor_distance: 135 mm,"
    " setting: {min: 5 mm, max: 25 mm}, deflection: {min: -60 deg, max: 60 deg}}",
    "torsion_tube": "{kind: torsion_tube, material: pa2200, shear_modulus: 0.63 GPa, yield_strength: 48 MPa,"
    " section: {shape: hollow_circle, outer_radius: 11 mm, inner_radius: 8.7 mm}, length: 150 mm,"
    " setting: {min: 11 mm, max: 166 mm}, deflection: {min: -15 deg, max: 15 deg}}",
    "roller_beam": f"{{kind: roller_beam, beam: {BEAM}, mounting_angle: 0 deg, clamp_offset_along: 0 mm,"
    " clamp_offset_across: 0 mm, roller: {arrangement: swivelling_pair, offset: 0 mm, radius: 10 mm, clearance: 2 mm},"
    " setting: {min: 0.20 m, max: 0.60 m}, deflection: {min: -12 deg, max: 12 deg}}",
    "antagonistic_leaves": "{kind: antagonistic_leaves, leaf: {youngs_modulus: 210 GPa, width: 50 mm,"
    " thickness: 0.5 mm, yield_strength: 1500 MPa}, roller_distance: 345 mm, clamp_height: 40.5 mm,"
    " end_condition: sliding, setting: {min: 61.5 mm, max: 183 mm}, deflection: {min: -15 mm, max: 15 mm}}",
    "slider_leaf_joint": f"{{kind: slider_leaf_joint, leaf: {LEAF % ', count: 3'}, clamp_radius: 25 mm,"
    " beam_theory: large_deflection, groove: {outer_radius: 54 mm, outer_angle: 47 deg, arc_radius: 36.8 mm,"
    " centre: near}, setting: {min: 20 deg, max: 44 deg}, deflection: {min: -2 deg, max: 2 deg}}",
}


@cache
def design_of(kind: str, folder: Path, name: str = "'A design'") -> Design:
    """Design of a kind, read from a file as a user would."""
    path = folder / f"{kind}.yaml"
    path.write_text(f"name: {name}\nactuator: {ACTUATORS[kind]}\n", encoding="utf-8")
    return load(path)


@cache
def map_of(kind: str, folder: Path) -> xr.Dataset:
    """Map of a kind."""
    return design_of(kind, folder).map(deflection_points=61, setting_points=41)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One folder for the design files of the session."""
    return tmp_path_factory.mktemp("designs")


@pytest.fixture(scope="session", params=sorted(ACTUATORS))
def kind(request: pytest.FixtureRequest) -> str:
    """Every kind, one after the other."""
    return str(request.param)


@pytest.fixture
def design(kind: str, folder: Path) -> Design:
    """Design of the kind."""
    return design_of(kind, folder)


@pytest.fixture
def dataset(kind: str, folder: Path) -> xr.Dataset:
    """Map of the kind."""
    return map_of(kind, folder)
