"""The mechanism in motion obeys the geometry of its device, in the fixed frame."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.actuators.maccepa import Maccepa
from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import FixedPair, SingleLower
from varistiff.actuators.series_elastic import SeriesElastic
from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.elastic.leaf import Leaf
from varistiff.report.simulation.mechanism import build_scene
from varistiff.report.simulation.mechanism.encode import Readout, encode
from varistiff.report.simulation.mechanism.frames import Frames, choose
from varistiff.report.simulation.mechanism.scene import ELEMENT, LINK, SETTING, Part, Scene
from varistiff.report.simulation.mechanism.strip import draw_strip
from varistiff.report.simulation.run import Run
from varistiff.report.style import INK

from .synthetic import Made

MM = 1e3


def _frames(made: Made) -> Frames:
    frames = Frames.of(Run(made))
    assert frames is not None
    return frames


def _scene(made: Made, frames: Frames) -> Scene:
    scene = build_scene(made.design.actuator, frames)
    assert scene is not None
    return scene


def _parts(scene: Scene, colour: str, *, deforms: bool | None = None, disc: bool = False) -> list[Part]:
    return [
        part
        for part in scene.parts
        if colour in (part.fill, part.edge)
        and (part.radius > 0.0) == disc
        and (deforms is None or part.deforms == deforms)
    ]


def _distance(point: np.ndarray, line: np.ndarray) -> float:
    piece = np.diff(line, axis=0)
    part = np.clip(((point - line[:-1]) * piece).sum(axis=1) / (piece**2).sum(axis=1), 0.0, 1.0)
    return float(np.hypot(*(line[:-1] + part[:, None] * piece - point).T).min())


def test_every_kind_builds_and_paints(run_of_kind: Made) -> None:
    frames = _frames(run_of_kind)
    assert 60 <= frames.count <= 120
    scene = _scene(run_of_kind, frames)
    for part in scene.parts:
        assert part.body.poses.shape == (frames.count, 3)
        assert np.isfinite(part.body.poses).all()
    drawing = draw_strip(Run(run_of_kind), scene, frames)
    for axes in drawing.figure.axes:
        left, right = axes.get_xlim()
        bottom, top = axes.get_ylim()
        box, (wide, high) = axes.get_position(), drawing.figure.get_size_inches()
        # one scale both ways, or an angle drawn is not the angle meant
        assert (right - left) / (box.width * wide) == pytest.approx((top - bottom) / (box.height * high), rel=1e-6)
    assert drawing.svg().count("<path") > 10


def test_sliders_hold_the_leaf(made: Callable[[str], Made]) -> None:
    """Leaf and clamp turn with the link, the sliders with the drive; between the two pins there is the leaf."""
    run = made("slider_leaf_joint")
    frames, joint = _frames(run), run.design.actuator
    assert isinstance(joint, SliderLeafJoint)
    scene = _scene(run, frames)
    (leaf,) = _parts(scene, ELEMENT, deforms=True)
    pins = [part for part in scene.parts if part.radius and part.points[0, 1] != 0.0]
    assert len(pins) == 2
    for frame in range(0, frames.count, 7):
        line, link, drive = leaf.at(frame), frames.link[frame], frames.driven[frame]
        clamp = joint.clamp_radius * MM * np.array([math.cos(link), math.sin(link)])
        np.testing.assert_allclose(line[0], clamp, atol=1e-9)
        middle = 0.5 * sum(pin.at(frame)[0] for pin in pins)
        place = (joint.clamp_radius + frames.setting[frame]) * MM
        np.testing.assert_allclose(middle, place * np.array([math.cos(drive), math.sin(drive)]), atol=1e-9)
        # the exact leaf passes through that point; 0.05 mm for its 30 straight pieces
        assert _distance(middle, line) < 0.05


def test_the_cable_of_a_maccepa_keeps_its_length(made: Callable[[str], Made]) -> None:
    """From the lever's tip over the anchor to the plate; the pretension takes up what is missing."""
    run = made("maccepa")
    frames, actuator = _frames(run), run.design.actuator
    assert isinstance(actuator, Maccepa)
    scene = _scene(run, frames)
    (cable,) = [part for part in scene.parts if part.deforms and part.points.shape[1] == 2]
    (plate,) = _parts(scene, SETTING)
    lengths = []
    for frame in range(frames.count):
        tip, anchor = cable.at(frame)
        behind = float(np.hypot(*(plate.at(frame).mean(axis=0) - anchor)))
        lengths.append(float(np.hypot(*(tip - anchor))) + behind + frames.setting[frame] * MM)
        angle = math.atan2(tip[1], tip[0])
        assert math.cos(angle - frames.driven[frame]) == pytest.approx(1.0, abs=1e-12)
    np.testing.assert_allclose(lengths, lengths[0], rtol=1e-12)


