"""The solid of the prototype: its one mesh beside a finer one, and what supports the corrected reading."""

from __future__ import annotations

import pytest

from varistiff.papers.schuy_2013 import solid
from varistiff.papers.schuy_2013.corrected_reading import RAIL_WIDTH

pytest.importorskip("ngsolve")


@pytest.fixture(autouse=True)
def _own_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    """The solids are computed, whatever an earlier run kept on disk."""
    monkeypatch.setenv("VARISTIFF_CACHE", "off")


def test_coarse_mesh_is_fine_enough() -> None:
    """Conforming elements: the finer mesh is the softer one, here by less than what the module promises."""
    coarse, fine = (solid.flange_stiffness(width=0.006, active_length=0.011, level=level) for level in (0, 1))
    assert fine < coarse < 1.004 * fine


def test_seven_millimetres_of_rail_meet_the_printed_excess() -> None:
    """Of widths in steps of half a millimetre with the same J only this one rounds to 62 %."""
    assert solid.widths_that_meet_excess(0.0065, RAIL_WIDTH, 0.0075) == [RAIL_WIDTH]


def test_local_share_falls_with_the_active_length() -> None:
    (stiff, near), (soft, far) = (solid.bearing_response(active_length=x) for x in (0.011, 0.166))
    assert stiff > soft
    assert near > far > 0.0
    # the local twist per torque hardly depends on the length, so the share falls like the stiffness
    assert near / far == pytest.approx(stiff / soft, rel=0.05)  # clamp and bearing disturb each other at 11 mm
