#  SPDX-License-Identifier: GPL-3.0-or-later
"""The state shown to every viewer: links, robot, camera, who drives."""

from collections.abc import Sequence
from typing import Any

from .exchange import Point

Fields = dict[str, Any]

_NEW_SESSION: Fields = {
    "robot": "closed",
    "watchdog": False,
    "camera": False,
    "camera_failed": False,
    "positions": False,
    "arena": "none",
    "ground": None,
    "battery": -1,
    "version": "",
    "mission": None,
}
#  The state at the beginning of a session with the supervisor


_ASKING = ("RSOW", "RSWW", "RRST", "RPIN", "RGBT", "RVER", "RGST")
#  Whoever does not answer these may be switched off


class State:
    def __init__(self) -> None:
        self._fields: Fields = {
            "supervisor": "connecting",
            **_NEW_SESSION,
            "driver": None,
            "asking": [],
            "offered": None,
            "viewers": [],
            "recording": None,
        }
        self._changes: Fields = {}

    def __getitem__(self, name: str) -> Any:
        return self._fields[name]

    def set(self, **fields: Any) -> None:
        for name, value in fields.items():
            if self._fields[name] != value:
                self._fields[name] = value
                self._changes[name] = value

    def all(self) -> Fields:
        return dict(self._fields)

    def take_changes(self) -> Fields:
        """What changed since the last call."""
        changes = self._changes
        self._changes = {}
        return changes

    def begin_session(self) -> None:
        self.set(**_NEW_SESSION)

    def answered(self, label: str, answer: str) -> None:
        """A command was answered, or sent if it has no answer."""
        done = answer == "AACK"
        if self["robot"] in ("open", "off") and label in _ASKING:
            if answer == "ATIM":
                self.set(robot="off")
            elif answer != "ANAK":
                self.set(robot="open")
        if label == "ROPN":
            if done and self["robot"] in ("closed", "lost"):
                self.set(robot="open", watchdog=False, version="")
        elif label == "RVER":
            if answer.startswith("RVER:"):
                self.set(version=answer[5:])
        elif label == "RCLS":
            if done:
                self.set(robot="closed", watchdog=False)
        elif label in ("RSOW", "RSWW"):
            if done:
                self.set(robot="started", watchdog=label == "RSWW")
        elif label == "RRST":
            #  a reset is refused only if the robot is not running
            if answer in ("AACK", "ACRJ"):
                self.set(robot="open", watchdog=False)
        elif label == "RPOF":
            if done:
                self.set(robot="off", watchdog=False)
        elif label == "COPN":
            if done and not self["camera"]:
                self.camera_closed()
                self.set(camera=True)
        elif label == "CCLS":
            if done:
                self.camera_closed()
        elif label == "CASA":
            if answer == "CIMG":
                self.set(arena="found", ground=None)
        elif label in ("CACO", "CAIN"):
            if self["arena"] == "found":
                self.set(arena="confirmed" if label == "CACO" else "none")
        elif label in ("CPCO", "CPST") and done:
            self.set(positions=label == "CPCO")

    def mission_began(self, unit: str, points: Sequence[Point]) -> None:
        self.set(
            mission={
                "unit": unit,
                "points": [list(point) for point in points],
                "leg": 1,
                "of": len(points),
                "distance": None,
            }
        )

    def mission_went_on(self, leg: int, distance: int) -> None:
        """Distance in mm to the leg's point."""
        if self["mission"] is not None:
            self.set(mission={**self["mission"], "leg": leg, "distance": distance})

    def mission_ended(self) -> None:
        self.set(mission=None)

    def camera_closed(self, failed: bool = False) -> None:
        self.set(camera=False, camera_failed=failed, positions=False)
        self.set(arena="none", ground=None)

    def robot_lost(self) -> None:
        self.set(robot="lost", watchdog=False)

    def robot_stopped_running(self) -> None:
        if self["robot"] == "started":
            self.set(robot="open", watchdog=False)
