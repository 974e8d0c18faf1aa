#  SPDX-License-Identifier: GPL-3.0-or-later
"""The deadlines from end to end, out of what was sent and seen at both ends in sessions
of a monitor. Times are in nanoseconds."""

from collections.abc import Iterator

from measurements import Row

FIRST = "F2 connection to the first answer"
OWN = "F4 command to the supervisor's own answer"
ROBOT = "F4 robot's answer to the monitor's"
LOST = "F6 loss of the monitor to the stop's last byte"
RELOAD = "F11 reload due to its first byte"
FIRST_BYTE = "F12 order to first byte, line free"
LAST_BYTE = "F12 order to last byte, all of them"
LEVEL = "F13 battery level due to its message"
IMAGE = "F15 from image to image"

DEMANDS = {
    FIRST: ("f2_admitted", "f4_own_answer"),
    OWN: ("f4_own_answer",),
    ROBOT: ("f4_robot_answer",),
    LOST: ("f6_stop",),
    RELOAD: ("f11_reload",),
    FIRST_BYTE: ("f12_first_byte",),
    LAST_BYTE: ("f12_at_robot",),
    LEVEL: ("f13_level",),
    IMAGE: (),
}
#  What the analysis calls them; the first one says of how many it is demanded

MS = 1_000_000
BYTE = 1_041_000
#  On the line at 9600 baud
FRAME_END = 2
#  The checksum and the end of an answer, in bytes
RELOAD_PERIOD = 1000 * MS
BATTERY_OFFSET, BATTERY_PERIOD = 250 * MS, 500 * MS
LINE_REST = MS
#  How long who has the line may take after an exchange before it is free again

BROKEN = "sessions that broke off"
ROBOTS = "sessions in which the robot was lost"
STOPS = "stops after a loss that did not come"
RELOADS = "reloads that did not come"
LEVELS = "battery levels that did not come"

KEPT = BROKEN, STOPS, RELOADS, LEVELS
#  None of these may be, for --check

Stalls = list[tuple[int, int]]
Spans = list[tuple[str, int, int]]


def stood_still(stalls: Stalls, begin: int, end: int) -> int:
    """For how much of that time a processor, or a byte, may have stood still."""
    total = 0
    for first, last in sorted(stalls):
        if last > begin and first < end:
            total += min(last, end) - max(first, begin)
            begin = last
    return total


class Sessions:
    def __init__(self, notes: list[str]) -> None:
        self.notes = notes
        self.number = 0
        self.counts = dict.fromkeys((BROKEN, ROBOTS, STOPS, RELOADS, LEVELS), 0)
        self.demands: dict[str, Row] = {}
        self.times: dict[str, list[tuple[int, int]]] = {name: [] for name in DEMANDS}
        #  And for how much of each something stood still

    def add(self, line: Row) -> None:
        """A demand, a session, or why there is none."""
        if "demand" in line:
            self.demands[line["demand"]] = line
            return
        self.number += 1
        if self.number % 20 == 0:
            print(f"   {self.number} sessions", flush=True)
        spans: Spans = []
        broken = line.get("broken") or self.look_at(line, spans)
        if broken:
            self.counts[BROKEN] += 1
            self.notes.append(f"session {self.number}: {broken}")
            return
        for name, begin, end in spans:
            stood = stood_still(line["stalls"], begin, end)
            self.times[name].append((end - begin, stood))

    def look_at(self, session: Row, spans: Spans) -> str:
        """Why it has broken off; "" if it has not."""
        for sent, answered, label, command in session["lost"]:
            self.counts[ROBOTS] += 1
            stood = stood_still(session["stalls"], sent, answered) / MS
            self.notes.append(
                f"session {self.number}: {command} answered by {label}, of "
                f"{(answered - sent) / MS:.3f} ms stood still: {stood:.3f} ms"
            )
        spans.append((FIRST, session["begun"], session["answered"]))
        spans += [(OWN, sent, end) for sent, end, wire in session["sent"] if not wire]
        start = self.look_at_line(session, spans)
        if start is None:
            return "no start on the line"
        if not session["lost"] and not self.look_at_messages(session, start, spans):
            return "no battery level"
        return ""

    def look_at_line(self, session: Row, spans: Spans) -> int | None:
        """When the robot's answer to the start had come."""
        start = None
        sent = [order for order in session["sent"] if order[2]]
        lost = session["left"]
        free = 0
        #  when the line was, after the exchange before
        stopped = False
        reloads = 0
        for first, last, command, size in session["line"]:
            answer = last + (size + FRAME_END) * BYTE
            while sent and sent[0][1] < first:
                del sent[0]
            if sent and sent[0][2] == command and sent[0][0] < first:
                when, answered, _ = sent.pop(0)
                if command != "b":
                    spans.append((LAST_BYTE, when, last))
                    if free + LINE_REST < when:
                        spans.append((FIRST_BYTE, when, first))
                spans.append((ROBOT, answer, answered))
            elif command == "W":
                start = answer
            elif command == "w" and first < lost and (not session["lost"] or sent):
                reloads += 1
                turn = round((first - (start or 0)) / RELOAD_PERIOD)
                due = (start or 0) + turn * RELOAD_PERIOD
                spans.append((RELOAD, min(due, first), max(due, first)))
            elif (
                command == "M=0"
                and first >= lost
                and not session["lost"]
                and not stopped
            ):
                stopped = True
                spans.append((LOST, lost, last))
            free = answer
        if start is not None and not session["lost"]:
            self.counts[STOPS] += not stopped
            #  those that were due, but for one that may be on its way
            due = round(max(0, (lost - start) / RELOAD_PERIOD - 0.55))
            self.counts[RELOADS] += max(0, due - reloads)
        return start

    def look_at_messages(self, session: Row, start: int, spans: Spans) -> bool:
        """Whether there was a battery level."""
        due: int | None = None
        before: int | None = None
        for when, label in session["seen"]:
            if label == "CIMG":
                if before is not None:
                    spans.append((IMAGE, before, when))
                before = when
            elif label == "RBLV":
                if due is None:
                    past = (when - start - BATTERY_OFFSET) // BATTERY_PERIOD
                    due = start + BATTERY_OFFSET + int(past) * BATTERY_PERIOD
                else:
                    due += BATTERY_PERIOD
                spans.append((LEVEL, due, when))
                while due + 2 * BATTERY_PERIOD <= when:
                    #  the next one is this one's
                    self.counts[LEVELS] += 1
                    due += BATTERY_PERIOD
        while due is not None and due + 2 * BATTERY_PERIOD < session["seen"][-1][0]:
            self.counts[LEVELS] += 1
            due += BATTERY_PERIOD
        return due is not None

    def rows(self) -> Iterator[tuple[str, list[float], Row, dict[str, float]]]:
        """Of each deadline its name, its times in microseconds, more figures, and the
        most of some."""
        for name, times in self.times.items():
            more: Row = {}
            demands = [self.demands[demand] for demand in DEMANDS[name]]
            for key, excess in ("bound", "longer"), ("limit", "missed"):
                most = sum(demand[key] for demand in demands)
                if most > 0:
                    more[key] = most
                    more[excess] = sum(time > 1000 * most for time, _ in times)
                    more[excess + "_ran"] = sum(t - s > 1000 * most for t, s in times)
            goals: dict[str, float] = {}
            if "limit" in more:
                every = demands[0]["every"]
                goals = {"missed_ran": 0} if every else {"p999": more["limit"]}
            yield name, [time / 1000 for time, _ in times], more, goals
