"""What ``varistiff validate`` says of one file."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from varistiff.core.errors import InputError
from varistiff.core.textfile import read_yaml_documents

if TYPE_CHECKING:
    from varistiff.design.design import Design


def checked(path: str, materials: str | None) -> tuple[Design, str]:
    """Read and build a design or a scenario file; returns the design, and the line that says it is ok.

    Raises
    ------
    InputError : something in it is wrong
    """
    if means_scenario(path):
        from varistiff.design.scenario import load_scenario

        scenario = load_scenario(path, materials=materials)
        design, about = scenario.design, f"{scenario.name} (scenario, {scenario.design.kind})"
        return design, f"{scenario.path}: ok: {about}, hash {scenario.hash[:12]}"
    from varistiff.design.design import load

    design = load(path, materials=materials)
    if design.kind == "torsion_tube":  # the other kinds need no JAX to be checked
        assert design.actuator.kind == design.kind  # built: whether its section can be solved shows only then
    return design, f"{design.path}: ok: {design.name} ({design.kind}), hash {design.hash[:12]}"


def means_scenario(path: str | os.PathLike[str]) -> bool:
    """Whether a file means to be a scenario and not a design: it names a plant or a design, and no actuator.

    An unreadable file means neither; reading it as one of them says what is wrong.
    """
    try:
        _, documents = read_yaml_documents(path)
    except InputError:
        return False
    first = documents[0]
    return isinstance(first, dict) and "actuator" not in first and not {"design", "plant"}.isdisjoint(first)
