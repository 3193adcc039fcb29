"""Outlines from CSV and DXF files: what is read, and one line for each file that is not."""

from __future__ import annotations

import contextlib
import math
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from varistiff.core.errors import InputError
from varistiff.design.outline_file import read_outline
from varistiff.sections.bezier import Bezier
from varistiff.sections.hollow_circle import HollowCircle
from varistiff.sections.loops import loop_area
from varistiff.sections.outline import Arc, Line, Loop
from varistiff.sections.polygon import Polygon, polygon_of_points

MM, INCH = 1e-3, 0.0254
L_SHAPE = [(0.0, 0.0), (20.0, 0.0), (20.0, 10.0), (10.0, 10.0), (10.0, 20.0), (0.0, 20.0)]
L_ROWS = "".join(f"{x},{y}\n" for x, y in L_SHAPE)

Draw = Callable[[Callable[[Any], object]], Path]


def csv_file(tmp_path: Path, text: str | bytes) -> Path:
    path = tmp_path / "outline.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def said_of(path: Path, unit: float | None = MM) -> str:
    with pytest.raises(InputError) as caught:
        read_outline(path, unit=unit)
    line = str(caught.value)
    assert "\n" not in line
    assert len(line.replace(str(path), "")) < 400
    return line


def areas(loops: tuple[Loop, ...], unit: float = MM) -> list[float]:
    return [loop_area(loop) / unit**2 for loop in loops]


@pytest.fixture
def draw(tmp_path: Path) -> Draw:
    """A DXF file in mm of what a function draws in its model space."""
    ezdxf = pytest.importorskip("ezdxf")

    def drawn(function: Callable[[Any], object], *, units: int = 4, version: str = "R2010") -> Path:
        document = ezdxf.new(version)
        document.header["$INSUNITS"] = units
        function(document.modelspace())
        path = tmp_path / "drawing.dxf"
        document.saveas(path)
        return path

    return drawn


# --- CSV


@pytest.mark.parametrize(
    "text",
    [
        f"x,y\n{L_ROWS}",
        f"x,y\n{L_ROWS}0,0\n",
        f"\ufeffx , y\r\n\r\n{L_ROWS}\r\n\r\n".replace("\r\n", "\n").replace("\n", "\r\n"),
        "y,x\n" + "".join(f"{y},{x}\n" for x, y in L_SHAPE),
        "loop,x,y\n" + "\n".join(f"0, {x}, {y}\n" for x, y in L_SHAPE),
    ],
)
def test_corners_are_read_in_their_unit(tmp_path: Path, text: str) -> None:
    for unit in (MM, INCH):
        (loop,) = read_outline(csv_file(tmp_path, text), unit=unit)
        assert [segment.start for segment in loop if isinstance(segment, Line)] == [
            (unit * x, unit * y) for x, y in L_SHAPE
        ]


