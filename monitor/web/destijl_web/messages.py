#  SPDX-License-Identifier: GPL-3.0-or-later
"""Messages from a page: parsed, and rejected if invalid."""

import json
from dataclasses import dataclass
from typing import Any, NoReturn

from .exchange import LABELS, MISSIONS, WITH_NUMBER, Point

MAX_SIZE = 4096
#  Bytes

LARGEST = 2**53
#  Of numbers returned to the page: JavaScript's integers

LARGEST_VALUE = 1_000_000
#  Of a distance or an angle; the supervisor clamps it

LARGEST_COORDINATE = 9_999
#  Of a mission's point: a line with 64 of them is still read

LONGEST_NAME = 30


class Malformed(Exception):
    """Not a message of the contract."""


@dataclass
class Ping:
    number: int
    hidden: bool


@dataclass
class Seen:
    pass


@dataclass
class Order:
    number: int
    label: str
    value: int | None
    points: tuple[Point, ...] = ()


@dataclass
class Wheel:
    what: str
    to: int | None


@dataclass
class Name:
    name: str


@dataclass
class Pupil:
    """What a teacher does to a viewer."""

    what: str
    to: int


Message = Ping | Seen | Order | Wheel | Name | Pupil


def read(text: str) -> Message:
    """Raises Malformed."""
    try:
        data = json.loads(text, parse_constant=_refuse)
    except (ValueError, RecursionError):
        raise Malformed("not JSON") from None
    if not isinstance(data, dict):
        raise Malformed("not an object")
    kind = data.get("type")
    if kind == "ping":
        hidden = data.get("hidden", False)
        if not isinstance(hidden, bool):
            raise Malformed("hidden is not a boolean")
        return Ping(_integer(data, "n", LARGEST), hidden)
    if kind == "seen":
        return Seen()
    if kind == "order":
        return _order(data)
    if kind == "wheel":
        return _wheel(data)
    if kind == "name":
        return Name(_name(data.get("name")))
    if kind == "pupil":
        what = data.get("do")
        if what not in ("mute", "unmute", "expel"):
            raise Malformed("unknown wish for a pupil")
        return Pupil(what, _integer(data, "to", LARGEST))
    raise Malformed("unknown type")


def _order(data: dict[str, Any]) -> Order:
    label = data.get("label")
    if not isinstance(label, str) or label not in LABELS:
        raise Malformed("unknown label")
    value = None
    if label in WITH_NUMBER:
        value = _integer(data, "value", LARGEST_VALUE)
    elif data.get("value") is not None:
        raise Malformed(f"{label} has no value")
    points = data.get("points")
    if label in MISSIONS:
        if not isinstance(points, list) or not 1 <= len(points) <= MISSIONS[label]:
            raise Malformed("too many points")
    elif points is not None:
        raise Malformed(f"{label} has no points")
    return Order(
        _integer(data, "id", LARGEST),
        label,
        value,
        tuple(_point(point) for point in points or ()),
    )


def _point(pair: object) -> Point:
    if isinstance(pair, list) and len(pair) == 2:
        x, y = pair
        if _is_coordinate(x) and _is_coordinate(y):
            return float(x), float(y)
    raise Malformed("not a point")


def _is_coordinate(value: Any) -> bool:
    return type(value) in (int, float) and abs(value) <= LARGEST_COORDINATE


def _wheel(data: dict[str, Any]) -> Wheel:
    what = data.get("do")
    if what in ("give", "decline", "offer"):
        return Wheel(what, _integer(data, "to", LARGEST))
    if what in ("take", "ask", "release", "seize", "withdraw"):
        return Wheel(what, None)
    raise Malformed("unknown wish for the wheel")


def _name(name: object) -> str:
    if isinstance(name, str):
        #  the mark of the gateway's own numbers
        name = name.replace("#", " ").strip()
        if 1 <= len(name) <= LONGEST_NAME and name.isprintable():
            return name
    raise Malformed("not a name")


def _integer(data: dict[str, Any], field: str, largest: int) -> int:
    value = data.get(field)
    if type(value) is not int or abs(value) > largest:
        raise Malformed(f"{field} is not an integer")
    return value


def _refuse(constant: str) -> NoReturn:
    raise ValueError(constant)
