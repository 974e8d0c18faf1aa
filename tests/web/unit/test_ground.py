#  SPDX-License-Identifier: GPL-3.0-or-later
"""The ground of a confirmed arena."""

import pytest
from destijl_web import ground
from helpers import GROUND

Numbers = tuple[float, ...]


def at(x: float, y: float, dx: float = 1.0, dy: float = 0.0) -> Numbers:
    fields = ground.read(GROUND)
    assert fields is not None
    pose = ground.pose(fields, {"x": x, "y": y, "dx": x + dx, "dy": y + dy})
    assert pose is not None
    return pose


@pytest.mark.parametrize(
    ("pixel", "place"),
    [
        *(((100, 50), (0, 60)), ((540, 60), (80, 60))),
        *(((600, 420), (80, 0)), ((40, 400), (0, 0))),
    ],
)
def test_corners(pixel: Numbers, place: Numbers) -> None:
    assert at(*pixel)[:2] == pytest.approx(place, abs=1e-6)


def test_straight_lines_stay_straight() -> None:
    """What is between two points of the image is between their places."""
    a, b, c = (at(x, 200 + x / 4) for x in (200.0, 300.0, 500.0))
    assert (b[0] - a[0]) * (c[1] - a[1]) == pytest.approx((b[1] - a[1]) * (c[0] - a[0]))


def test_heading() -> None:
    """From the left border to the right one, and up."""
    assert at(70, 225, dx=500, dy=15)[2] == pytest.approx(0, abs=1)
    assert at(320, 400, dy=-300)[2] == pytest.approx(90, abs=3)


@pytest.mark.parametrize(
    "line",
    [
        *(b"ANAK", b"ACER", b"CARN:", GROUND[:-1] + b"x", GROUND + b";1"),
        b"CARN:80;60;8" + b";1.0" * 8,
        b"CARN:80;60;8;1.0;1.0;1.0;9.0;9.0;9.0;9.0;1.0",
    ],
)
def test_no_ground(line: bytes) -> None:
    """Also of corners in a line, or the wrong way round."""
    assert ground.read(line) is None
