"""What ``varistiff simulate`` does and prints."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from varistiff.core.writing import check_directory

if TYPE_CHECKING:
    from varistiff.design.scenario import Scenario, Simulation
    from varistiff.dynamics.outcome import Metric

DONE, FAILED, WRONG_INPUT = 0, 1, 2


def report_simulation(scenario: Scenario, directory: str) -> int:
    """Run a scenario, write its results and print its outcome, energy balance, metrics and events.

    Returns
    -------
    Exit status: 0 for a result; 2 where the scenario itself led nowhere; 1 where the energy balance stays open with a
    step that varistiff chose.

    Raises
    ------
    InputError : the output cannot be written, or the run is refused
    """
    from varistiff.report.simulation.write import check_output, write_simulation

    check_output(directory)
    check_directory(directory)
    tell = _tell if sys.stderr.isatty() else _say_nothing
    simulation = scenario.simulate(tell=tell)
    write_simulation(simulation, directory, tell=tell)
    for line in summary(simulation):
        print(line)
    print(f"Results are in {directory}")
    status = exit_status(simulation)
    if status != DONE:
        print(f"varistiff: {failure(simulation)}", file=sys.stderr)
    return status


def exit_status(simulation: Simulation) -> int:
    """Exit status that an outcome deserves."""
    from varistiff.dynamics.outcome import Outcome

    if simulation.outcome is Outcome.DONE:
        return DONE
    chosen = simulation.scenario.step is None
    return FAILED if simulation.outcome is Outcome.AUDIT_OPEN and chosen else WRONG_INPUT


def failure(simulation: Simulation) -> str:
    """One line that says what went wrong, when, and what to do."""
    outcome, scenario = simulation.outcome, simulation.scenario
    instant = "" if simulation.failed_at is None else f" at {simulation.failed_at:.6g} s"
    remedy = outcome.remedy
    if scenario.step is None and "`step`" in remedy:  # there is no step to leave out
        remedy = "Please report it to the project, with the scenario file."
    return f"{scenario.path}: {outcome.value}{instant}: {outcome.meaning} {remedy}"


def summary(simulation: Simulation) -> Iterator[str]:
    """Outcome, energy balance, metrics and events, line by line."""
    audit, scenario, run = simulation.audit, simulation.scenario, simulation.run
    yield f"{simulation.name} ({scenario.design.name}, {scenario.design.kind})"
    end = float(run.time[-1])
    yield f"outcome: {simulation.outcome.value}. {simulation.outcome.meaning}"
    yield f"computed: {end:.6g} s of {scenario.duration:.6g} s, {len(run.time)} samples, step {1e3 * run.step:.6g} ms"
    verdict = "closes" if audit.closes else "does not close"
    yield (
        f"energy: residual {audit.relative:.3g} of {float(audit.turnover[-1]):.4g} J turned over, "
        f"allowed {audit.allowance:.0e}: the balance {verdict}"
    )
    yield from _metric_lines(list(simulation.metrics.values()))
    if simulation.events:
        yield "events:"
    for event in simulation.events:
        yield f"  {event.time:9.4f} s  {event.text}"


def _metric_lines(metrics: Sequence[Metric]) -> Iterator[str]:
    from varistiff.report.display import display

    if not metrics:
        return
    rows = [
        (metric.long_name, display(metric.unit, metric.value or 0.0).text(metric.value), metric.note)
        for metric in metrics
    ]
    widths = [max(len(row[column]) for row in rows) for column in range(2)]
    yield "metrics:"
    for name, value, note in rows:
        yield f"  {name.ljust(widths[0])}  {value.rjust(widths[1])}  {note}".rstrip()


def _tell(what: str) -> None:
    print(f"varistiff: {what}", file=sys.stderr, flush=True)


def _say_nothing(what: str) -> None:
    del what