@pytest.mark.parametrize(
    "text",
    [
        "x,y\n0,0\n40,0\n40,40\n0,40\n\n\n10,10\n20,10\n20,20\n\n30,30\n35,30\n35,35\n",
        "x,y\n0,0\n40,0\n40,40\n0,40\n,\n10,10\n20,10\n20,20\n , \n30,30\n35,30\n35,35\n",
        "x,y,loop\n10,10,2\n20,10,2\n20,20,2\n0,0,0\n40,0,0\n40,40,0\n0,40,0\n\n30,30,7\n35,30,7\n35,35,7\n",
    ],
)
def test_holes_are_separate_loops(tmp_path: Path, text: str) -> None:
    assert areas(read_outline(csv_file(tmp_path, text), unit=MM)) == pytest.approx([1600.0, -50.0, -12.5])


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "is empty"),
        (b"\x00\x01\x02", "binary"),
        (b"x,y\n\xff\xfe\n", "is not UTF-8"),
        ("x,y\n", "has no loop 0"),
        ("0,0\n1,0\n1,1\n", "header: is missing; allowed is a first line x,y"),
        ("x;y\n0;0\n", "header: the columns are not separated by commas"),
        ("x\n0\n", "header: the column y is missing"),
        ("x,y,x\n0,0,0\n", "header: the column x is there 2 times"),
        ("x,y,z\n0,0,0\n", 'header: unknown column "z"'),
        ("x,y,lop\n0,0,0\n", 'did you mean "loop"?'),
        ("X,Y\n0,0\n", 'unknown column "X" (did you mean "x"?)'),
        ("x,y\n0,0\n1\n", "line 3: has 1 cell; allowed are 2"),
        ("x,y\n0,0\n1,2,3\n", "line 3: has 3 cells; allowed are 2"),
        ("x,y\n0,0\n1,two\n", 'line 3, column y: "two" is not a number'),
        ("x,y\n0,0\n1 mm,2\n", 'line 3, column x: "1 mm" is not a number'),
        ("x,y\n0,0\n1,\n", "line 3, column y: is blank"),
        ("x,y\n0,nan\n", '"nan" is not finite'),
        ("x,y\n0,1e999\n", "is too large"),
        ("x,y\n0,0\n1e300,0\n1e300,1e300\n", "loop 0: has a point that is not finite or too far away"),
        ("x,y\n0,٣\n", "is not a number"),
        ("x,y,loop\n0,0,1.5\n", 'line 2, column loop: "1.5" is not a whole number'),
        ("x,y,loop\n0,0,-1\n", "is not a whole number"),
        ("x,y,loop\n0,0,\n", "line 2, column loop: is blank"),
        ("x,y,loop\n0,0,1\n1,0,1\n1,1,1\n", "has no loop 0"),
        ("x,y,loop\n0,0,0\n1,0,1\n1,1,0\n", "line 4: loop 0 goes on after loop 1"),
        ("x,y\n0,0\n1,0\n", "loop 0: has fewer than 3 corners"),
        ("x,y\n0,0\n40,0\n40,40\n\n50,0\n60,0\n60,9\n", "loop 1: lies outside loop 0 at (50, 0) mm"),
        ("x,y\n0,0\n10,10\n10,0\n0,10\n", "crosses or touches itself at (5, 5) mm"),
        ('x,y\n"0,1\n', "is not CSV"),
        ("x,y\n" + "1" * 200_000 + ",2\n", "is not CSV"),
        ("x,y\n" + "1,2\n" * 300_000, "is too large"),
        ("x,y\n" + "".join(f"{k},{k * k}\n" for k in range(2000)), "has 2000 segments"),
    ],
)
def test_a_wrong_csv_file_is_one_line(tmp_path: Path, text: str | bytes, said: str) -> None:
    path = csv_file(tmp_path, text)
    line = said_of(path)
    assert line.startswith(f"{path}: ")
    assert said in line


def test_a_csv_file_needs_a_unit(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="unit: is missing; allowed is the unit of the numbers") as caught:
        read_outline(csv_file(tmp_path, "x,y\n"))
    assert (caught.value.file, caught.value.field) == (None, "unit")


def test_other_files_are_refused(tmp_path: Path) -> None:
    assert 'file: ends in ".step"; allowed are files that end in .csv or .dxf' in said_of(tmp_path / "a.step")
    for name in ("none.csv", "none.dxf"):
        assert "cannot be read: no such file" in said_of(tmp_path / name)
    for name in ("folder.csv", "folder.dxf"):
        (tmp_path / name).mkdir()
        assert "is a directory" in said_of(tmp_path / name) or "not a regular file" in said_of(tmp_path / name)
    for name in ("a\0b.csv", "a\0b.dxf"):
        assert "is no path" in said_of(tmp_path / name)


# --- DXF


def test_a_tube_of_circles_is_exact(draw: Draw) -> None:
    def tube(space: Any) -> None:
        space.add_circle((5.0, -3.0), 8.7)
        space.add_circle((5.0, -3.0), 11.0)
        space.add_text("bore")
        space.add_hatch()
        space.add_linear_dim(base=(0.0, 20.0), p1=(0.0, 0.0), p2=(11.0, 0.0)).render()

    exact = HollowCircle(outer_radius=0.011, inner_radius=0.0087).torsion_constant
    loops = read_outline(draw(tube))
    assert all(isinstance(segment, Arc) for loop in loops for segment in loop)
    assert Polygon(loops).torsion_constant == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("version", ["R12", "R2000", "R2018"])
