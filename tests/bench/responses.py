#  SPDX-License-Identifier: GPL-3.0-or-later
"""The response times of the tasks, out of a file of --trace: from the release of each
activity of the response-time analysis to its end."""

import runpy
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from measurements import ROOT, WAY, Row, Wrong

LINE = "line_request", "line_answer", "line_outcome", "line_open"
LINE_TASKS = (
    "th_startRobotWD",
    "th_resetRobot",
    "th_openComRobot",
    "th_startRobot",
    "th_move",
    "th_batteryLevel",
)
#  Which use the robot's line for themselves

BY_THE_KERNEL = "th_server", "th_receiveFromMon", "th_comMonPerdue"
#  These are released by it

PARTS = {"mission_seen": "position", "mission_told": "done"}
#  Not called by the last word of the activity

SENDING = {
    "out RBLV": "send_battery",
    "out MPRG": "send_mission",
    "out MEND": "send_mission",
    "out CPOS": "send_position",
    "out CIMG": "send_image",
}
#  Any other message is an answer

PERIOD = 100_000.0
RESERVE = 0.12 * PERIOD
#  Of the images, in microseconds, without --fps; src/vision/vision-image_grid.ads


@dataclass
class Task:
    """What is known of it at one time. Times are in microseconds."""

    name: str
    activities: list[str]
    waiting: list[tuple[int, float]] = field(default_factory=list)
    """Releases by other tasks, with their commands (0: none), that no job has
    answered to yet."""
    due: float | None = None
    """The nominal instant that has just been passed."""
    ready: float = 0.0
    """When the last job ended, or the task found nothing to do."""
    depth: int = 0
    """1: in a job, 2: in a wait of it."""
    begun: float | None = None
    """The release of the activity under way, None between activities."""
    stopped: float = 0.0
    """The beginning of the wait under way."""
    timed: bool = False
    """The clock has begun the job."""
    taken: bool = False
    """The job is for a command."""
    waited: bool = False
    """The job has had a wait."""
    asking: bool = False
    """The wait under way is for the robot's answer."""
    answered: bool = False
    """The job has had such a wait."""
    sending: str = ""
    """What th_sendToMon has sent last."""

    def begin(self, now: float, command: int) -> None:
        """A job, or for th_sendToMon what may be the next message."""
        self.timed = self.due is not None
        self.taken = command > 0
        self.waited = self.answered = False
        self.sending = ""
        if self.due is not None:
            self.begun, self.due = self.due, None
        elif self.name in BY_THE_KERNEL:
            #  just then; a signal begins the session
            self.begun = None if self.waiting else now
        else:
            own = [
                release
                for release in self.waiting
                if release[0] == command and (command or self.name == "th_mission")
            ]
            self.begun = now
            if self.waiting:
                release = (own or self.waiting)[0]
                self.waiting.remove(release)
                self.begun = release[1]
                if self.name in (*LINE_TASKS, "th_mission"):
                    self.begun = max(self.begun, self.ready)
        #  a job that is for no command answers to all signals so far, and one for
        #  a command to its own and to those for none
        self.waiting = [r for r in self.waiting if command and r[0] not in (0, command)]

    def resume(self, now: float) -> None:
        self.waited = True
        self.answered = self.answered or self.asking
        if self.due is not None:
            self.begun, self.due = max(self.due, self.stopped), None
        elif not self.asking and self.waiting and self.waiting[-1][0] == 0:
            self.begun = max(self.waiting.pop()[1], self.stopped)
        else:
            self.begun = now

    def activity(self, last: bool) -> str:
        """Which one ends now. last: and with it its job. "": none of the analysis"""
        uses_line = self.name in LINE_TASKS
        match self.name:
            case "th_sendToMon":
                #  up to the gap, where there is one, nothing can be sent
                return self.sending if last else ""
            case "th_cameraControl" | "th_arene" if not self.taken:
                return ""  # another had its turn
            case "th_camera" if not self.waited:
                return ""  # it is opened
            case "th_stop" | "th_comMonPerdue" if self.waited:
                return ""  # for the end of all
            case "th_mission" if not self.answered and not self.waited:
                if self.taken:
                    return "mission_begin"
                return "mission_due" if self.timed else "mission_seen"
            case "th_mission":
                return "mission_told" if self.answered else "line_request"
        if self.answered:
            return "line_answer"
        if uses_line and not last:
            return "line_request"
        if (uses_line and not self.timed) or not self.activities:
            return ""  # without an exchange
        second = self.waited and last and len(self.activities) > 1
        return self.activities[second]


