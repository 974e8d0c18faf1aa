#  SPDX-License-Identifier: GPL-3.0-or-later
"""The ground of a confirmed arena: its size, and the projective map from pixels
of the image to centimetres, origin in the lower left corner, y up."""

import math
import re
from typing import Any

_LINE = re.compile(
    rb"CARN:([1-9][0-9]{1,3});([1-9][0-9]{1,3});([0-9]{1,3})"
    + rb";(-?[0-9]{1,5}\.[0-9]{1,6})" * 8
)

Point = tuple[float, float]
Row = tuple[float, float, float]
#  Of the map: factors of x, of y and of 1

Fields = dict[str, Any]


def read(line: bytes) -> Fields | None:
    """Of the supervisor's answer; none if no arena is confirmed. Its margin is
    what a mission's points keep from the border, in centimetres."""
    found = _LINE.fullmatch(line)
    if found is None:
        return None
    width, height, margin, *numbers = (float(text) for text in found.groups())
    a, b, c, d = zip(numbers[::2], numbers[1::2], strict=True)
    #  Twice the area of each corner's triangle with its neighbours
    ta, tb, tc, td = _area(d, a, b), _area(a, b, c), _area(b, c, d), _area(c, d, a)
    if min(ta, tb, tc, td) <= 0:
        return None
    left, right, below = (
        _line(d, a, tb * tc),
        _line(b, c, ta * td),
        _line(c, d, ta * tb),
    )
    whole = [p + q for p, q in zip(left, right, strict=True)]
    rows = [width * v for v in left], [height * v for v in below], whole
    largest = max(abs(v) for v in whole)
    return {
        "size": [width, height],
        "margin": margin,
        "map": [[v / largest for v in row] for row in rows],
    }


def pose(ground: Fields, position: Fields) -> tuple[float, float, float] | None:
    """Centimetres, and the heading in degrees from the x axis to the left."""
    centre = _place(ground["map"], (position["x"], position["y"]))
    ahead = _place(ground["map"], (position["dx"], position["dy"]))
    if centre is None or ahead is None:
        return None
    turn = math.atan2(ahead[1] - centre[1], ahead[0] - centre[0])
    return *centre, math.degrees(turn)


def _place(rows: list[Row], p: Point) -> Point | None:
    x, y, whole = (r[0] * p[0] + r[1] * p[1] + r[2] for r in rows)
    return (x / whole, y / whole) if whole > 0 else None


def _line(p: Point, q: Point, weight: float) -> Row:
    """Of R: the area of P, Q and R, weighted."""
    x, y = q[0] - p[0], q[1] - p[1]
    return -weight * y, weight * x, weight * (y * p[0] - x * p[1])


def _area(p: Point, q: Point, r: Point) -> float:
    x, y, c = _line(p, q, 1)
    return x * r[0] + y * r[1] + c