@pytest.mark.parametrize("clockwise", [False, True])
def test_bulges_are_exact_arcs(draw: Any, version: str, clockwise: bool) -> None:
    way = -1.0 if clockwise else 1.0
    slot = [(0.0, 0.0, 0.0), (20.0, 0.0, way), (20.0, way * 10.0, 0.0), (0.0, way * 10.0, way)]
    wave = [(2.0, way * 5.0, way * math.tan(math.pi / 8.0)), (8.0, way * 5.0, 0.0), (5.0, way * 8.0, 0.0)]

    def drawing(space: Any) -> None:
        if version == "R12":
            space.add_polyline2d(slot, format="xyb", close=True)
            space.add_polyline2d(wave, format="xyb", close=True)
        else:
            space.add_lwpolyline(slot, format="xyb", close=True)
            space.add_lwpolyline(wave, format="xyb", close=True)

    outer, inner = areas(read_outline(draw(drawing, version=version), unit=MM))
    assert outer == pytest.approx(200.0 + 25.0 * math.pi, rel=1e-5)
    assert inner == pytest.approx(-(9.0 + 4.5 * (math.pi - 2.0)), rel=1e-4)  # a quarter circle's segment outwards


def test_the_file_states_its_unit(draw: Any) -> None:
    def plate(space: Any) -> None:
        space.add_lwpolyline([(0, 0), (2, 0), (2, 1), (0, 1)], close=True)

    path = draw(plate, units=1)
    assert areas(read_outline(path), INCH) == pytest.approx([2.0])
    assert areas(read_outline(path, unit=INCH), INCH) == pytest.approx([2.0])
    with pytest.raises(InputError, match=r"^unit: is 1 mm, but the DXF file states 25\.4 mm; allowed is") as caught:
        read_outline(path, unit=MM)
    assert caught.value.file is None
    path = draw(plate, units=0)
    assert areas(read_outline(path, unit=MM)) == pytest.approx([2.0])
    with pytest.raises(InputError, match=r"^unit: is missing, and the DXF file states none; allowed is a unit"):
        read_outline(path)


@pytest.mark.parametrize("seed", range(4))
def test_lines_chain_in_any_order_and_direction(draw: Draw, seed: int) -> None:
    chance = random.Random(seed)

    def shuffled(space: Any) -> None:
        sides = list(zip(L_SHAPE, L_SHAPE[1:] + L_SHAPE[:1], strict=True))
        chance.shuffle(sides)
        for side in sides:
            start, end = side if chance.random() < 0.5 else side[::-1]
            space.add_line(start, (end[0] + chance.uniform(-5e-6, 5e-6), end[1]))
        space.add_line((3.0, 3.0), (3.0, 3.0))

    (loop,) = read_outline(draw(shuffled))
    assert areas((loop,)) == pytest.approx([300.0], rel=1e-5)
    assert all(one.end == two.start for one, two in zip(loop, loop[1:] + loop[:1], strict=True))
    if seed == 0:
        exact = polygon_of_points([(MM * x, MM * y) for x, y in L_SHAPE]).torsion_constant
        assert Polygon((loop,)).torsion_constant == pytest.approx(exact, rel=1e-5)


def test_lines_arcs_and_open_polylines_chain(draw: Draw) -> None:
    def slot(space: Any) -> None:
        space.add_lwpolyline([(0, -5), (10, -5), (20, -5)])
        space.add_arc((20, 0), 5, -90, 90)
        space.add_line((0, 5), (20, 5))
        space.add_arc((0, 0), 5, 90, 270)

    (loop,) = read_outline(draw(slot))
    assert areas((loop,)) == pytest.approx([200.0 + 25.0 * math.pi], rel=1e-5)
    properties = Polygon((loop,)).properties()
    assert properties.torsion_modulus > 0.0  # its joints are tangent, so no corner is re-entrant


def test_an_entity_seen_from_behind_is_mirrored(draw: Draw) -> None:
    def mirrored(space: Any) -> None:
        behind = {"extrusion": (0, 0, -1)}
        space.add_lwpolyline([(0, 0, 0), (20, 0, 1), (20, 10, 0)], format="xyb", close=True, dxfattribs=behind)
        space.add_circle((19, 4), 1, dxfattribs=behind)
        space.add_arc((0, 0), 100, 0, 90, dxfattribs={**behind, "layer": "off"})
        space.doc.layers.add("off").off()

    outer, inner = read_outline(draw(mirrored))
    assert areas((outer, inner)) == pytest.approx([100.0 + 12.5 * math.pi, -math.pi], rel=1e-4)
    assert max(segment.centre[0] for segment in outer if isinstance(segment, Arc)) == pytest.approx(-0.020)


