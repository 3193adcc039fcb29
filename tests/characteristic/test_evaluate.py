"""Points and maps: shapes, blocks, labels, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from varistiff.actuators import Maccepa, RollerBeam, SeriesElastic, SwivellingPair, TorsionTube
from varistiff.actuators.compiled import BLOCK
from varistiff.characteristic.evaluate import evaluate
from varistiff.characteristic.map import characteristic_map
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.elastic.leaf import Leaf
from varistiff.sections import HollowCircle

TUBE = TorsionTube(
    shear_modulus=0.63e9,
    section=HollowCircle(outer_radius=0.011, inner_radius=0.0087),
    length=0.17,
    yield_strength=48e6,
)


def test_any_number_of_points_in_order() -> None:
    count = 2 * BLOCK + 17
    deflection = np.linspace(-0.2, 0.2, count)
    points = evaluate(TUBE, deflection, 0.1)
    rigidity = 0.63e9 * np.pi / 2 * (0.011**4 - 0.0087**4)
    assert points.load == pytest.approx(rigidity / 0.1 * deflection, rel=1e-12)  # rounding
    assert points.setting.shape == (count,)
    seen: list[tuple[int, int]] = []
    evaluate(TUBE, deflection, 0.1, progress=lambda done, total: seen.append((done, total)))
    assert seen == [(BLOCK, count), (2 * BLOCK, count), (count, count)]


@pytest.mark.parametrize("shape", [(), (0,), (1,), (3, 2)])
def test_shapes_are_kept(shape: tuple[int, ...]) -> None:
    points = evaluate(TUBE, np.full(shape, 0.1), 0.05)
    assert points.load.shape == points.status.shape == points.deflection.shape == shape


def test_counts_name_the_statuses() -> None:
    points = evaluate(TUBE, [0.0, 0.01, 0.01, 0.01], [0.1, 0.1, 0.2, -0.1])
    assert points.counts() == {Status.OK: 2, Status.ELEMENT_TOO_SHORT: 1, Status.NO_SOLUTION: 1}
    assert repr(points).startswith("<Points 4: 2 ok, 1 no_solution, 1 element_too_short;")


@pytest.mark.parametrize(
    ("deflection", "setting", "said"),
    [
        ("5 deg", 0.1, "deflection: takes numbers"),
        (0.1, 1j, "setting"),
        ([0.1, np.nan], 0.1, "deflection"),
        (0.1, np.inf, "setting"),
        (0.1, None, "setting"),
        ([1, 2], [1, 2, 3], "shape"),
    ],
)
def test_what_is_no_point_is_refused(deflection: object, setting: object, said: str) -> None:
    with pytest.raises(InputError, match=said):
        evaluate(TUBE, deflection, setting)


def test_map_is_labelled(tmp_path: Path) -> None:
    beam = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316, length=0.9, yield_strength=500e6)
    device = RollerBeam(beam=beam, rollers=SwivellingPair(offset=0.0, clearance=0.0002))
    d, s = np.linspace(-0.2, 0.1, 7), np.linspace(0.2, 1.0, 5)
    dataset = characteristic_map(device, deflection=d, setting=s, attrs={"title": "Beam"})
    assert dataset.torque.dims == ("setting", "deflection")
    assert {name: dataset[name].attrs["units"] for name in ("torque", "stiffness", "adjusting_force", "stress")} == {
        "torque": "N*m",
        "stiffness": "N*m/rad",
        "adjusting_force": "N",
        "stress": "Pa",
    }
    single = evaluate(device, d[1], s[2])
    assert float(dataset.torque.sel(deflection=d[1], setting=s[2])) == float(single.load)
    assert all("units" in dataset[name].attrs for name in [*dataset.data_vars, *dataset.coords])
    assert dataset.attrs["title"] == "Beam"
    assert "dos_santos_2019" in dataset.attrs["references"]
    path = tmp_path / "map.nc"
    dataset.to_netcdf(path, engine="h5netcdf")
    with xr.open_dataset(path, engine="h5netcdf") as back:
        assert back.status.attrs["flag_meanings"].split()[int(back.status[0, 3])] in {s.label for s in Status}
        assert np.array_equal(back.energy, dataset.energy, equal_nan=True)


def test_map_without_a_setting_and_with_an_angle() -> None:
    spring = characteristic_map(SeriesElastic(stiffness=160.0), deflection=[-0.1, 0.0, 0.1])
    assert spring.torque.dims == ("deflection",)
    assert spring.torque.values == pytest.approx([-16.0, 0.0, 16.0])
    assert np.isnan(spring.adjusting_force).all()
    lever = Maccepa(spring_rate=394.0, lever_length=0.036, anchor_distance=0.135)
    assert "adjusting_force" in characteristic_map(lever, deflection=[0.1], setting=[0.01])
