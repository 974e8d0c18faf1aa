#  SPDX-License-Identifier: GPL-3.0-or-later
"""Matches answers to commands.

The supervisor answers each command that has an answer once, in their order.
Battery levels, images and the loss of the robot come unasked too: they are
answers to what asks for them only."""

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

STARTS = frozenset(("ROPN", "RCLS", "RSOW", "RSWW", "RRST", "RPOF"))
DRIVES = frozenset(("RGFW", "RGBW", "RGLF", "RGRI", "RSTP", "RMOV", "RTRN"))
STOPS = frozenset(("RSTP", "MABT"))
#  The second one, from a mission's user: the same order to the supervisor

ROBOT = STARTS | DRIVES | STOPS | {"RPIN", "RGBT", "RVER", "RGST"}
CAMERA = frozenset(("COPN", "CCLS", "CASA", "CACO", "CAIN", "CARN", "CPCO", "CPST"))
WITH_NUMBER = frozenset(("RMOV", "RTRN"))
MISSIONS = {"MGTO": 1, "MPTH": 64, "MGCM": 1, "MPCM": 64}
#  With the points that each may have, in pixels of the image or, CM, in
#  centimetres of the arena; sent in tenths: a line of the supervisor has 1024
#  characters

LABELS = (ROBOT | CAMERA | MISSIONS.keys()) - {"CARN"}
#  Of orders from a page

UNANSWERED = frozenset(("CACO", "CAIN"))

ROBOT_LIMIT = 5.0
CAMERA_LIMIT = 15.0
#  Seconds for an answer, from the command's turn. A camera opened by its URL
#  takes up to 5 s.


Point = tuple[float, float]


@dataclass(eq=False)
class Command:
    label: str
    value: int | None = None
    done: list[Callable[[str, float], None]] = field(default_factory=list)
    #  Each called with the answer and the milliseconds it took
    sent_at: float = 0.0
    points: tuple[Point, ...] = ()

    def line(self) -> bytes:
        text = self.label
        if self.value is not None:
            text += f":{self.value}"
        elif self.points:
            text += ":" + ";".join(f"{x:.1f};{y:.1f}" for x, y in self.points)
        return text.encode("ascii") + b"\n"


class Exchange:
    """The commands that wait for their answers."""

    def __init__(self) -> None:
        self._waiting: deque[Command] = deque()
        self._turn_began = 0.0

    def __len__(self) -> int:
        return len(self._waiting)

    def is_waiting(self, label: str) -> bool:
        return any(c.label == label for c in self._waiting)

    def stops_at_end(self) -> int:
        """How many of the last commands are stops."""
        count = 0
        for command in reversed(self._waiting):
            if command.label not in STOPS:
                break
            count += 1
        return count

    def last(self) -> Command:
        return self._waiting[-1]

    def sent(self, command: Command, now: float) -> list[Command]:
        """Command waits from now on. Returns it if it has no answer and none
        waits before it."""
        command.sent_at = now
        if not self._waiting:
            if command.label in UNANSWERED:
                return [command]
            self._turn_began = now
        self._waiting.append(command)
        return []

    def match(self, line: bytes, begun_at: float, now: float) -> list[Command]:
        """The command that line, whose first byte came at begun_at, answers,
        and those after it that have no answer: empty if there is none."""
        if not self._waiting or not _can_answer(line, begun_at, self._waiting[0]):
            return []
        settled = [self._waiting.popleft()]
        while self._waiting and self._waiting[0].label in UNANSWERED:
            settled.append(self._waiting.popleft())
        self._turn_began = now
        return settled

    def overdue(self, now: float) -> Command | None:
        """The command whose answer is late."""
        if not self._waiting:
            return None
        first = self._waiting[0]
        limit = CAMERA_LIMIT if first.label in CAMERA else ROBOT_LIMIT
        return first if now - self._turn_began > limit else None

    def give_up(self) -> list[Command]:
        """Removes and returns all that wait."""
        given_up = list(self._waiting)
        self._waiting.clear()
        return given_up


def _can_answer(line: bytes, begun_at: float, command: Command) -> bool:
    label = line[:4]
    if label in (b"AACK", b"ANAK", b"ACRJ", b"ACER"):
        return len(line) == 4
    if label == b"ATIM":
        return len(line) == 4 and command.label in ROBOT
    if label == b"RBLV":
        return command.label == "RGBT"
    if label == b"RVER":
        return command.label == "RVER"
    if label == b"RCST":
        return command.label == "RGST"
    if label == b"CARN":
        return command.label == "CARN"
    if label == b"CIMG":
        #  An image in transit before the arena order is no answer
        return command.label == "CASA" and begun_at >= command.sent_at
    return False