def test_ellipses_and_splines_become_bezier_curves(draw: Draw) -> None:
    def curves(space: Any) -> None:
        space.add_ellipse((1, 2), major_axis=(30, 40), ratio=0.6)
        space.add_ellipse((1, 2), major_axis=(10, 0), ratio=0.5, start_param=0, end_param=math.pi)
        space.add_line((-9, 2), (11, 2))

    loops = read_outline(draw(curves))
    assert areas(loops) == pytest.approx([math.pi * 50 * 30, -math.pi * 25], rel=5e-5)
    assert isinstance(loops[0][0], Bezier)


def test_a_rational_spline_is_fitted(draw: Draw) -> None:
    from ezdxf.math import BSpline, ConstructionEllipse

    def circle(space: Any) -> None:
        space.add_spline().apply_construction_tool(BSpline.from_ellipse(ConstructionEllipse((0, 0), (10, 0))))

    (loop,) = read_outline(draw(circle))
    assert areas((loop,)) == pytest.approx([100.0 * math.pi], rel=2e-5)
    assert Polygon((loop,)).properties().torsion_modulus == pytest.approx(0.5 * math.pi * 1e-6, rel=1e-4)


def test_a_cubic_spline_is_exact(draw: Draw) -> None:
    def blob(space: Any) -> None:
        space.add_open_spline([(0, 0), (30, 0), (40, 30), (10, 40), (-20, 20), (0, 0)])

    (loop,) = read_outline(draw(blob))
    assert len(loop) == 3  # its knot spans

    def fitted(space: Any) -> None:
        space.add_spline([(0, 0), (30, 0), (30, 30), (0, 30), (0, 0)])

    (loop,) = read_outline(draw(fitted))
    assert len(loop) == 4


@pytest.mark.parametrize(
    "function, said",
    [
        (lambda space: None, "holds no outline in its model space; allowed are LINE"),
        (lambda space: space.add_text("nothing else"), "holds no outline"),
        (lambda space: space.add_line((1, 1), (1, 1)), "holds no outline"),
        (lambda space: space.add_line((0, 0), (10, 5)), "is open at (0, 0) mm, (10, 5) mm; allowed are closed loops"),
        (lambda space: space.add_lwpolyline([(0, 0), (10, 0), (10, 5)]), "is open at (0, 0) mm, (10, 5) mm"),
        (lambda space: [space.add_line((k, 0), (k, 9)) for k in range(9)], "and 14 more places"),
        (lambda space: space.add_arc((0, 0), 10, 0, 90), "is open at (10, 0) mm, (0, 10) mm"),
        (lambda space: [space.add_circle((x, 0), 5) for x in (0, 20)], "hole 1: lies outside the largest loop"),
        (lambda space: [space.add_circle((0, 0), 5) for _ in range(2)], "has 4 ends that meet at (5, 0) mm"),
        (lambda space: [space.add_circle((0, 0), r) for r in (9, 6, 3)], "hole 2: lies inside the hole hole 1"),
        (lambda space: space.add_line((0, 0, 0), (10, 5, 3)), "is not flat"),
        (lambda space: space.add_circle((0, 0), 5, dxfattribs={"extrusion": (1, 0, 0)}), "is not flat"),
        (lambda space: space.add_ellipse((0, 0), (0, 5, 5), 0.5), "is not flat"),
        (
            lambda space: space.add_polyline3d([(0, 0, 0), (9, 0, 1), (0, 9, 2)], close=True),
            "POLYLINE that is not flat",
        ),
        (lambda space: space.add_open_spline([(0, 0), (5, 0, 5), (5, 5), (0, 0)]), "is not flat"),
        (lambda space: space.add_3dface([(0, 0), (9, 0), (9, 9)]), "holds 3DFACE; allowed are LINE"),
        (lambda space: space.add_solid([(0, 0), (9, 0), (9, 9)]), "holds SOLID; allowed are LINE"),
        (lambda space: space.add_blockref("part", (0, 0)), "holds INSERT; allowed"),
        (lambda space: space.add_circle((0, 0), 0), "holds no outline"),
        (lambda space: space.add_circle((1e300, 0), 5), "not finite or too large"),
        (lambda space: space.add_lwpolyline([(k, k * k) for k in range(1500)], close=True), "more than 1000 lines"),
        (lambda space: space.add_lwpolyline([(0, 0), (9, 9), (9, 0), (0, 9)], close=True), "itself at (4.5, 4.5) mm"),
    ],
)
def test_a_wrong_drawing_is_one_line(draw: Draw, function: Callable[[Any], object], said: str) -> None:
    path = draw(function)
    line = said_of(path, unit=None)
    assert line.startswith(f"{path}: ")
    assert said in line


