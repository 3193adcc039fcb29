"""The points file: every wrong cell is named by its row."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from varistiff.cli.points import read_points
from varistiff.core.errors import InputError


def table(
    tmp_path: Path, text: str | bytes, *, has_setting: bool = True
) -> tuple[list[float], list[float], tuple[str, ...]]:
    path = tmp_path / "points.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    read = read_points(path, has_setting=has_setting)
    return list(read.deflection), list(read.setting), read.ignored


@pytest.mark.parametrize(
    "text",
    [
        "deflection,setting\n0.1,0.2\n-3e-1,.5\n",
        "setting, deflection\n0.2, 0.1\n.5 , -3e-1\n",
        "\ufeffdeflection,setting\r\n0.1,0.2\r\n-3e-1,.5",
        'deflection,setting\n"0.1","0.2"\n\n-0.3,+0.5\n\n',
    ],
)
def test_points_keep_their_order(tmp_path: Path, text: str) -> None:
    assert table(tmp_path, text) == ([0.1, -0.3], [0.2, 0.5], ())


def test_other_columns_are_named_and_not_used(tmp_path: Path) -> None:
    assert table(tmp_path, "time,deflection,note,setting\n0,1,hello,2\n") == ([1.0], [2.0], ("time", "note"))


def test_a_header_alone_holds_no_points(tmp_path: Path) -> None:
    assert table(tmp_path, "deflection,setting\n") == ([], [], ())


def test_a_kind_without_a_setting_may_leave_it_out(tmp_path: Path) -> None:
    deflection, setting, _ = table(tmp_path, "deflection\n0.1\n0.2\n", has_setting=False)
    assert deflection == [0.1, 0.2]
    assert all(math.isnan(value) for value in setting)
    deflection, setting, _ = table(tmp_path, "deflection,setting\n0.1,\n0.2,nan\n0.3,7\n", has_setting=False)
    assert deflection == [0.1, 0.2, 0.3]
    assert setting[2] == 7.0


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "is empty"),
        (b"\x00\x01\x02", "binary"),
        ("deflection\n0.1\n", "header: the column setting is missing"),
        ("deflektion,setting\n0.1,0.2\n", 'the column deflection is missing (is "deflektion" meant?)'),
        ("0.1,0.2\n", "the column deflection is missing"),
        ("deflection;setting\n0.1;0.2\n", "not separated by commas"),
        ("deflection,setting,setting\n1,2,3\n", "the column setting is there 2 times"),
        ("deflection,setting\n0.1,0.2\n0.1,two\n", 'row 2 (line 3), column setting: "two" is not a number'),
        ("deflection,setting\n0.1,10 mm\n", 'row 1 (line 2), column setting: "10 mm" is not a number'),
        ("deflection,setting\n\n0.1,\n", "row 1 (line 3), column setting: is blank"),
        ("deflection,setting\nnan,0.2\n", 'row 1 (line 2), column deflection: "nan" is not finite'),
        ("deflection,setting\n0.1,-inf\n", "is not finite"),
        ("deflection,setting\n0.1,1e999\n", "is too large"),
        ("deflection,setting\n0.1,1_0\n", "is not a number"),
        ("deflection,setting\n0.1,0x10\n", "is not a number"),
        ("deflection,setting\n0.1,٣\n", "is not a number"),
        ("deflection,setting\n0.1\n", "row 1 (line 2): has 1 cell; allowed are 2"),
        ("deflection,setting\n0,1,2\n", "row 1 (line 2): has 3 cells; allowed are 2"),
        ('deflection,setting\n"0.1,2\n', "is not CSV"),
        ("deflection,setting\n" + "1" * 200_000 + ",2\n", "is not CSV"),
    ],
)
def test_a_wrong_file_is_one_line(tmp_path: Path, text: str | bytes, said: str) -> None:
    with pytest.raises(InputError) as caught:
        table(tmp_path, text)
    assert str(caught.value).startswith(f"{tmp_path / 'points.csv'}: ")
    assert said in str(caught.value)
    assert str(caught.value).isprintable()


def test_a_file_of_100_megabytes_is_refused_at_once(tmp_path: Path) -> None:
    path = tmp_path / "points.csv"
    with path.open("wb") as stream:
        stream.truncate(100_000_000)
    with pytest.raises(InputError, match="is too large"):
        read_points(path, has_setting=True)
