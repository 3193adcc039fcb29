"""The commands. Everything slow is imported inside them: ``varistiff --help`` answers at once."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from varistiff.cli.reproduction import Format
from varistiff.core.errors import InputError

app = typer.Typer(
    name="varistiff",
    help="Variable stiffness actuators: from a design file to torque, stiffness, energy and a report.",
    epilog="Exit status: 0 done, 2 the input is wrong, 1 varistiff itself failed.",
    no_args_is_help=False,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)

DesignFile = Annotated[str, typer.Argument(metavar="DESIGN", help="Design file (YAML).", show_default=False)]
MaterialsFile = Annotated[
    str | None,
    typer.Option("--materials", metavar="FILE", help="Your own materials, in place of the design's materials_file."),
]


def _version(wanted: bool) -> None:
    if wanted:
        import varistiff

        print(f"varistiff {varistiff.__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None:
    pass


@app.command()
def analyse(
    design: DesignFile,
    output: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="DIR", help="Directory for the results. [default: DESIGN_analysis]"),
    ] = None,
    materials: MaterialsFile = None,
) -> None:
    """Make map, datasheet, pictures, report and data of a design."""
    from varistiff.core.writing import check_directory
    from varistiff.design.design import load

    loaded = load(design, materials=materials)
    directory = output if output is not None else f"{Path(design).stem}_analysis"
    check_directory(directory)
    from varistiff.report.analyse import analyse as run

    analysis = run(loaded, directory, progress=sys.stderr.isatty())
    for line in analysis.summary:
        print(line)
    print(f"Results are in {directory}")


@app.command()
def evaluate(
    design: DesignFile,
    points: Annotated[
        str,
        typer.Argument(metavar="POINTS", help="CSV file with the columns deflection,setting.", show_default=False),
    ],
    output: Annotated[
        str,
        typer.Option("--output", "-o", metavar="OUT", help="CSV file for the results.", show_default=False),
    ],
    materials: MaterialsFile = None,
) -> None:
    """Compute energy, load, stiffness and stress at points.

    POINTS has the columns deflection and setting in SI units (rad or m); OUT gets one row per point.
    """
    from varistiff.cli.log import say_statuses, warn
    from varistiff.cli.points import read_points
    from varistiff.cli.table import write_results
    from varistiff.core.writing import staged_file
    from varistiff.design.design import load

    loaded = load(design, materials=materials)
    table = read_points(points, has_setting=loaded.setting_unit is not None)
    _refuse_overwriting(output, {"the design": design, "the points": points})
    warn(loaded)
    if table.ignored:
        print(f"varistiff: {points}: columns not used: {', '.join(table.ignored)}", file=sys.stderr)
    with staged_file(output) as stream:
        statuses = write_results(stream, loaded, table)
    say_statuses(loaded, statuses)


@app.command()
def verify(
    design: DesignFile,
    setting: Annotated[
        list[str] | None,
        typer.Option(
            "--setting", metavar="VALUE", help="Setting with its unit; may be repeated. [default: 7 even ones]"
        ),
    ] = None,
    deflection: Annotated[
        list[str] | None,
        typer.Option(
            "--deflection", metavar="VALUE", help="Of a device with leaves; may be repeated. [default: the largest ok]"
        ),
    ] = None,
    measured: Annotated[
        str | None,
        typer.Option("--measured", metavar="FILE", help="CSV of a measurement: setting and stiffness (or load), SI."),
    ] = None,
    tolerance: Annotated[
        float, typer.Option("--tolerance", metavar="SHARE", help="Largest change in the last refinement.")
    ] = 0.005,
    output: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="DIR", help="Directory for the results. [default: DESIGN_verification]"),
    ] = None,
    step: Annotated[
        str | None,
        typer.Option("--step", metavar="FILE", help="Write the elastic element as STEP, and compute nothing."),
    ] = None,
    materials: MaterialsFile = None,
) -> None:
    """Check a design in three dimensions; needs the extra fe."""
    from varistiff.cli.verification import report_verification, write_element
    from varistiff.design.design import load

    loaded = load(design, materials=materials)
    if step is not None:
        _refuse_overwriting(step, {"the design": design}, option="--step")
        write_element(loaded, step)
        return
    directory = output if output is not None else f"{Path(design).stem}_verification"
    report_verification(
        loaded,
        directory,
        settings=setting or [],
        deflections=deflection or [],
        measured=measured,
        tolerance=tolerance,
    )
    print(f"Results are in {directory}")


@app.command()
def simulate(
    scenario: Annotated[str, typer.Argument(metavar="SCENARIO", help="Scenario file (YAML).", show_default=False)],
    output: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="DIR", help="Directory for the results. [default: SCENARIO_simulation]"),
    ] = None,
    materials: MaterialsFile = None,
) -> None:
    """Set a design in motion: control, drives, energy, and a report."""
    from varistiff.cli.log import warn
    from varistiff.cli.simulation import report_simulation
    from varistiff.design.scenario import load_scenario

    loaded = load_scenario(scenario, materials=materials)
    warn(loaded.design)
    directory = output if output is not None else f"{Path(scenario).stem}_simulation"
    status = report_simulation(loaded, directory)
    if status:
        raise typer.Exit(status)


@app.command()
def reproduce(
    paper: Annotated[
        str | None, typer.Argument(metavar="[PAPER]", help="Key of one paper. [default: all]", show_default=False)
    ] = None,
    shape: Annotated[
        Format, typer.Option("--format", "-f", help="What standard output gets.", case_sensitive=False)
    ] = Format.TABLE,
    output: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="DIR", help="Directory for page, data, figures and designs."),
    ] = None,
) -> None:
    """Hold every number that the papers print against ours."""
    from varistiff.cli.reproduction import report_board

    status = report_board(paper, shape=shape, directory=output)
    if status:
        raise typer.Exit(status)


@app.command()
def validate(
    files: Annotated[
        list[str], typer.Argument(metavar="FILE...", help="Design and scenario files.", show_default=False)
    ],
    materials: MaterialsFile = None,
) -> None:
    """Check design and scenario files, and build what they state."""
    from varistiff.cli.log import warn
    from varistiff.cli.validation import checked

    wrong = 0
    for path in files:
        try:
            design, line = checked(path, materials)
        except InputError as error:
            wrong += 1
            print(f"varistiff: {error}", file=sys.stderr)
            continue
        warn(design)
        print(line)
    if wrong:
        raise typer.Exit(2)


@app.command()
def schema(
    scenario: Annotated[bool, typer.Option("--scenario", help="Of scenario files, in place of design files.")] = False,
) -> None:
    """Print the JSON schema of design or scenario files, for editors."""
    import json

    if scenario:
        from varistiff.design.scenario_spec import scenario_json_schema as written
    else:
        from varistiff.design.spec import json_schema as written
    print(json.dumps(written(), indent=2))


@app.command("materials")
def list_materials(
    materials: MaterialsFile = None,
    sources: Annotated[bool, typer.Option("--sources", help="Print the source of every value too.")] = False,
) -> None:
    """List the materials that a design can name."""
    from varistiff.cli.table import material_lines
    from varistiff.materials import builtin_materials, read_materials

    own = read_materials(materials) if materials is not None else {}
    for line in material_lines([*({**builtin_materials(), **own}).values()], sources=sources):
        print(line)


def _refuse_overwriting(output: str, inputs: dict[str, str], *, option: str = "--output") -> None:
    for name, path in inputs.items():
        try:
            same = Path(output).samefile(path)
        except (OSError, ValueError):  # the output does not exist yet, or never can: writing it says so
            same = False
        if same:
            raise InputError(f"is {name} itself; choose another {option}", file=output)