DAMAGED = [
    (b"", "is empty"),
    (b" \r\n", "is empty"),
    (b"\x00\xff" * 500, "is a binary file"),
    (b"AutoCAD Binary DXF\r\n\x1a\x00\x00\x00", "is a binary file"),
    (b"AC1027\x00\x00\x00", "is a binary file"),
    (b"hello\n", ""),
    (b"x,y\n0,0\n1,0\n1,1\n", ""),
    (b"\xff\xfe\xfd\xfc\n\xfb\n", ""),
    (b"  0\nSECTION\n  2\n", ""),
    (b"  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n 10\n", ""),
    (b"  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n 10\nabc\n  0\nENDSEC\n  0\nEOF\n", ""),
    (b"  0\nSECTION\n  2\nENTITIES\n  0\nCIRCLE\n 40\nnan\n  0\nENDSEC\n  0\nEOF\n", ""),
    (b"  0\nSECTION\n  2\nENTITIES\n  0\nSPLINE\n 71\n3\n  0\nENDSEC\n  0\nEOF\n", ""),
    (b"  0\nEOF\n", ""),
    (b"0\n" * 100_000, ""),
]


@pytest.mark.parametrize(("data", "said"), DAMAGED, ids=range(len(DAMAGED)))
def test_a_damaged_drawing_is_one_line(
    tmp_path: Path, data: bytes, said: str, capfd: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("ezdxf")
    path = tmp_path / "damaged.dxf"
    path.write_bytes(data)
    line = said_of(path)
    assert line.startswith(f"{path}: ")
    assert said in line
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("header", ["", "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1015\n  0\nENDSEC\n"])
def test_a_drawing_without_a_unit_is_not_in_metres(tmp_path: Path, header: str) -> None:
    pytest.importorskip("ezdxf")
    path = tmp_path / "old.dxf"
    circle = "  0\nCIRCLE\n  8\n0\n 10\n1.0\n 20\n2.0\n 30\n0.0\n 40\n5.0\n"
    path.write_text(f"{header}  0\nSECTION\n  2\nENTITIES\n{circle}  0\nENDSEC\n  0\nEOF\n", encoding="utf-8")
    assert areas(read_outline(path, unit=MM)) == pytest.approx([25.0 * math.pi], rel=1e-4)
    assert said_of(path, unit=None).startswith("unit: is missing")


def test_every_cut_of_a_drawing_ends_in_one_line(draw: Draw) -> None:
    def things(space: Any) -> None:
        space.add_lwpolyline([(0, 0), (9, 0), (9, 9)], close=True)
        space.add_open_spline([(1, 1), (2, 1), (2, 2), (1, 1)])

    path = draw(things, version="R2000")
    data = path.read_bytes()
    chance = random.Random(1)
    for _ in range(6):
        path.write_bytes(data[: chance.randrange(len(data))])
        assert said_of(path, unit=None)
    for _ in range(12):
        place = data.rindex(b"ENTITIES") + chance.randrange(600)
        path.write_bytes(data[:place] + bytes([chance.randrange(1, 255)]) + data[place + 1 :])
        with contextlib.suppress(InputError):  # some bytes do no harm
            read_outline(path)


def test_a_huge_drawing_is_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "huge.dxf"
    with path.open("wb") as stream:
        stream.truncate(30_000_000)
    assert "is too large (30.0 MB); allowed are 20 MB" in said_of(path)


def test_without_ezdxf_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "ezdxf.filemanagement", None)
    path = tmp_path / "drawing.dxf"
    path.write_text("  0\nEOF\n", encoding="utf-8")
    assert "reading DXF needs ezdxf; install it with: pip install 'varistiff[dxf]'" in said_of(path)


@pytest.mark.parametrize("facets, cost", [(64, 0.0032), (256, 0.0002)])
def test_facets_cost_stiffness(tmp_path: Path, facets: int, cost: float) -> None:
    angles = [2.0 * math.pi * k / facets for k in range(facets)]
    rows = "".join(f"{11 * math.cos(a)!r},{11 * math.sin(a)!r}\n" for a in angles)
    found = Polygon(read_outline(csv_file(tmp_path, "x,y\n" + rows), unit=MM)).torsion_constant
    assert 1.0 - found / (0.5 * math.pi * 0.011**4) == pytest.approx(cost, rel=0.05)
