"""Draw docs/images/roller_beam.png: mechanism and characteristic of the roller beam example, side by side.

Run ``python tools/readme_picture.py`` after a change of the figures.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from PIL import Image

import varistiff

ROOT = Path(__file__).parents[1]
HEIGHT = 620


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "roller_beam"
        varistiff.analyse(ROOT / "examples/roller_beam.yaml", output)
        pictures = []
        for name in ("mechanism", "load_deflection"):
            with Image.open(output / "figures" / f"{name}.png") as picture:
                size = (round(picture.width * HEIGHT / picture.height), HEIGHT)
                pictures.append(picture.convert("RGB").resize(size, Image.Resampling.LANCZOS))
    both = Image.new("RGB", (sum(p.width for p in pictures) + 40, HEIGHT), "white")
    left = 0
    for picture in pictures:
        both.paste(picture, (left, 0))
        left += picture.width + 40
    target = ROOT / "docs/images/roller_beam.png"
    both.quantize(128).save(target, optimize=True)
    print(target.relative_to(ROOT))


if __name__ == "__main__":
    main()
