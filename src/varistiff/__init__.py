"""varistiff: variable stiffness actuators, from a design file to torque, stiffness, energy and a report.

>>> import varistiff
>>> varistiff.Status.YIELDED.label
'yielded'
"""

from __future__ import annotations

import os
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from varistiff.core.errors import InputError
    from varistiff.core.status import Status
    from varistiff.design.design import Design, load
    from varistiff.design.scenario import Scenario, Simulation, load_scenario
    from varistiff.report.analyse import Analysis

__all__ = [
    "Design",
    "InputError",
    "Scenario",
    "Simulation",
    "Status",
    "__version__",
    "analyse",
    "load",
    "load_scenario",
]

_HOME = {
    "Design": "varistiff.design.design",
    "InputError": "varistiff.core.errors",
    "Scenario": "varistiff.design.scenario",
    "Simulation": "varistiff.design.scenario",
    "Status": "varistiff.core.status",
    "load": "varistiff.design.design",
    "load_scenario": "varistiff.design.scenario",
}


def analyse(
    path: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    materials: str | os.PathLike[str] | None = None,
    progress: bool = False,
) -> Analysis:
    """Do the main job for a design file: map, datasheet, pictures, report and data in ``output``.

    Parameters
    ----------
    path : design file
    output : directory for the results
    materials : a file with your own materials, in place of the design's ``materials_file``
    progress : tell on the standard error stream what is being done

    The directory appears whole or not at all; an earlier result is replaced, anything else is refused.

    Raises
    ------
    InputError : the design is wrong, or the output cannot be written
    """
    from varistiff.core.writing import check_directory
    from varistiff.design.design import load

    design = load(path, materials=materials)
    check_directory(output)
    from varistiff.report.analyse import analyse

    return analyse(design, output, progress=progress)


def __getattr__(name: str) -> Any:
    """Import a public name on first use: the command line must start without JAX."""
    if name == "__version__":
        from importlib.metadata import PackageNotFoundError, version

        try:
            return version("varistiff")
        except PackageNotFoundError:  # run from a source tree
            return "0+unknown"
    if name in _HOME:
        return getattr(import_module(_HOME[name]), name)
    raise AttributeError(f"module 'varistiff' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
