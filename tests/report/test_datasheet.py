"""Numbers of the datasheet against closed forms worked out here."""

from __future__ import annotations

import csv
import io
import json
import math
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from varistiff.characteristic.datasheet import datasheet
from varistiff.core.status import Status

from .conftest import map_of

TEN_DEGREES = math.radians(10.0)
ROUNDING = 1e-12  # a few operations in float64


def test_series_elastic_by_hand(folder: Path) -> None:
    sheet = datasheet(map_of("series_elastic", folder))
    assert sheet["stiffness_rest"].value == pytest.approx(160.0, rel=ROUNDING)
    assert sheet["torque_peak"].value == pytest.approx(160.0 * TEN_DEGREES, rel=ROUNDING)
    assert sheet["energy_capacity"].value == pytest.approx(80.0 * TEN_DEGREES**2, rel=ROUNDING)
    assert sheet["deflection_limit"].value == pytest.approx(TEN_DEGREES, rel=ROUNDING)
    assert "edge of the map" in sheet["deflection_limit"].note
    (limit,) = sheet.limits
    assert limit.setting is None
    assert limit.status is None
    with pytest.raises(KeyError, match="torque_peak"):
        sheet["adjusting_force_peak"]


def test_torsion_tube_by_hand(folder: Path) -> None:
    """k = G J/x; yield at torque = W tau_y; the map stops at the 150 mm of the element, not at 166 mm."""
    dataset = map_of("torsion_tube", folder)
    sheet = datasheet(dataset)
    torsion_constant = math.pi / 2.0 * (0.011**4 - 0.0087**4)
    rigidity = 0.63e9 * torsion_constant
    strength = 48e6 / math.sqrt(3.0)
    torque_limit = strength * torsion_constant / 0.011
    settings = dataset.setting.values
    longest = settings[settings <= 0.150].max()
    assert sheet["stiffness_rest_max"].value == pytest.approx(rigidity / 0.011, rel=ROUNDING)
    assert sheet["stiffness_rest_min"].value == pytest.approx(rigidity / longest, rel=ROUNDING)
    assert sheet["stiffness_rest_ratio"].value == pytest.approx(longest / 0.011, rel=ROUNDING)
    assert sheet["strength"].value == pytest.approx(strength, rel=ROUNDING)

    # the last ok point lies below the yield torque by less than one step of the grid
    step = float(np.diff(dataset.deflection.values)[0])
    first = sheet.limits[0]
    assert first.status is Status.YIELDED
    assert first.deflection is not None
    yielding = torque_limit / (rigidity / 0.011)
    assert yielding - step < abs(first.deflection) <= yielding
    assert first.load == pytest.approx(rigidity / 0.011 * first.deflection, rel=ROUNDING)
    last = sheet.limits[-1]
    assert (last.deflection, last.stiffness, last.status) == (None, None, Status.ELEMENT_TOO_SHORT)

    torque = sheet["torque_peak"].value
    adjusting = sheet["adjusting_force_peak"].value
    assert torque is not None
    assert torque <= torque_limit
    assert adjusting == pytest.approx(torque**2 / (2.0 * rigidity), rel=1e-9)  # dV/dx = -T^2/(2 G J)
    assert "holds back" in sheet["adjusting_force_peak"].note
    assert sheet["utilisation"].value == pytest.approx(torque / torque_limit, rel=1e-9)


def test_counts_are_those_of_the_map(dataset: xr.Dataset) -> None:
    sheet = datasheet(dataset)
    status = dataset.status.values
    assert sum(entry.count for entry in sheet.statuses) == status.size
    assert sum(entry.fraction for entry in sheet.statuses) == pytest.approx(1.0)
    for entry in sheet.statuses:
        assert entry.count == int((status == entry.status).sum()) > 0


def test_every_limit_is_ok_up_to_it(dataset: xr.Dataset) -> None:
    """Between rest and a limit only ok points and play; right beyond it the status that the limit names."""
    sheet = datasheet(dataset)
    for limit in sheet.limits:
        row = dataset if limit.setting is None else dataset.sel(setting=limit.setting)
        if limit.deflection is None:
            assert limit.status is not None
            continue
        deflection = row.deflection.values
        inside = (np.sign(limit.deflection) * deflection >= 0.0) & (np.abs(deflection) <= abs(limit.deflection))
        assert set(row.status.values[inside].tolist()) <= {Status.OK, Status.NO_CONTACT}
        outward = np.sign(limit.deflection) * deflection > abs(limit.deflection)
        beyond = row.status.values[outward]
        if limit.status is not None:
            nearest = np.argmin(np.abs(deflection[outward]))
            assert beyond[nearest] == limit.status


def test_play_and_stiffness_beyond_it(folder: Path) -> None:
    """A clearance of 2 mm at 200 mm is a play of +/- 0.01 rad; the stiffness next to it is the beam's."""
    sheet = datasheet(map_of("roller_beam", folder))
    play = sheet["play"].value
    assert play == pytest.approx(2.0 * math.asin(0.01), abs=2.0 * math.radians(0.4))  # a step of the grid each side
    rigidity = 194e9 * 0.02545 * 0.00316**3 / 12.0
    stiffest = sheet["stiffness_rest_max"]
    assert stiffest.value == pytest.approx(3.0 * rigidity / 0.2, rel=0.02)  # linear cantilever 3 E I/x_r
    assert "beyond the play" in stiffest.note


def test_preload_counts_as_stored_at_rest(folder: Path) -> None:
    dataset = map_of("maccepa", folder)
    sheet = datasheet(dataset)
    assert sheet["energy_rest"].value == pytest.approx(0.5 * 394.0 * 0.025**2, rel=1e-9)  # k P^2/2
    swing = math.sqrt(0.135**2 + 0.036**2 - 2.0 * 0.135 * 0.036 * math.cos(math.radians(60.0)))
    elongation = swing + 0.025 - 0.099
    capacity = 0.5 * 394.0 * (elongation**2 - 0.025**2)
    assert sheet["energy_capacity"].value == pytest.approx(capacity, rel=1e-9)


def test_nothing_ok_gives_no_numbers_but_a_sheet() -> None:
    shape = ("setting", "deflection")
    none = np.full((3, 5), np.nan)
    variables = {name: (shape, none, {"units": "1"}) for name in ("energy", "torque", "stiffness", "adjusting_force")}
    status = np.full((3, 5), int(Status.NO_SOLUTION), np.int8)
    dataset = xr.Dataset(
        {**variables, "status": (shape, status)},
        {"setting": np.linspace(0.1, 0.3, 3), "deflection": np.linspace(-0.1, 0.1, 5)},
    )
    sheet = datasheet(dataset)
    assert sheet["torque_peak"].value is None
    assert sheet["stiffness_rest_min"].value is None
    assert all(limit.deflection is None for limit in sheet.limits)
    json.dumps(sheet.as_dict(), allow_nan=False)


def test_json_and_csv_say_the_same(dataset: xr.Dataset) -> None:
    sheet = datasheet(dataset)
    plain = json.loads(json.dumps(sheet.as_dict(), allow_nan=False))
    rows = {row["key"]: row for group in plain["groups"] for row in group["rows"]}
    table = list(csv.DictReader(io.StringIO(sheet.as_csv())))
    written = {row["key"]: row for row in table if row["group"] not in ("limits", "statuses")}
    assert written.keys() == rows.keys()
    for key, row in written.items():
        assert (float(row["value"]) if row["value"] else None) == rows[key]["value"]
        assert row["unit"] == rows[key]["unit"]
