"""A scenario: a design in motion, validated and frozen, and the run that comes of it."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from varistiff.core.errors import InputError
from varistiff.core.textfile import printable_path
from varistiff.design.design import Design, design_of, load
from varistiff.design.scenario_read import read_scenario
from varistiff.design.scenario_spec import ScenarioSpec

if TYPE_CHECKING:
    import xarray as xr

    from varistiff.dynamics.audit import Audit
    from varistiff.dynamics.outcome import Event, Metric, Outcome
    from varistiff.dynamics.program import Case
    from varistiff.dynamics.simulate import Run

Tell = Callable[[str], None]


@dataclass(frozen=True)
class Scenario:
    """A scenario as its file states it; ``load_scenario`` makes one.

    Parameters
    ----------
    name : title
    path : file it was read from, as the user wrote it
    text : the file's text
    spec : the validated file
    design : what moves
    case : what a run is computed from, in SI units
    hash : SHA-256 of the content, its design and its trajectory files
    """

    name: str
    path: str
    text: str = field(repr=False)
    spec: ScenarioSpec = field(repr=False)
    design: Design
    case: Case = field(repr=False)
    hash: str

    @property
    def duration(self) -> float:
        """How long it lasts [s]."""
        return self.spec.duration

    @property
    def step(self) -> float | None:
        """Step of the integration that the user chose [s]; None where varistiff chooses."""
        return self.spec.step

    @property
    def warnings(self) -> tuple[str, ...]:
        """What is allowed but probably not meant, one sentence each: the design's."""
        return self.design.warnings

    @property
    def attributes(self) -> dict[str, Any]:
        """What a dataset says about the scenario that it comes from."""
        gravity = self.case.plant.gravity
        return {
            **self.design.attributes,
            "title": self.name,
            "design_name": self.design.name,
            "scenario": self.text,
            "scenario_hash": self.hash,
            **({} if gravity is None else {"gravity_rest": float(gravity.rest)}),
        }

    def simulate(self, *, tell: Tell = lambda text: None) -> Simulation:
        """Run it.

        Parameters
        ----------
        tell : told what is being done, a line each
        """
        from varistiff.dynamics.dataset import run_dataset
        from varistiff.dynamics.metrics import metrics
        from varistiff.dynamics.simulate import simulate

        tell("simulation")
        try:
            run = simulate(self.case, duration=self.duration, step=self.step)
        except InputError as error:
            raise error.located(file=self.path) from None
        tell("results")
        unwanted = [name for name in ("position", "stiffness") if getattr(self.spec.reference, name, None) is None]
        data = run_dataset(run)
        for column in (f"wanted_{name}" for name in unwanted):
            data[column] = data[column].copy(data=data[column].values * float("nan"))
        data.attrs.update(self.attributes)
        return Simulation(name=self.name, scenario=self, run=run, data=data, metrics=_judging(metrics(run), unwanted))


@dataclass(frozen=True)
class Simulation:
    """What came of a scenario; partial where it is no result.

    Parameters
    ----------
    name : of the scenario
    scenario : what was run
    run : numbers at each sample, energy balance, outcome and events
    data : everything over time, labelled, in SI units
    metrics : numbers that judge it, by name
    """

    name: str
    scenario: Scenario = field(repr=False)
    run: Run = field(repr=False)
    data: xr.Dataset = field(repr=False)
    metrics: Mapping[str, Metric] = field(repr=False)

    @property
    def design(self) -> Design:
        """What moved."""
        return self.scenario.design

    @property
    def outcome(self) -> Outcome:
        """Whether it is a result, and if not, why."""
        return self.run.outcome

    @property
    def failed_at(self) -> float | None:
        """When it stopped being a result [s]; None for a result."""
        return self.run.failed_at

    @property
    def events(self) -> tuple[Event, ...]:
        """What happened on the way, in order."""
        return self.run.events

    @property
    def audit(self) -> Audit:
        """The energy balance."""
        return self.run.audit

    def __repr__(self) -> str:
        residual = f"energy residual {self.audit.relative:.2e}"
        return f"<Simulation {self.name!r}: {self.outcome.value}, {len(self.run.time)} samples, {residual}>"


def load_scenario(path: str | os.PathLike[str], *, materials: str | os.PathLike[str] | None = None) -> Scenario:
    """Return the scenario of a file, with its design read and every part built.

    Parameters
    ----------
    path : scenario file, YAML with units in words
    materials : file with your own materials, in place of the design's ``materials_file``

    Raises
    ------
    InputError : one line with file, field, what is wrong and what is allowed
    """
    if not isinstance(path, str | os.PathLike):
        raise InputError(f"load_scenario takes the path of a scenario file, not a {type(path).__name__}")
    spec, text, document = read_scenario(path)
    file, directory = printable_path(os.fspath(path)), Path(path).parent
    design = _design(spec, document, path, materials)
    from varistiff.design.build_scenario import build_case
    from varistiff.design.scenario_hash import scenario_hash

    try:
        case = build_case(spec, design, directory)
    except InputError as error:
        raise error.located(file=file) from None
    hashed = scenario_hash(spec, design_hash=design.hash, directory=directory)
    return Scenario(name=spec.name, path=file, text=text, spec=spec, design=design, case=case, hash=hashed)


def _design(
    spec: ScenarioSpec,
    document: Mapping[str, Any],
    path: str | os.PathLike[str],
    materials: str | os.PathLike[str] | None,
) -> Design:
    if isinstance(spec.design, str):
        return load(Path(path).parent / spec.design, materials=materials)
    import yaml

    text = yaml.safe_dump(document["design"], sort_keys=False, allow_unicode=True)
    own = printable_path(os.fspath(path))
    try:
        design = design_of(spec.design, text=text, path=path, materials=materials)
        _ = design.actuator  # its errors are about this file too
        return design
    except InputError as error:
        if error.file != own or error.field is None:
            raise
        raise InputError(error.problem, file=own, field=f"design.{error.field}") from None


def _judging(found: Mapping[str, Metric], unwanted: Sequence[str]) -> dict[str, Metric]:
    """Metrics without those that compare with a wish that nobody had."""
    prefixes = tuple(f"{name}_" for name in unwanted)
    left_out = ("bandwidth",) if "position" in unwanted else ()
    return {name: value for name, value in found.items() if not name.startswith(prefixes) and name not in left_out}
