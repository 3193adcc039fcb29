"""Files from users: size, encoding, and YAML without tags, aliases and surprises."""

from __future__ import annotations

import math
import os
import time
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.core.errors import InputError
from varistiff.core.textfile import parse_yaml, read_text, read_yaml_documents

BOMB = "a: &a [x, x]\n" + "".join(f"{b}: &{b} [*{a}, *{a}]\n" for a, b in zip("abcdefgh", "bcdefghi", strict=True))


def one(text: str) -> Any:
    (document,) = parse_yaml(text)
    return document


@pytest.mark.parametrize(
    "scalar, value",
    [
        ("on", "on"),
        ("no", "no"),
        ("Yes", "Yes"),
        ("true", True),
        ("1:30", "1:30"),
        ("2024-01-01", "2024-01-01"),
        ("012", 12),
        ("0x1F", "0x1F"),
        ("1e3", 1000.0),
        (".5", 0.5),
        ("~", None),
        ("'1'", "1"),
        ("1_000", "1_000"),
        ("3.16 mm", "3.16 mm"),
        ("=", "="),
        ("<<", "<<"),
    ],
)
def test_plain_scalars_follow_the_core_schema(scalar: str, value: object) -> None:
    found = one(f"x: {scalar}")["x"]
    assert found == value
    assert type(found) is type(value)


def test_not_a_number_is_seen() -> None:
    found = one("x: .nan")["x"]
    assert math.isnan(found)


@pytest.mark.parametrize(
    "text, said",
    [
        ("x: &a 1", "anchors"),
        ("x: *a", "aliases"),
        ("x: !!python/object/apply:os.system [ls]", "tags"),
        ("x: !!str 1", "tags"),
        ("x: !mine 1", "tags"),
        ("! x: 1", "tags"),
        ("x: 1\nx: 2", "given twice"),
        ("? {a: b}\n: c", "must be text"),
        ("x: [1", "not YAML"),
        ("x: 1\n\ty: 2", "not YAML"),
        ("x: \x01", "no text file has"),
        ("x: " + "[" * 100_000, "nested deeper"),
        ("x: " + "{a: " * 100_000, "nested deeper"),
        ("- " * 50_000, "nested deeper"),
        (BOMB, "anchors"),
        ("%YAML 9.9\n---\nx: 1", "not YAML"),
    ],
)
def test_dangerous_or_broken_yaml_is_one_line(text: str, said: str) -> None:
    start = time.perf_counter()
    with pytest.raises(InputError) as caught:
        list(parse_yaml(text))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert time.perf_counter() - start < 2.0


def test_a_text_of_one_megabyte_is_parsed_in_seconds() -> None:
    start = time.perf_counter()
    assert len(one("\n".join(f"field_{number}: {number} mm" for number in range(40_000)))) == 40_000
    assert time.perf_counter() - start < 20.0  # a second or two with the C parser; linear either way


@given(st.text(max_size=200))
def test_any_text_is_data_or_one_line(text: str) -> None:
    line = ""
    try:
        list(parse_yaml(text))
    except InputError as error:
        line = str(error)
    assert line.isprintable()


@pytest.mark.parametrize(
    "data, said",
    [
        (b"", "is empty"),
        (b" \n\n", "is empty"),
        (b"\x7fELF\x00\x01", "binary"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "binary"),
        ("name: ü".encode("latin-1"), "not UTF-8 text (line 1)"),
        ("a: 1\nname: x".encode("utf-16"), "not UTF-8"),
    ],
)
def test_files_that_are_no_text(tmp_path: Path, data: bytes, said: str) -> None:
    path = tmp_path / "design.yaml"
    path.write_bytes(data)
    with pytest.raises(InputError, match=r"design\.yaml: ") as caught:
        read_text(path, limit=1000)
    assert said in str(caught.value)


def test_comments_alone_are_an_empty_file(tmp_path: Path) -> None:
    path = tmp_path / "design.yaml"
    path.write_text("# nothing\n---\n# here\n")
    with pytest.raises(InputError, match="is empty"):
        read_yaml_documents(path)


def test_a_byte_order_mark_is_no_part_of_the_text(tmp_path: Path) -> None:
    path = tmp_path / "design.yaml"
    path.write_bytes(b"\xef\xbb\xbfname: x\n")
    assert read_text(path, limit=1000) == "name: x\n"


def test_the_size_is_checked_before_reading(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "large.yaml"
    with path.open("wb") as stream:
        stream.truncate(100_000_000)

    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("the file was opened")

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(InputError, match=r"is too large \(100.0 MB\); allowed are 1 MB"):
        read_yaml_documents(path)


def test_missing_directory_pipe_and_device(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path, said in [
        (tmp_path / "missing.yaml", "cannot be read: no such file"),
        (tmp_path, "is a directory"),
        (pipe, "not a regular file"),
        (Path("/dev/zero"), "not a regular file"),
        ("nul\0l", "no path"),
    ]:
        with pytest.raises(InputError, match=said):
            read_text(path, limit=1000)
