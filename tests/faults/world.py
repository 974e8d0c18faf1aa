#  SPDX-License-Identifier: GPL-3.0-or-later
"""The test environment of a fault: one supervisor, one emulated robot with its arena
camera, one monitor that records its commands and the answers. Times are in seconds."""

from __future__ import annotations

import os
import random
import shutil
import socket
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntEnum
from pathlib import Path
from typing import Any

from client import Monitor
from ledger import ANSWERS, Ledger, Message, kind_of
from links import Link
from parties import LIMIT, PROGRAMS, Emulator, Supervisor, await_, fact
from standstills import TOO_LONG, Watch

#  Requirements
STOP_LIMIT = 0.2  # the robot is stopped so long after the loss of command
LOSS_LIMIT = 0.05  # F5: to detect a close or a reset
VANISHED_LIMIT = 5.0  # F5: to detect a vanished monitor
SILENCE_LIMIT = 0.9  # to detect that announced signs of life do not come
STALLED_LIMIT = 15.0  # a monitor that accepts nothing is lost after this time
RETURN_LIMIT = 1.0  # F6: from the detected loss to the admission of a new monitor
WATCHDOG_LIMIT = 3.6  # a robot with watchdog is stopped so long after a reload
NEWCOMER_TIME = 0.0012  # ten pending connections are served in ten times this
PROMPT = 0.3
#  The longest time of an order to the robot, a stop on a failing line: three
#  exchanges of 80 ms, and their bytes

#  Margins: several worlds share the processors, and neither load nor harness is under
#  test
NOISE = 0.5  # on all times above
ANSWER_LIMIT = 20.0
#  For all answers of a session: as many exchanges as may wait, some with time-outs,
#  and a camera that is slow to open
BUSY_LIMIT = 5.0  # the same on busy processors, without any other fault
LINE_ATTEMPTS = 5
#  For starting and moving the robot: on a loaded machine an answer of the emulated one
#  sometimes misses its 80 ms. Violations that depend only on such an answer are tested
#  again so often, if its line was late.
LINE_PAUSE = 0.2  # between two attempts, so that late answers arrive
SETTLE_LIMIT = 5.0  # after a session until descriptors and threads are as before
MEMORY_GROWTH = 24 * 1024
#  Kilobytes above those after the supervisor's first session with a camera: memory
#  pools of OpenCV and the C library grow in the first sessions. The limit for hundreds
#  of injections into the same supervisor.

LOOPBACK = "127.0.0.1"
CALM_WORDS = "RPIN RGST RGBT RLDW RPIN RGST nope MSSG:text"
ALL_WORDS = (
    f"{CALM_WORDS} RGFW RGBW RGLF RGRI RSTP RMOV:40 RTRN:-40 RMOV:0 RSTP RGFW"
    " ROPN RCLS RSOW RSWW RRST COPN CCLS CASA CACO CAIN CPCO CPST"
    " MGTO:320;240 MPCM:20;20;60;40 MABT"
)

Robot = IntEnum(
    "Robot", "CLOSED OPEN STARTED STARTED_WITH_WATCHDOG MOVING MOVING_WITH_WATCHDOG"
)
Camera = IntEnum("Camera", "CLOSED STREAMING WITH_POSITION ARENA_ASKED ARENA_KEPT")
Cause = IntEnum("Cause", "LATE_LINE STOPPED_MACHINE NOTHING_ELSE")
#  Possible causes of a violation other than the supervisor: a processor or a
#  pseudo-terminal that stood still, or processor time stolen by the host; neither for
#  violations such as two answers to one command

INVARIANTS = {
    "the supervisor lives": Cause.NOTHING_ELSE,
    "answered exactly once": Cause.NOTHING_ELSE,
    "the robot stands": Cause.STOPPED_MACHINE,
    "a new session works": Cause.LATE_LINE,
    "nothing leaks": Cause.NOTHING_ELSE,
}


class RobotSilent(Exception):
    """An answer ATIM where another was expected."""