@pytest.mark.parametrize("pair", [False, True])
def test_a_roller_lies_on_the_beam(pair: bool) -> None:
    """A bearing roller touches the surface of the deformed beam: its centre is a radius and half a thickness away."""
    beam = Leaf(youngs_modulus=194e9, width=25.45e-3, thickness=3.16e-3, length=0.9)
    single = SingleLower(radius=0.01, offset=-0.012)
    rollers = FixedPair(offset=0.0, radius=0.01, clearance=2e-4) if pair else single
    actuator = RollerBeam(beam=beam, mounting_angle=0.05 if not pair else 0.0, rollers=rollers)
    angles = np.linspace(0.04, 0.14, 9)
    frames = Frames(np.arange(9), angles, angles, None, angles, np.linspace(0.3, 0.5, 9))
    scene = build_scene(actuator, frames)
    assert scene is not None
    (line,) = _parts(scene, ELEMENT, deforms=True)
    discs = _parts(scene, SETTING, disc=True)
    for frame in range(9):
        gaps = [_distance(part.at(frame)[0], line.at(frame)) - 10.0 - 1.58 for part in discs]
        assert min(gaps) == pytest.approx(0.0, abs=0.05)  # mm; the beam is drawn in 40 straight pieces


def test_the_tube_twists_by_its_torque(made: Callable[[str], Made]) -> None:
    """The drawn twist between flange and bearing is T L/(G I_t), and the bearing turns with the link."""
    run = made("torsion_tube")
    frames, tube = _frames(run), run.design.actuator
    assert isinstance(tube, TorsionTube)
    scene = _scene(run, frames)
    torque = np.asarray(run.design.evaluate(frames.deflection, frames.setting).load)
    twist = torque * frames.setting / (tube.shear_modulus * tube.torsion_constant)
    marks = [part.points for part in _parts(scene, ELEMENT, deforms=True) if not part.closed]
    outer = 11.0  # mm, of the example
    checked = 0
    for frame in range(frames.count):
        for mark in marks:
            if np.isfinite(mark[frame, [0, -1], 1]).all():
                start, end = np.arcsin(np.clip(mark[frame, [0, -1], 1] / outer, -1.0, 1.0))
                if max(abs(start), abs(end)) < 1.3:  # near the rim a height says little of an angle
                    assert start - end == pytest.approx(twist[frame], abs=2e-3)  # 161st of a turn of its outline
                    checked += 1
    assert checked > 200
    bearing = next(part for part in _parts(scene, LINK, disc=True))
    np.testing.assert_allclose(bearing.body.poses[:, 2], frames.link, atol=1e-12)