@dataclass
class Sight:
    """The way of an image to the order of a mission."""

    newest: float | None = None
    older: float | None = None
    """Images that came and were not taken, by their arrivals."""
    taken: float | None = None
    """The image that is searched."""
    seen: float | None = None
    """The one that th_mission has been woken for."""

    def take(self, now: float) -> None:
        """As Vision.Frames does."""
        self.taken = self.newest
        if (
            self.older is not None
            and self.newest is not None
            and now - self.newest < RESERVE
            and now - self.older <= PERIOD + RESERVE
            and self.newest - self.older > PERIOD / 2
        ):
            self.taken = self.older
        else:
            self.newest = None
        self.older = None

    def follow(
        self, tasks: list[Task], task: Task, phase: str, name: str, event: Row
    ) -> float | None:
        """Before the event is noted in tasks. The time from an image to the first byte
        of the order that followed from it, where this is the event."""
        at = task.name, phase, task.depth
        busy = [other.name for other in tasks if other.depth == 1]
        if at == ("th_camera", "E", 2):
            self.older, self.newest = self.newest, event["ts"]
        elif at == ("th_captureImg", "B", 0):
            self.take(event["ts"])
        elif at == ("th_mission", "E", 1):
            self.seen = None
        elif task.name == "th_mission" and name == "release":
            #  by the search; the line's releases are for the mission's command. An
            #  image that comes while the robot is asked does not count: what is
            #  ordered then follows from the answer
            if (
                not event.get("args")
                and "th_captureImg" in busy
                and not any(other in LINE_TASKS for other in busy)
            ):
                self.seen = self.taken if task.depth == 0 else None
        elif task.name == "th_mission" and name in ("robot M", "robot T"):
            seen, self.seen = self.seen, None
            return None if seen is None else float(event["ts"] - seen)
        return None


def read(
    path: str, activities: dict[str, str]
) -> tuple[dict[str, list[float]], list[float]]:
    """The times of each activity, whose tasks are given, and those from an image to
    the order of a mission."""
    with open(path, encoding="ascii") as file:
        convert: Any = runpy.run_path(str(ROOT / "script/trace"))["events"]
        events: list[Row] = [*convert(file)]
    tasks: dict[int, Task] = {}
    times: dict[str, list[float]] = {name: [] for name in activities}
    orders: list[float] = []
    sight = Sight()

    def end(task: Task, now: float, last: bool) -> None:
        name = task.activity(last)
        if task.begun is not None and name:
            times[name].append(round(now - task.begun, 3))
        task.begun = None

    for event in events:
        phase, name = event["ph"], event.get("name", "")
        if phase == "M":
            if name == "thread_name":
                who = event["args"]["name"]
                own = [name for name, task in activities.items() if task == who]
                tasks[event["tid"]] = Task(who, own)
            continue
        task, now = tasks[event["tid"]], event["ts"]
        command = event.get("args", {}).get("command", 0)
        order = sight.follow([*tasks.values()], task, phase, name, event)
        if order is not None:
            orders.append(round(order, 3))
        if phase == "B":
            task.depth += 1
            if task.depth == 1:
                task.begin(now, command)
            else:
                #  what lies between two exchanges of one transaction is of both
                #  activities: left out
                if not task.answered:
                    end(task, now, False)
                task.stopped = now
                task.asking = name == "wait for answer"
        elif phase == "E":
            task.depth -= 1
            if task.depth == 1:
                task.resume(now)
            else:
                end(task, now, True)
                task.ready = now
        elif name == "release":
            task.waiting.append((command, now))
        elif name == "due":
            task.due = now
        elif task.name == "th_sendToMon":
            task.sending = SENDING.get(name, "send_answer")
            end(task, now, True)
            task.begin(now, command)
    return times, orders


def title(activity: str, task: str) -> str:
    part = PARTS.get(activity, activity.rpartition("_")[2])
    return ("line" if activity in LINE else task) + (
        f", {part}" if "_" in activity else ""
    )


def responses(line: Row) -> Iterator[tuple[str, list[float], float]]:
    """What stands in the trace that the line tells of: of each activity what it is, its
    times and their bound, 0 where there is none; last that of orders of missions."""
    tasks = {name: task for name, task, _ in line["activities"]}
    times, orders = read(line["trace"], tasks)
    if line["missions"] and line["made"] and not orders:
        raise Wrong("no mission has ordered anything after an image")
    for name, task, bound in line["activities"]:
        yield title(name, task), times[name], bound
    yield WAY, orders, line["order"]