@dataclass(frozen=True)
class Plan:
    """How its programs are started."""

    launcher: str = ""
    #  of the supervisor: lines of a shell that run "$@"; $here is the world's folder
    copied: bool = False
    #  a copy of the supervisor, for every user
    options: str = ""
    #  of the supervisor, besides those that connect the three
    emulator_options: str = ""
    camera: str = ""
    #  instead of the emulated one's
    terminal: bool = False
    #  the robot's line is a pseudo-terminal, not a socket
    through_link: bool = False
    #  the monitor is at the far end of a cable
    fresh: bool = False
    #  a new supervisor for every injection
    receive_buffer: int = 0
    #  of the monitor's socket, bytes; 0 leaves the system's
    log_is_read: bool = True
    #  False if the launcher removes its standard error: the checks do not use the log


@dataclass
class Figures:
    repeated: int = 0
    #  sessions repeated, because the robot's line was late
    interrupted: int = 0
    #  injections repeated, because the host had taken the processors
    stops: int = 0
    #  of a moving robot, after a close or a reset
    late_stops: int = 0
    #  of these, those that needed the margin
    slowest_stop: float = 0.0
    #  from the close to the stop order on the wire
    growth: int = 0
    #  kilobytes, of the supervisor's memory since its first session

    def add(self, other: Figures) -> None:
        """The counts; of the others the maximum."""
        for name in ("repeated", "interrupted", "stops", "late_stops"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        self.slowest_stop = max(self.slowest_stop, other.slowest_stop)
        self.growth = max(self.growth, other.growth)


def check(condition: bool, message: str) -> None:
    if not condition:
        raise AssertionError(message)


def check_within(taken: float, limit: float, what: str) -> None:
    check(taken <= limit, f"{what} took {ms(taken)}, allowed are {ms(limit)}")


def ms(span: float) -> str:
    return f"{span * 1000:.3f} ms"


def descriptors(process: int) -> set[int]:
    try:
        return {int(name) for name in os.listdir(f"/proc/{process}/fd")}
    except OSError:
        return set()


def free_port() -> int:
    with socket.create_server((LOOPBACK, 0)) as one:
        return int(one.getsockname()[1])


def listens(address: str, port: int) -> bool:
    try:
        socket.create_connection((address, port), 2.0).close()
    except OSError:
        return False
    return True


def is_movement(command: str) -> bool:
    return command[:1] in ("M", "T") and command[2:] not in ("", "0", "-0")


def is_stop(command: str) -> bool:
    return command in ("r", "z") or (
        command[:1] in ("M", "T") and not is_movement(command)
    )


@dataclass
class World:
    folder: Path
    watch: Watch
    supervisor_program: Path = PROGRAMS / "destijl"
    link: Link = field(default_factory=Link)
    #  of all worlds of this process, one after the other
    monitor: Monitor = field(default_factory=Monitor)
    #  commands must be sent by say, to be counted
    source: random.Random = field(default_factory=random.Random)
    #  of this injection: the source of all random values
    plan: Plan = field(default_factory=Plan)
    robot: Robot = Robot.CLOSED
    camera: Camera = Camera.CLOSED
    #  state of the session before the fault
    port: int = 0
    #  0: not built
    emulators: int = 0
    present: bool = False
    #  the monitor is connected

    def __post_init__(self) -> None:
        self.begin("", alone=True)

    def begin(self, source: str, alone: bool) -> None:
        """Before an injection."""
        self.source.seed(source)
        self.alone = alone
        #  no other fault is active: the session exists, and a fault may check
        #  requirements that only it can violate
        self.line_works = True
        #  False if a stop could not reach the robot: it is not checked
        self.robot_ready = True
        #  False if the robot must be power-cycled before it can be started again
        self.reachable = True
        #  False while no new monitor can be admitted: between inject and lift
        self.violations = 0
        self.cause = Cause.LATE_LINE
        #  the one with the fewest possible causes
        self.figures = Figures()
        self.account = ""
        #  what was violated, line by line
        self.remarks = ""
        #  the same for stops that needed the margin
        self.nobody_since = 0.0
        self.found_by = 0.0
        #  latest time for the detection of the monitor's loss

    #  Random values

    def whole(self, low: int, high: int) -> int:
        return self.source.randint(low, high)

    def chance(self, one_in: int) -> bool:
        return self.whole(1, one_in) == 1

    def any_of(self, words: str) -> str:
        return self.source.choice(words.split())

    def sleep(self, low: float, high: float) -> None:
        time.sleep(self.source.uniform(low, high))

    #  Building

    def build(self, plan: Plan) -> None:
        """Starts emulator and supervisor; a first session with all features; then
        records threads, descriptors and memory."""
        self.destroy()
        self.plan = plan
        if plan.through_link and not self.link.namespace:
            self.link.make()
        self.emulators += 1
        self.emulator = Emulator(
            self.folder / f"robot{self.emulators}",
            "link" if plan.terminal else "socket",
            *("--camera-fps", "12", "--frame-size", "320x240"),
            #  small ones: a dozen worlds share two processors; the supervisor takes
            #  ten a second
            *plan.emulator_options.split(),
        )
        self.expect_status("state", "idle")
        self.start_supervisor()

    def launcher(self) -> list[str]:
        if not self.plan.launcher:
            return []
        path = self.folder / "launcher"
        path.write_text(f"#!/bin/sh\nhere='{self.folder}'\n{self.plan.launcher}\n")
        path.chmod(0o755)
        return [str(path)]

    def program(self) -> Path:
        own = self.supervisor_program
        if not self.plan.copied:
            return own
        for path in (own, own.with_name("libdestijl_vision.so")):
            if not (self.folder / path.name).exists():
                shutil.copy(path, self.folder)
        return self.folder / own.name

    def start_supervisor(self) -> None:
        """A new supervisor with the same emulator, and its first session."""
        self.port = 0
        self.expected_end: int | None = None
        self.present = False
        port = 0 if self.plan.log_is_read else free_port()
        self.supervisor = Supervisor(
            self.emulator.line_at,
            *("--camera", self.plan.camera or self.emulator.camera),
            *("--frame-size", "320x240", "--log-level", "debug"),
            *("--bind", self.address, "--port", str(port), *self.plan.options.split()),
            launcher=self.launcher(),
            program=self.program(),
            listens=self.plan.log_is_read,
        )
        if not self.plan.log_is_read:
            self.until(
                lambda: listens(self.address, port), 10.0, "the supervisor listens"
            )
        self.port = port or self.supervisor.port
        #  with all features, so that all resources are allocated
        self.begin_session(Robot.MOVING, Camera.CLOSED)
        if self.plan.camera:
            #  OpenCV is loaded, at least
            self.order("COPN", "AACK ANAK")
        else:
            self.order("COPN")
            self.order("CPCO")
            self.talk(0.4, calm=True)
            self.expect_answers()
            self.order("CASA", "CIMG ANAK")
            self.say("CAIN")
            self.order("CPST")
        self.order("CCLS")
        self.lose("close")
        self.await_standing()
        self.join(RETURN_LIMIT + NOISE)
        self.lose("close")
        self._note_facts()

    def _facts(self) -> tuple[int, int]:
        """Threads and descriptors."""
        return fact(self.pid, "Threads"), len(descriptors(self.pid))

    def _note_facts(self) -> None:
        #  a second without a change: connections still closing are not counted
        end = time.monotonic() + SETTLE_LIMIT
        same, self.base = 0, (0, 0)
        while same < 50 and time.monotonic() < end:
            now = self._facts()
            same = same + 1 if now == self.base else 0
            self.base = now
            time.sleep(0.02)
        self.base_memory = fact(self.pid, "VmRSS")

    def expect_no_leaks(self) -> None:
        """Between two sessions."""
        try:
            await_(lambda: self._facts() == self.base, "", SETTLE_LIMIT)
        except AssertionError:
            self.violate(
                f"{self._facts()} threads and descriptors instead of {self.base}",
                "nothing leaks",
            )
        memory = fact(self.pid, "VmRSS")
        self.figures.growth = max(self.figures.growth, memory - self.base_memory)
        if self.figures.growth > MEMORY_GROWTH:
            self.violate(
                f"{memory} kB of memory, after {self.base_memory} kB in the beginning",
                "nothing leaks",
            )

    def destroy(self) -> None:
        self.monitor.close()
        self.present = False
        self.nobody_since = 0.0
        for child in ("supervisor", "emulator"):
            if hasattr(self, child):
                getattr(self, child).kill()
        self.port = 0

    @property
    def address(self) -> str:
        return self.link.supervisor_side if self.plan.through_link else LOOPBACK

    @property
    def pid(self) -> int:
        return self.supervisor.process.pid

    @property
    def lives(self) -> bool:
        return self.supervisor.process.poll() is None

    def exit_status(self) -> int:
        """Waits for the end: the exit status, or 128 + signal."""
        try:
            status = self.supervisor.process.wait(30.0)
        except subprocess.TimeoutExpired:
            raise AssertionError("the supervisor does not end") from None
        return status if status >= 0 else 128 - status

    #  The session

    def begin_session(self, robot: Robot, camera: Camera) -> None:
        """Connects a monitor and brings robot and camera into that state by
        commands."""
        self.robot = robot
        self.camera = camera
        if not self.present:
            self.join(RETURN_LIMIT + NOISE)
        self.bring_to(robot)
        if camera > Camera.CLOSED:
            self.order("COPN")
        if camera is Camera.WITH_POSITION:
            self.order("CPCO")
        elif camera >= Camera.ARENA_ASKED:
            self.order("CASA", "CIMG ANAK")
            if camera is Camera.ARENA_KEPT:
                self.say("CACO")

    def bring_to(self, robot: Robot) -> None:
        """By commands, from a closed line."""
        for attempt in range(1, LINE_ATTEMPTS + 1):
            try:
                if robot >= Robot.OPEN:
                    self._try_order("ROPN", "AACK")
                if robot >= Robot.STARTED:
                    without = robot in (Robot.STARTED, Robot.MOVING)
                    self._try_order("RSOW" if without else "RSWW", "AACK")
                if robot >= Robot.MOVING:
                    self._try_order(self.any_of("RGFW RGBW RGLF RGRI"), "AACK")
                    self.expect_status("moving", "1", RETURN_LIMIT)
                return
            except RobotSilent:
                self.figures.repeated += 1
                check(
                    attempt < LINE_ATTEMPTS,
                    "the robot's answers are late, again and again",
                )
                self.say("RCLS")
                self.expect_answers()
                time.sleep(LINE_PAUSE)

    def join(self, within: float) -> None:
        """Connects a monitor; retries while it is rejected."""
        self.await_standing()
        end = time.monotonic() + within
        while True:
            late = time.monotonic() > end
            self.ledger = Ledger()
            self.read = 0
            #  messages recorded in the ledger
            self.session_log = len(self.supervisor.lines)
            #  lines of the log before this session
            self.monitor.close()
            self.monitor = Monitor()
            try:
                self.monitor.connect(
                    self.port,
                    self.address,
                    self.plan.receive_buffer,
                    self.link.namespace if self.plan.through_link else "",
                )
            except AssertionError:
                if late:
                    raise
            else:
                self.present = True
                self.nobody_since = 0.0
                #  a rejected client gets a message, an admitted one an answer
                self.say("MSSG:hello", "silent")
                self.say("nope", "refused")
                while self.present and time.monotonic() < end + RETURN_LIMIT:
                    if self.ledger.complete or self.ledger.breach:
                        return
                    time.sleep(0.001)
                    self.listen()
            self.present = False
            check(not late, f"no monitor is admitted within {ms(within)}")
            time.sleep(0.02)

    def try_to_join(self) -> None:
        """The same during a fault: gives up soon if it is not admitted."""
        if not self.present and self.reachable and self.expected_end is None:
            try:
                self.join(RETURN_LIMIT)
            except AssertionError:
                self.monitor.close()

    def _take(self) -> Message | None:
        """The next message, which the ledger has, too. If there is none and the
        connection is closed, the session has ended."""
        if not self.present:
            return None
        was_closed = self.monitor.closed()
        if self.read < len(self.monitor.messages):
            item = self.monitor.messages[self.read]
            self.read += 1
            self.ledger.put_message(item)
            return item
        if was_closed:
            self._forget_session()
            if not self.nobody_since:
                self.nobody_in_command()
        return None

    def listen(self) -> None:
        """Records received messages in the ledger."""
        while self._take():
            pass

    def say(self, line: str, kind: str = "") -> None:
        """Sends it and does not wait. kind: of its answer, "" for that of a
        well-formed command. No effect if no monitor is connected; if the connection
        turns out to be closed, the monitor is no longer present."""
        self.listen()
        if self.present:
            self.ledger.put_command(line, kind or kind_of(line))
            self.say_bytes(line + "\n")

    def say_bytes(self, text: str) -> None:
        """Sent unchanged and not counted: such as part of a line. Must be followed by
        say with the line's end."""
        if self.present and not self.monitor.send(text.encode("latin-1")):
            self.listen()
            if self.present:
                self._forget_session()

    def until(
        self,
        condition: Callable[[], Any],
        within: float,
        what: str | Callable[[], str],
        since: float = 0.0,
        every: float = 0.005,
    ) -> None:
        """Listens until it is so, within that time of since, or of now."""

        def heard() -> Any:
            self.listen()
            return condition()

        left = within + since - time.monotonic() if since else within
        await_(heard, what, left, every)

    def expect_answers(self, within: float = ANSWER_LIMIT) -> None:
        """Waits until all commands are answered."""
        self.until(
            lambda: not self.present or self.ledger.complete or self.ledger.breach,
            within,
            lambda: (
                f"an answer to {self.ledger.first_waiting}, and to all of the"
                f" {self.ledger.waiting} since"
            ),
            every=0.001,
        )

    def _answers(self, command: str) -> Any:
        """Messages, of which the last ones complete the ledger; None after each look
        that found none."""
        self.expect_answers()
        self.say(command)
        while True:
            item = self._take()
            check(
                not self.ledger.breach,
                f"not answered exactly once: {self.ledger.breach}",
            )
            check(self.present, f"no session any more for {command}")
            if item is None:
                yield None
                time.sleep(0.001)
            elif self.ledger.complete:
                yield item

    def asked(self, command: str) -> tuple[Message, float]:
        """Sends command, when all before it is answered: the answer, and how long it
        took."""
        self.expect_answers()
        start = time.monotonic()
        for item in self._answers(command):
            if item:
                return item, item.time - start
            check(time.monotonic() <= start + ANSWER_LIMIT, f"no answer to {command}")
        raise AssertionError(command)

    def _try_order(self, command: str, answers: str) -> None:
        end = time.monotonic() + ANSWER_LIMIT
        timed_out = False
        for item in self._answers(command):
            if item is None:
                if time.monotonic() > end:
                    if timed_out:
                        raise RobotSilent
                    raise AssertionError(f"no answer to {command}")
            elif item.label in answers:
                return
            elif item.label == "ATIM":
                if not timed_out:
                    #  it may have been the unsolicited one
                    timed_out = True
                    end = time.monotonic() + 0.3
            elif item.label in ANSWERS[kind_of(command)]:
                if item.label == "ANAK" and self.times_lost > 0:
                    raise RobotSilent
                raise AssertionError(
                    f"{command} was answered {item.label} instead of {answers}"
                )

    def order(self, command: str, answers: str = "AACK") -> None:
        """Says command and waits for one of these."""
        try:
            self._try_order(command, answers)
        except RobotSilent:
            raise AssertionError(
                f"{command} had no answer from the robot instead of {answers}"
            ) from None

    def talk(self, for_time: float, calm: bool = False) -> None:
        """Random commands at random times, without waiting. calm: only those that do
        not change robot and camera."""
        end = time.monotonic() + for_time
        while True:
            self.say(self.any_of(CALM_WORDS if calm else ALL_WORDS))
            left = end - time.monotonic()
            if left <= 0.0:
                return
            time.sleep(min(left, self.source.uniform(0.005, 0.1)))

    def talk_some(self, low: float, high: float, calm: bool = False) -> None:
        self.talk(self.source.uniform(low, high), calm)

    #  The end of the session

    @property
    def times_lost(self) -> int:
        """How often the log says so of the robot, in this session."""
        return sum("robot lost" in x for x in self.supervisor.lines[self.session_log :])

    def _forget_session(self) -> None:
        self.present = False
        if self.ledger.breach:
            self.violate(self.ledger.breach, "answered exactly once")
        elif self.plan.log_is_read:
            #  the log may be behind: it is written by a task of the lowest priority
            unasked = self.ledger.unasked_losses
            try:
                await_(lambda: unasked <= self.times_lost, "", SETTLE_LIMIT)
            except AssertionError:
                self.violate(
                    f"{unasked} ATIM came unasked, but the robot was lost"
                    f" {self.times_lost} times",
                    "answered exactly once",
                )

    def lose(self, how: str, detection: float = LOSS_LIMIT) -> None:
        """The monitor is gone from now on: "close", "reset", or "silent": the
        connection stays open, but no longer belongs to the session (a cable was cut).
        detection: the time for the supervisor to detect it."""
        self.listen()
        if self.present:
            self._forget_session()
            if how != "silent":
                self.monitor.close(abortive=how == "reset")
            self.nobody_in_command(within=detection + STOP_LIMIT)
            self.found_by = time.monotonic() + detection

    def nobody_in_command(self, since: float = 0.0, within: float = STOP_LIMIT) -> None:
        """The robot must be stopped so long after since (0: now), plus a margin:
        checked after the fault. Implied by lose, and by a close of the connection by
        the supervisor."""
        self.nobody_since = since or time.monotonic()
        self.nobody_limit = within
        self.stop_counted = False

    def await_standing(self) -> None:
        """The robot stands, when nobody is in command. May be repeated: it also
        detects a later movement."""
        since = self.nobody_since
        if not since or not self.line_works:
            self.nobody_since = 0.0
            return
        limit = since + self.nobody_limit + NOISE
        patience = 3.0
        #  only to report the delay

        def after(then: float) -> str:
            return (
                f"{ms(then - since)} after nobody is in command; the machine stood"
                f" still for {ms(self.watch.within(since, then))}"
            )

        while self.emulator.moving:
            now = time.monotonic()
            if now > limit + patience:
                self.violate(f"it still moves, {after(now)}", "the robot stands")
                self.nobody_since = 0.0
                return
            time.sleep(0.01)
        late = time.monotonic() > limit
        stop, moved = 0.0, False
        for item in self.emulator.journal():
            if is_movement(item.command):
                stop, moved = 0.0, True
                if item.first > limit + self.watch.within(since, item.first):
                    self.violate(
                        f"{item.command} on the wire {after(item.first)}",
                        "the robot stands",
                    )
            elif not stop and is_stop(item.command):
                stop = item.last
        usual = self.nobody_limit <= STOP_LIMIT + LOSS_LIMIT
        if usual and moved and stop > since and not self.stop_counted:
            self.stop_counted = True
            self.figures.stops += 1
            if stop - since > self.nobody_limit:
                self.figures.late_stops += 1
                self.remarks += f"   it stood {after(stop)}; at the robot:\n"
                self.remarks += self.wire_tail()
            self.figures.slowest_stop = max(self.figures.slowest_stop, stop - since)
        if late and stop > limit + self.watch.within(since, stop):
            self.violate(f"it stood only {after(stop)}", "the robot stands")
            self.nobody_since = 0.0

    def wire_tail(self) -> str:
        """The last commands received by the robot, with their times: lines."""
        now = time.monotonic()
        return "".join(
            f"   {ms(item.last - now)} {item.command} -> {item.answer}\n"
            for item in self.emulator.journal()[-12:]
        )

    #  Demands

    def expect_status(self, key: str, value: str, within: float = LIMIT) -> None:
        """The emulator's."""
        await_(
            lambda: self.emulator.status()[key] == value,
            f"the robot's {key} is {value}",
            within,
            every=0.005,
        )

    def expect_log(self, text: str, within: float, after: int = 0) -> None:
        check(
            self.supervisor.says(text, within, after),
            f"in {ms(within)} the log does not say {text}",
        )

    def tell(self, command: str) -> None:
        """The emulator."""
        said = self.emulator.ask(command)
        check(said.startswith("ok"), f"the emulator answers {command} with {said}")

    #  Findings

    @property
    def line_was_late(self) -> bool:
        """Or what serves it; since the watch forgot."""
        line = self.watch.longest_line if self.plan.terminal else 0.0
        return max(self.watch.longest, line) >= TOO_LONG

    def violate(
        self, text: str, invariant: str = "", by: Cause = Cause.LATE_LINE
    ) -> None:
        """invariant: "" for a requirement of the fault itself, and by its cause."""
        self.violations += 1
        if invariant:
            text, by = f"{invariant}: {text}", INVARIANTS[invariant]
        self.cause = max(self.cause, by)
        self.account += f"   {text.strip()}\n"
