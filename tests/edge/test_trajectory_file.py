"""Trajectories from CSV and OpenSim files: what is read, and one line for each file that is not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.core.errors import InputError
from varistiff.core.quantity import ANGLE, LENGTH, TORQUE
from varistiff.design.trajectory_file import (
    ROWS_LIMIT,
    TORQUE_PER_MASS,
    Trajectory,
    TrajectoryColumn,
    read_trajectory,
)

FLEXION = TrajectoryColumn("knee_angle", ANGLE, 1)
MOMENT = TrajectoryColumn("knee_moment", TORQUE, -1)
CSV = "time [s],knee_angle [deg],knee_moment [N*m]\n0,0,1\n0.5,90,-2\n1.5,-45,3e1\n"
OPENSIM = (
    "inverse kinematics\nversion=1\nnRows=3\nnColumns=4\ninDegrees={degrees}\n\nUnits are S.I. units\nendheader\n"
    "time\tpelvis_tx\tknee_angle\tknee_moment\n0.0\t1.0\t90.0\t-2\n 0.5\t1.1\t 45.0\t3\n1.0\t1.2\t-9e1\t4\t\n"
)


def write(folder: Path, text: str | bytes, name: str) -> Path:
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def read(
    folder: Path, text: str | bytes, *columns: TrajectoryColumn, name: str = "knee.csv", time_unit: str | None = None
) -> Trajectory:
    return read_trajectory(write(folder, text, name), columns, time_unit=time_unit)


def said_of(path: Path, columns: Sequence[TrajectoryColumn] = (FLEXION,), time_unit: str | None = None) -> str:
    with pytest.raises(InputError) as caught:
        read_trajectory(path, columns, time_unit=time_unit)
    line = str(caught.value)
    assert line.isprintable()
    assert len(line.replace(str(path), "")) < 400
    return line


# --- CSV


@pytest.mark.parametrize(
    "text",
    [
        CSV,
        "\ufeff" + CSV.replace("\n", "\r\n"),
        CSV.replace(",", " , ") + "\n\n",
        "knee_moment [N*m],note,time [ms],knee_angle [rad]\n1,hello,0,0\n-2,,5e2,1.5707963267948966\n"
        "30,nan,1500,-0.7853981633974483\n",
        '"time [s]","knee_angle [°]","knee_moment [Nmm]"\n0,0,1000\n.5,90,-2000\n1.5,-45,30000\n',
        "time[min],knee_angle[turn],knee_moment[J/rad]\n0,0,1\n0.0083333333333333333,0.25,-2\n0.025,-0.125,30\n",
    ],
)
def test_columns_become_si_with_the_declared_signs(tmp_path: Path, text: str) -> None:
    found = read(tmp_path, text, FLEXION, MOMENT)
    assert list(found.times) == pytest.approx([0.0, 0.5, 1.5], rel=1e-15)
    assert list(found.values["knee_angle"]) == pytest.approx([0.0, math.pi / 2, -math.pi / 4], rel=1e-15)
    assert list(found.values["knee_moment"]) == pytest.approx([-1.0, 2.0, -30.0], rel=1e-15)
    assert found.ignored == (("note",) if "note" in text else ())


def test_units_may_be_declared_beside_the_file(tmp_path: Path) -> None:
    text = "time,knee_angle,knee_moment [N*m/kg]\n0,10,0.6\n1,20,-0.2\n"
    angle = TrajectoryColumn("knee_angle", ANGLE, -1, "deg")
    moment = TrajectoryColumn("knee_moment", TORQUE_PER_MASS, 1, "Nm/kg")  # the same unit twice is no contradiction
    found = read(tmp_path, text, angle, moment, time_unit="ms")
    assert list(found.times) == [0.0, 1e-3]
    assert list(found.values["knee_angle"]) == pytest.approx([math.radians(-10.0), math.radians(-20.0)])
    assert list(found.values["knee_moment"]) == [0.6, -0.2]


def test_zero_has_no_sign(tmp_path: Path) -> None:
    values = read(tmp_path, CSV, TrajectoryColumn("knee_angle", ANGLE, -1)).values["knee_angle"]
    assert math.copysign(1.0, values[0]) == 1.0


@given(rows=st.lists(st.tuples(st.floats(0.001, 10.0), st.floats(-1e6, 1e6)), min_size=2, max_size=20))
def test_what_was_written_is_read(tmp_path_factory: pytest.TempPathFactory, rows: list[tuple[float, float]]) -> None:
    times = [sum(step for step, _ in rows[: number + 1]) for number in range(len(rows))]
    lines = [f"{time!r},{value!r}" for time, (_, value) in zip(times, rows, strict=True)]
    text = "\n".join(["time [s],knee_angle [rad]", *lines])
    found = read(tmp_path_factory.mktemp("written"), text, FLEXION)
    assert list(found.times) == times
    assert list(found.values["knee_angle"]) == [value for _, value in rows]


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "is empty"),
        (b"\x00\x01\x02", "binary"),
        (b"time [s],knee_angle [deg]\n0,\xff\n", "is not UTF-8 text (line 2)"),
        ("time [s],knee_angle [deg]\n", "has 0 rows of numbers; allowed are at least 2"),
        ("time [s],knee_angle [deg]\n0,1\n", "has 1 rows of numbers"),
        ("0,1\n1,2\n", "header: is missing; allowed is a first line such as time [s],knee_angle [deg]"),
        ("time [s];knee_angle [deg]\n0;1\n", "header: the columns are not separated by commas"),
        ("t [s],knee_angle [deg]\n0,1\n", "header: the column time is missing"),
        ("time [s],knee_angel [deg]\n0,1\n", 'the column knee_angle is missing (is "knee_angel" meant?); the file has'),
        ("time [s],knee_angle [deg],knee_angle [deg]\n0,1,2\n", "header: the column knee_angle is there 2 times"),
        ("time [s],knee_angle [deg\n0,1\n", 'header: cannot read "knee_angle [deg"; allowed is name or name [unit]'),
        ("time [s],knee_angle [deg] left\n0,1\n", "header: cannot read"),
        ("time [s]," + " " * 100_000 + "]\n0,1\n", "header: cannot read"),
        (
            "time [s],knee_angle\n0,1\n1,2\n",
            "column knee_angle: has no unit; allowed is knee_angle [...] in the header",
        ),
        ("time,knee_angle [deg]\n0,1\n1,2\n", "column time: has no unit"),
        ("time [s],knee_angle []\n0,1\n1,2\n", "column knee_angle: "),
        ("time [s],knee_angle [degre]\n0,1\n", 'column knee_angle: unknown unit "degre" (did you mean "degree"?)'),
        ("time [s],knee_angle [mm]\n0,1\n1,2\n", 'column knee_angle: "1 mm" is a length; allowed is an angle'),
        ("time [Hz],knee_angle [deg]\n0,1\n1,2\n", 'column time: "1 Hz" is a frequency; allowed is a time'),
        ("time [s],knee_angle [deg]\n0,1\n1\n", "row 2 (line 3): has 1 cell; allowed are 2, as in the header"),
        ("time [s],knee_angle [deg]\n0,1,5\n", "row 1 (line 2): has 3 cells"),
        ("time [s],knee_angle [deg]\n0,1\n\n1,two\n", 'row 2 (line 4), column knee_angle: "two" is not a number'),
        ("time [s],knee_angle [deg]\n0,1\n1,nan\n", 'row 2 (line 3), column knee_angle: "nan" is not finite'),
        ("time [s],knee_angle [deg]\n0,1\n1,-inf\n", "is not finite"),
        ("time [s],knee_angle [deg]\n0,1\n1,\n", "row 2 (line 3), column knee_angle: is blank"),
        ("time [s],knee_angle [deg]\n0,1\n1,1e999\n", "is too large"),
        ("time [s],knee_angle [turn]\n0,1\n1,1e308\n", '"1e308" is too large; allowed is a finite number in SI units'),
        ("time [s],knee_angle [deg]\n0,1\n0,2\n", 'row 2 (line 3), column time: "0" is not later than the row before'),
        ("time [s],knee_angle [deg]\n0,1\n1,2\n0.9,2\n", "row 3 (line 4), column time: "),
        ("time [s],knee_angle [deg]\n0,1\nnan,2\n", "row 2 (line 3), column time: "),
        ('time [s],knee_angle [deg]\n"0,1\n', "is not CSV"),
        ("time [s],knee_angle [deg]\n" + "1" * 200_000 + ",2\n", "is not CSV"),
    ],
)
def test_a_wrong_csv_file_is_one_line(tmp_path: Path, text: str | bytes, said: str) -> None:
    path = write(tmp_path, text, "knee.csv")
    line = said_of(path)
    assert line.startswith(f"{path}: ")
    assert said in line


def test_a_declared_unit_must_be_the_one_in_the_file(tmp_path: Path) -> None:
    path = write(tmp_path, CSV, "knee.csv")
    line = said_of(path, [TrajectoryColumn("knee_angle", ANGLE, 1, "rad")])
    assert line.endswith('column knee_angle: is declared in "rad", but the file states "deg"')
    assert said_of(path, time_unit="ms").endswith('column time: is declared in "ms", but the file states "s"')


def test_a_moment_per_mass_is_no_moment(tmp_path: Path) -> None:
    text = CSV.replace("[N*m]", "[N*m/kg]")
    line = said_of(write(tmp_path, text, "knee.csv"), [MOMENT])
    assert "column knee_moment: " in line
    assert "allowed is a torque, for example 1.5 N*m" in line
    line = said_of(write(tmp_path, CSV, "knee.csv"), [TrajectoryColumn("knee_moment", TORQUE_PER_MASS, 1)])
    assert "is a torque; allowed is a torque per body mass, for example 0.6 N*m/kg" in line


@pytest.mark.parametrize("sign", [0, 2, -1.5, True])
def test_a_sign_is_plus_or_minus_one(tmp_path: Path, sign: int) -> None:
    path = write(tmp_path, CSV, "knee.csv")
    if sign is True:  # Python's True is 1
        assert read_trajectory(path, [TrajectoryColumn("knee_angle", ANGLE, sign)]).values["knee_angle"][1] > 0.0
        return
    with pytest.raises(InputError, match=r"^sign: is .*; allowed is \+1 or -1"):
        read_trajectory(path, [TrajectoryColumn("knee_angle", ANGLE, sign)])


# --- OpenSim


@pytest.mark.parametrize("name", ["walk.sto", "walk.MOT"])
@pytest.mark.parametrize("degrees, factor", [("yes", math.pi / 180.0), ("no", 1.0)])
def test_opensim_states_the_unit_of_angles(tmp_path: Path, name: str, degrees: str, factor: float) -> None:
    text = OPENSIM.format(degrees=degrees)
    height = TrajectoryColumn("pelvis_tx", LENGTH, 1)
    found = read(tmp_path, text, FLEXION, MOMENT, height, name=name)
    assert list(found.times) == [0.0, 0.5, 1.0]
    assert list(found.values["knee_angle"]) == pytest.approx([90.0 * factor, 45.0 * factor, -90.0 * factor])
    assert list(found.values["knee_moment"]) == [2.0, -3.0, -4.0]
    assert list(found.values["pelvis_tx"]) == [1.0, 1.1, 1.2]
    assert found.ignored == ()


def test_a_motion_file_of_the_older_form_is_read(tmp_path: Path) -> None:
    text = "name walk.mot\ndatacolumns 2\ndatarows 2\nrange 0 1\nendheader\ntime knee_angle\n0 10\n1 20\n"
    degrees = TrajectoryColumn("knee_angle", ANGLE, 1, "deg")
    found = read(tmp_path, text, degrees, name="walk.mot")
    assert list(found.values["knee_angle"]) == pytest.approx([math.radians(10.0), math.radians(20.0)])
    line = said_of(tmp_path / "walk.mot")
    assert "column knee_angle: has no unit; allowed is inDegrees=yes or no in the header, or a declared unit" in line


def test_a_declared_unit_goes_before_opensims_own(tmp_path: Path) -> None:
    per_mass = TrajectoryColumn("knee_moment", TORQUE_PER_MASS, 1, "N*m/kg")
    found = read(tmp_path, OPENSIM.format(degrees="yes"), per_mass, name="walk.sto")
    assert list(found.values["knee_moment"]) == [-2.0, 3.0, 4.0]
    line = said_of(tmp_path / "walk.sto", [TrajectoryColumn("knee_moment", TORQUE_PER_MASS, 1)])
    assert "column knee_moment: has no unit" in line


@pytest.mark.parametrize(
    "change, said",
    [
        (("endheader\n", ""), "header: has no endheader in its first 200 lines"),
        (("endheader\n", "\n" * 300 + "endheader\n"), "header: has no endheader in its first 200 lines"),
        (("nRows=3", "nRows=4"), "nRows: declares 4 rows and has 3"),
        (("nRows=3", "nRows=three"), 'nrows: is "three"; allowed is a whole number'),
        (("nColumns=4", "nColumns=5"), "nColumns: declares 5 columns and has 4"),
        (("inDegrees=yes", "inDegrees=maybe"), 'inDegrees: is "maybe"; allowed is yes or no'),
        (("\t3\n", "\n"), "row 2 (line 11): has 3 cells; allowed are 4"),
        (("45.0", "NaN"), 'row 2 (line 11), column knee_angle: "NaN" is not finite'),
        (("45.0", "1.#QNAN"), 'row 2 (line 11), column knee_angle: "1.#QNAN" is not a number'),
        ((" 0.5\t", "-0.5\t"), 'row 2 (line 11), column time: "-0.5" is not later than the row before'),
        (("time\t", "t\t"), "header: the column time is missing"),
        (("\tknee_angle", "\tknee_angle_r"), '(is "knee_angle_r" meant?)'),
        (("\tpelvis_tx", "\tknee_angle"), "header: the column knee_angle is there 2 times"),
    ],
)
def test_a_wrong_opensim_file_is_one_line(tmp_path: Path, change: tuple[str, str], said: str) -> None:
    text = OPENSIM.format(degrees="yes")
    assert change[0] in text
    path = write(tmp_path, text.replace(change[0], change[1], 1), "walk.sto")
    line = said_of(path)
    assert line.startswith(f"{path}: ")
    assert said in line


def test_degrees_against_a_declaration(tmp_path: Path) -> None:
    path = write(tmp_path, OPENSIM.format(degrees="yes"), "walk.sto")
    line = said_of(path, [TrajectoryColumn("knee_angle", ANGLE, 1, "rad")])
    assert 'column knee_angle: is declared in "rad", but the file states "deg"' in line


# --- any file


def test_other_files_are_refused(tmp_path: Path) -> None:
    assert 'ends in ".xlsx"; allowed are files that end in .csv, .sto or .mot' in said_of(tmp_path / "knee.xlsx")
    for name in ("none.csv", "none.sto"):
        assert "cannot be read: no such file" in said_of(tmp_path / name)
    (tmp_path / "folder.csv").mkdir()
    assert "is a directory" in said_of(tmp_path / "folder.csv")


def test_a_file_of_100_megabytes_is_refused_at_once(tmp_path: Path) -> None:
    path = tmp_path / "knee.csv"
    with path.open("wb") as stream:
        stream.truncate(100_000_000)
    assert "is too large (100.0 MB); allowed are 20 MB" in said_of(path)


def test_too_many_rows_are_refused(tmp_path: Path) -> None:
    rows = "".join(f"{row},1\n" for row in range(ROWS_LIMIT + 1))
    line = said_of(write(tmp_path, "time [s],knee_angle [deg]\n" + rows, "knee.csv"))
    assert f"row {ROWS_LIMIT + 1} (line {ROWS_LIMIT + 2}): has more than {ROWS_LIMIT} rows" in line