def test_a_spiral_joins_drive_and_link(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    frames = _frames(run)
    assert isinstance(run.design.actuator, SeriesElastic)
    (spiral,) = _parts(_scene(run, frames), ELEMENT, deforms=True)
    first = spiral.at(0)
    for frame in range(frames.count):
        line = spiral.at(frame)
        for end, turned in ((0, frames.driven[frame] - frames.driven[0]), (-1, frames.link[frame] - frames.link[0])):
            c, s = math.cos(turned), math.sin(turned)
            np.testing.assert_allclose(line[end], first[end] @ np.array([[c, s], [-s, c]]), atol=1e-9)


def test_leaves_run_from_nut_to_roller(made: Callable[[str], Made]) -> None:
    run = made("antagonistic_leaves")
    frames, device = _frames(run), run.design.actuator
    leaves = _parts(_scene(run, frames), ELEMENT, deforms=True)
    assert len(leaves) == 4
    for frame in range(0, frames.count, 11):
        for leaf, side in zip(leaves, (-1.0, -1.0, 1.0, 1.0), strict=True):
            line = leaf.at(frame)
            roller = frames.driven[frame] + side * 0.5 * device.roller_distance
            assert line[1, 0] == pytest.approx(roller * MM, abs=1e-6)  # the first point is the tail beyond it
            clamp = frames.link[frame] + side * 0.5 * frames.setting[frame]
            assert line[-1, 0] == pytest.approx(clamp * MM, abs=1e-6)


def test_a_link_with_weight_hangs_down(made: Callable[[str], Made]) -> None:
    run = made("maccepa")
    data = run.data.copy().assign_attrs(gravity_rest=0.3)
    data["link"] = data.link * 0.0 + 0.3
    data["drive"] = data.link + data.deflection
    hanging = replace(run, data=data)
    frames = _frames(hanging)
    bob = max(_parts(_scene(hanging, frames), LINK, disc=True), key=lambda part: part.radius)
    x, y = bob.at(0)[0]
    assert y < 0.0
    assert x == pytest.approx(0.0, abs=1e-9 * abs(y))


def test_a_link_at_its_stop_lies_against_it(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    data = run.data.copy()
    top = float(data.link.max())
    data["link"] = data.link.assign_attrs(limits=(-math.inf, top))
    stopped = replace(run, data=data)
    frames = _frames(stopped)
    scene = _scene(stopped, frames)
    (arm,) = [part for part in _parts(scene, LINK, deforms=False) if part.width > 0.0]
    (block,) = [part for part in scene.parts if part.fill == INK and part.closed]
    c, s = math.cos(top), math.sin(top)
    corners = block.at(0) @ np.array([[c, -s], [s, c]])  # seen from an arm at the stop
    assert corners[:, 1].min() == pytest.approx(0.5 * arm.width, rel=1e-9)
    assert ("stop", INK, "patch") in scene.key


def test_frames_are_where_things_move() -> None:
    time = np.linspace(0.0, 10.0, 5001)
    moving = np.where(time < 1.0, np.sin(2.0 * np.pi * 5.0 * time), 0.0)
    chosen = choose(time, [moving], 120, usable=np.ones(time.size, bool))
    assert chosen.size <= 120
    assert (np.diff(chosen) > 0).all()
    assert (chosen[0], chosen[-1]) == (0, time.size - 1)
    share = float((time[chosen] < 1.0).mean())
    assert share == pytest.approx(0.55, abs=0.03)  # half for what moves, and a tenth of the other half


@given(st.integers(1, 400), st.integers(2, 150))
def test_never_too_many_frames(samples: int, most: int) -> None:
    time = np.linspace(0.0, 1.0, samples)
    chosen = choose(time, [np.zeros(samples)], most, usable=np.ones(samples, bool))
    assert 1 <= chosen.size <= most
    assert chosen[0] == 0


def test_what_went_astray_is_not_drawn(made: Callable[[str], Made]) -> None:
    run = made("antagonistic_leaves")
    data = run.data.copy(deep=True)
    data["deflection"][-5:] = 1e20
    data["setting"][:3] = -0.01  # a nut that has passed its stop
    data["link"][10] = np.nan
    frames = _frames(replace(run, data=data))
    assert frames.index[0] >= 3
    assert frames.index[-1] == data.time.size - 6
    assert 10 not in frames.index
    assert np.abs(frames.deflection).max() < 1.0
    data["deflection"][:] = np.nan
    assert Frames.of(Run(replace(run, data=data))) is None


def _decoded(part: dict[str, object], frame: int) -> list[tuple[float, float] | None]:
    """Points as the player of the page reads them."""
    flat = part["s"] if "s" in part else part["m"][frame]  # type: ignore[index]  # plain JSON
    points: list[tuple[float, float] | None] = []
    x = y = 0
    pieces = iter(flat)  # type: ignore[call-overload]  # plain JSON
    for piece in pieces:
        if piece is None:
            points.append(None)
            continue
        x, y = x + piece, y + next(pieces)
        points.append((x / 100.0, y / 100.0))
    return points


def test_the_player_s_data_are_the_scene(run_of_kind: Made) -> None:
    frames = _frames(run_of_kind)
    scene = _scene(run_of_kind, frames)
    readout = Readout("Link", "deg", np.degrees(frames.link))
    text = encode(scene, frames, readouts=[readout], events=[(0.2, "step")])
    assert len(text) < 1_500_000
    content = json.loads(text)
    np.testing.assert_allclose(content["time"], frames.time, atol=1e-6)
    np.testing.assert_allclose(content["readouts"][0]["values"], readout.values, rtol=1e-4, atol=1e-12)
    left, right, bottom, top = content["view"]
    for frame in (0, frames.count // 2, frames.count - 1):
        for part, told in zip(scene.parts, content["parts"], strict=True):
            series = content["bodies"][told["b"]]
            x, y, angle = (each if isinstance(each, int) else each[frame] for each in series)
            c, s = math.cos(angle / 1e5), math.sin(angle / 1e5)
            for point, own in zip(_decoded(told, frame), part.at(frame), strict=True):
                if point is None:
                    assert np.isnan(own).any()
                    continue
                place = np.array([c * point[0] - s * point[1] + x / 100, s * point[0] + c * point[1] + y / 100])
                # 0.005 mm of rounding each for body and point, and half a step of the angle at the point's distance
                assert np.abs(place - own).max() < 0.011 + 0.5e-5 * math.hypot(*point)
                assert left <= own[0] <= right
                assert bottom <= own[1] <= top


def test_names_cannot_end_the_script(made: Callable[[str], Made]) -> None:
    frames = _frames(made("series_elastic"))
    scene = _scene(made("series_elastic"), frames)
    name = "</script><script>alert(1)</script><!-- & "
    text = encode(scene, frames, events=[(0.1, name)])
    assert "<" not in text
    assert json.loads(text)["events"] == [[0.1, name]]
