"""A run as files: whole, self-contained, escaped, and honest about what is no result."""

from __future__ import annotations

import base64
import csv
import hashlib
import json
import re
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from markupsafe import escape

from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.dynamics.outcome import Event, Outcome
from varistiff.report.simulation import write
from varistiff.report.simulation.data_csv import as_csv
from varistiff.report.simulation.write import write_simulation

from .synthetic import Made

HOSTILE = '<script>alert(1)</script> & "quoted" {{ 7*7 }} </title><img src=x onerror=y>'


class _Page(HTMLParser):
    """Collects tags, what a browser would load, the text of scripts, and ids."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.loaded: list[str] = []
        self.ids: list[str] = []
        self.scripts: list[str] = []
        self.policy = ""
        self.inside = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        values = dict(attrs)
        self.inside = tag == "script"
        if "id" in values:
            self.ids.append(values["id"] or "")
        if values.get("http-equiv") == "Content-Security-Policy":
            self.policy = values["content"] or ""
        if tag != "a":
            self.loaded += [values[key] or "" for key in ("src", "href", "xlink:href", "srcset") if key in values]

    def handle_data(self, data: str) -> None:
        if self.inside:
            self.scripts.append(data)

    def handle_endtag(self, tag: str) -> None:
        self.inside = False


@pytest.fixture(autouse=True)
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """These tests are about files: a coarse map will do."""
    monkeypatch.setattr(write, "ACROSS", 31)
    monkeypatch.setattr(write, "ALONG", 9)


def _written(made: Made, folder: Path) -> tuple[str, _Page]:
    write_simulation(made, folder)
    text = (folder / "report.html").read_text(encoding="utf-8")
    page = _Page()
    page.feed(text)
    return text, page


def test_every_kind_makes_a_whole_report(run_of_kind: Made, tmp_path: Path) -> None:
    folder = tmp_path / "result"
    text, page = _written(run_of_kind, folder)
    files = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    svgs = {name.removesuffix(".svg") for name in files if name.endswith(".svg")}
    assert svgs == {name.removesuffix(".png") for name in files if name.endswith(".png")}
    assert files == {"data.nc", "data.csv", "simulation.json", "report.html"} | {
        f"{name}.{ending}" for name in svgs for ending in ("svg", "png")
    }
    assert {"figures/mechanism", "figures/tracking", "figures/residual"} <= svgs
    assert page.tags.count("svg") == len(svgs)
    assert all(reference.startswith(("#", "data:")) for reference in page.loaded)
    assert "link" not in page.tags
    assert "@import" not in text
    assert len(page.ids) == len(set(page.ids))
    assert len(text) < 6_000_000
    assert "The energy balance closes: its residual reaches" in text[: text.index("<nav")]
    assert "no result" not in text.lower()
    assert run_of_kind.design.hash in text


def test_only_the_player_may_run(made: Callable[[str], Made], tmp_path: Path) -> None:
    text, page = _written(made("maccepa"), tmp_path / "result")
    data, script = page.scripts
    assert "default-src 'none'" in page.policy
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}'" in page.policy  # else no browser runs it
    assert "'unsafe-inline'" not in page.policy[page.policy.index("script-src") :].split(";")[0]
    for name in re.findall(r'querySelector\("#([a-z]+)"\)|getElementById\("([a-z]+)"\)', script):
        assert "".join(name) in page.ids
    readouts = len(json.loads(data)["readouts"])
    assert [name for name in page.ids if name.startswith("readout-")] == [f"readout-{i}" for i in range(readouts)]
    assert "prefers-reduced-motion" in script
    assert not re.search(r"\b(fetch|XMLHttpRequest|import|eval|innerHTML)\b", script)
    assert re.search(r'<input type="range" id="scrub"[^>]* aria-label="Time">', text)
    assert re.search(r'<canvas role="img" aria-label="[^"]{40,}"', text)


def test_what_a_user_wrote_is_escaped(made: Callable[[str], Made], tmp_path: Path) -> None:
    run = made("series_elastic")
    events = (Event(0.1, HOSTILE, HOSTILE),)
    data = run.data.assign_attrs(scenario=HOSTILE)
    text, page = _written(replace(run, name=HOSTILE, events=events, data=data), tmp_path / "result")
    assert f"<h1>{escape(HOSTILE)}</h1>" in text
    assert page.tags.count("script") == 2
    assert "img" not in page.tags
    assert "49" not in text[: text.index("</h1>")].rsplit("<h1>", 1)[1]


@pytest.mark.parametrize("outcome", [each for each in Outcome if each is not Outcome.DONE])
def test_what_is_no_result_says_so_everywhere(outcome: Outcome, made: Callable[[str], Made], tmp_path: Path) -> None:
    run = replace(made("series_elastic"), outcome=outcome, failed_at=1.234)
    folder = tmp_path / "result"
    text, _ = _written(run, folder)
    name = outcome.value.replace("_", " ")
    head = text[: text.index("<nav")]
    assert f"This is no result: {name} at 1.234 s." in head
    assert str(escape(outcome.meaning)) in head
    assert str(escape(outcome.remedy)) in head
    with xr.open_dataset(folder / "data.nc", engine="h5netcdf") as stored:
        assert stored.attrs["outcome"] == outcome.value
        assert stored.attrs["failed_at"] == 1.234
    told = json.loads((folder / "simulation.json").read_text(encoding="utf-8"))
    assert (told["is_result"], told["outcome"], told["failed_at"]) == (False, outcome.value, 1.234)


def test_an_audit_that_does_not_close_is_told(made: Callable[[str], Made], tmp_path: Path) -> None:
    run = made("series_elastic")
    audit = replace(run.audit, residual=run.audit.residual + 0.5)
    text, _ = _written(replace(run, audit=audit, outcome=Outcome.AUDIT_OPEN, failed_at=0.0), tmp_path / "result")
    assert "The energy balance does NOT close: its residual reaches 0.5 J" in text[: text.index("<nav")]
    assert '<p class="verdict open">' in text


def test_the_table_gives_every_number_back(made: Callable[[str], Made]) -> None:
    data = made("slider_leaf_joint").data
    rows = list(csv.DictReader(as_csv(data).splitlines()))
    assert len(rows) == data.time.size
    assert list(rows[0]) == ["time", *map(str, data.data_vars)]
    for name in rows[0]:
        if name == "status":
            assert [row[name] for row in rows] == [Status(int(code)).label for code in data.status.values]
        else:
            np.testing.assert_array_equal([float(row[name]) for row in rows], data[name].values)


def test_stored_data_are_the_run_s(made: Callable[[str], Made], tmp_path: Path) -> None:
    run = made("torsion_tube")
    write_simulation(run, tmp_path / "result")
    with xr.open_dataset(tmp_path / "result" / "data.nc", engine="h5netcdf") as stored:
        assert stored.attrs["outcome"] == "done"
        assert "failed_at" not in stored.attrs
        for name in run.data.data_vars:
            np.testing.assert_array_equal(stored[name].values, run.data[name].values)
    told = json.loads((tmp_path / "result" / "simulation.json").read_text(encoding="utf-8"))
    assert told["is_result"] is True
    assert told["metrics"]["position_bandwidth"]["value"] is None
    assert [event["name"] for event in told["events"]] == ["step", "drive saturated", "load"]
    entered, stored_terms, lost = (sum(told["energy"][key].values()) for key in ("entered", "stored", "lost"))
    # what came in is what is stored and lost, to the residual that is told
    assert entered == pytest.approx(stored_terms + lost, abs=1.001 * told["energy"]["residual"])


def test_events_and_metrics_are_told_with_units(made: Callable[[str], Made], tmp_path: Path) -> None:
    text, _ = _written(made("series_elastic"), tmp_path / "result")
    rows = re.findall(r"<tr><td class=\"number\">(\d+)</td><td class=\"number\">([^<]+)</td><td>([^<]+)</td>", text)
    assert rows == [("1", "0.2 s", "step"), ("2", "0.23 s", "drive saturated"), ("3", "1.6 s", "load")]
    for value in ("0.34 s", "12.4 %", "2.865 deg"):
        assert f'<div class="value">{value}</div>' in text
        assert f'<td class="number">{value}</td>' in text
    assert '<td class="number">—</td><td class="note">no chirp in this run</td>' in text


def test_a_run_of_one_sample_is_written(made: Callable[[str], Made], tmp_path: Path) -> None:
    run = made("slider_leaf_joint")
    audit = replace(
        run.audit,
        terms={name: values[:1] for name, values in run.audit.terms.items()},
        residual=run.audit.residual[:1],
        turnover=run.audit.turnover[:1],
    )
    first = replace(
        run, data=run.data.isel(time=slice(0, 1)), audit=audit, outcome=Outcome.STEP_TOO_LARGE, failed_at=0.0
    )
    text, _ = _written(first, tmp_path / "result")
    assert "This is no result: step too large at 0 ms." in text


def test_an_earlier_result_is_replaced_and_nothing_else(made: Callable[[str], Made], tmp_path: Path) -> None:
    run, target = made("series_elastic"), tmp_path / "result"
    write_simulation(run, target)
    (target / "figures" / "stale.svg").write_text("old", encoding="utf-8")
    write_simulation(run, target)
    assert not (target / "figures" / "stale.svg").exists()
    (target / "notes.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(InputError, match="notes"):
        write_simulation(run, target)
    assert (target / "notes.txt").read_text(encoding="utf-8") == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["result"]


def test_a_failure_leaves_nothing_behind(
    made: Callable[[str], Made], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(write, "write_netcdf", fail)
    with pytest.raises(KeyboardInterrupt):
        write_simulation(made("series_elastic"), tmp_path / "result")
    assert list(tmp_path.iterdir()) == []
