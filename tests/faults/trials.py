#  SPDX-License-Identifier: GPL-3.0-or-later
"""One injection: a session in a random state, one or two faults at random times, and
afterwards the five invariants."""

import time
from dataclasses import dataclass, field

import camera_faults
import machine_faults
import network_faults
import robot_faults
from faults import Ends, Fault
from links import Skipped
from standstills import host_taken
from world import (
    LINE_ATTEMPTS,
    NOISE,
    RETURN_LIMIT,
    Camera,
    Cause,
    Figures,
    Plan,
    Robot,
    World,
    check_within,
)

ALL = [
    *network_faults.FAULTS,
    *robot_faults.FAULTS,
    *camera_faults.FAULTS,
    *machine_faults.FAULTS,
]
#  In the order of the table

HOST_GRANT = 0.1
#  Of processor time stolen by the host of a virtual machine during an injection. Above
#  that, violations of time limits only are tested again, as no program can meet them.
#  Double answers, leaks and crashes always count.
HOST_ATTEMPTS = 12
END_LIMIT = 2.0
#  For a supervisor that ends: it has 0.8 s for an orderly stop
IMAGES_LIMIT = 5.0
#  For the first image of a camera
DRIVE_LIMIT = 2.0
#  For the robot to stand after RSTP; how fast that is, is measured elsewhere

Injected = tuple[Fault, ...]
#  One, or two of them


@dataclass
class Result:
    end: str = "held"
    #  or "violated", "impossible": this machine does not permit it
    figures: Figures = field(default_factory=Figures)
    account: str = ""
    #  the violations with the state of the world, or why it is impossible; lines


def name_of(faults: Injected) -> str:
    return " + ".join(fault.name for fault in faults)


def plan_of(faults: Injected, terminal: bool = False) -> Plan:
    wanted: dict[str, object] = {"terminal": terminal}
    for fault in faults:
        wanted |= fault.plan
    return Plan(**wanted)  # type: ignore[arg-type]


class Trials:
    """In the world of this process, which is rebuilt if it does not match."""

    def __init__(self, world: World, kept: bool = False) -> None:
        """kept: its supervisor lives on after a violation, for a soak test, which uses
        it in between."""
        self.world = world
        self._kept = kept
        if kept:
            world.build(Plan(terminal=True))

    def run(self, faults: Injected, seed: int, repetition: int) -> Result:
        w = self.world
        repeated = interrupted = 0
        excused = ""
        #  what was violated in those that were made again
        while True:
            w.watch.forget()
            taken = host_taken()
            result = self._run_once(faults, f"{seed} {name_of(faults)} {repetition}")
            late = w.cause is Cause.LATE_LINE and w.line_was_late
            stopped = (
                w.cause <= Cause.STOPPED_MACHINE and host_taken() - taken >= HOST_GRANT
            )
            if (
                result.end != "violated"
                or not (late or stopped)
                or repeated == LINE_ATTEMPTS - 1
                or interrupted == HOST_ATTEMPTS - 1
            ):
                break
            excused += f"   made again:\n{w.account}"
            if stopped:
                interrupted += 1
                w.watch.await_calm(5.0 * interrupted)
            else:
                repeated += 1
        result.account = excused + result.account
        result.figures.repeated += repeated
        result.figures.interrupted += interrupted
        return result

    def _run_once(self, faults: Injected, source: str) -> Result:
        w = self.world
        w.begin(source, alone=len(faults) == 1)
        result = Result(figures=w.figures)
        robot, camera = self._situation(faults)
        begun = False
        try:
            needed = plan_of(faults, self._kept)
            if not w.port or needed.fresh or w.plan != needed:
                w.build(needed)
            w.tell("journal clear")
            w.begin_session(robot, camera)
            begun = True
            self._inject(faults)
            self._expect_invariants(faults)
        except Skipped as reason:
            self._give_up()
            return Result("impossible", w.figures, f"{reason}\n")
        except AssertionError as problem:
            w.violate(("" if begun else "before the fault: ") + str(problem))
        lines = w.supervisor.lines[-40:] if w.port else []
        log = "".join(f"   | {line[:160]}\n" for line in lines)
        if w.violations:
            result.end = "violated"
            result.account = (
                f"{w.account}{w.remarks}   robot {robot.name}, camera {camera.name}"
                f", log (its last lines):\n{log}   at the robot:\n"
                + (w.wire_tail() if w.port else "")
            )
            self._give_up()
        elif w.remarks:
            result.account = f"{w.remarks}   log (its last lines):\n{log}"
        return result

    def _situation(self, faults: Injected) -> tuple[Robot, Camera]:
        """At random, as the faults allow."""
        w = self.world
        #  most often it moves: there the faults can do harm
        lowest = max(fault.robot for fault in faults)
        robot = Robot(min(max(Robot), w.whole(lowest, max(Robot) + 2)))
        if robot is Robot.MOVING_WITH_WATCHDOG and w.chance(2):
            robot = Robot.MOVING
        needs = [fault.camera for fault in faults]
        if True in needs:
            camera = Camera.STREAMING if w.chance(2) else Camera.WITH_POSITION
        elif False in needs or w.chance(2):
            camera = Camera.CLOSED
        else:
            camera = Camera(w.whole(Camera.STREAMING, max(Camera)))
        return robot, camera

    def _inject(self, faults: Injected) -> None:
        w = self.world
        try:
            w.talk_some(0.0, 0.4, calm=True)
            for number, fault in enumerate(faults):
                if number > 0:
                    if not w.present and not w.chance(3):
                        w.try_to_join()
                    w.talk_some(0.0, 0.5)
                try:
                    inject = fault.inject if w.alone else fault.in_pair
                    (inject or fault.inject)(w)
                except AssertionError as problem:
                    w.violate(f"{fault.name}: {problem}")
            w.talk_some(0.05, 0.5)
        finally:
            for fault in reversed(faults):
                try:
                    fault.lift(w)
                except AssertionError as problem:
                    w.violate(f"at the end of {fault.name}: {problem}")
            w.reachable = True

    def _expect_invariants(self, faults: Injected) -> None:
        w = self.world
        ends = max(fault.ends for fault in faults)
        if w.expected_end is not None:
            self._expect_end()
        elif not w.lives:
            w.violate(
                f"it has ended with status {w.exit_status()}", "the supervisor lives"
            )
            return
        else:
            self._expect_session_goes_on()
            if ends is Ends.NOTHING and not w.present:
                w.violate(
                    "the session has ended without a reason", by=Cause.STOPPED_MACHINE
                )
            elif ends is Ends.SESSION and len(faults) == 1 and w.present:
                w.violate("the session has not ended", by=Cause.STOPPED_MACHINE)
        w.lose("close")
        if not w.violations:
            self._expect_new_session()
        if not w.violations:
            w.expect_no_leaks()

    def _expect_end(self) -> None:
        """The supervisor ends as it should; then there is a new one."""
        w = self.world
        start = time.monotonic()
        try:
            status = w.exit_status()
            check_within(time.monotonic() - start, END_LIMIT + NOISE, "its end")
        except AssertionError as problem:
            w.violate(str(problem), "the supervisor lives")
            return
        if status != w.expected_end:
            w.violate(
                f"it ended with status {status} instead of {w.expected_end}",
                "the supervisor lives",
            )
        w.listen()
        w.present = False
        w.await_standing()
        self._switch_on()
        w.start_supervisor()

    def _switch_on(self) -> None:
        """The robot, where it needs that."""
        w = self.world
        if not w.robot_ready or not w.line_works:
            w.tell("reset-robot")
            w.expect_status("state", "idle")
            w.line_works = True

    def _expect_session_goes_on(self) -> None:
        w = self.world
        try:
            w.expect_answers()
            if w.present:
                w.say("nope", "refused")
                w.expect_answers()
        except AssertionError as problem:
            w.violate(str(problem), "answered exactly once")

    def _expect_new_session(self) -> None:
        w = self.world
        found_in = max(0.0, w.found_by - time.monotonic())
        try:
            w.await_standing()
            self._switch_on()
            w.join(found_in + RETURN_LIMIT + NOISE)
            #  as at the start: nothing is open
            w.order("RPIN", "ANAK")
            w.order("CPCO", "ANAK")
            w.bring_to(Robot.MOVING_WITH_WATCHDOG if w.chance(2) else Robot.MOVING)
            if not w.plan.camera and w.camera > Camera.CLOSED:
                w.order("COPN")
                w.until(lambda: w.monitor.counts["CIMG"], IMAGES_LIMIT, "an image")
            #  a stop and a close must be effective even if the line was late four
            #  times in a row
            w.order("RSTP", "AACK ATIM ANAK")
            w.expect_status("moving", "0", DRIVE_LIMIT)
            if w.chance(2):
                #  else the end of the session does it
                w.order("CCLS")
                w.order("RCLS", "AACK ATIM")
            else:
                w.say("RGFW")
                w.expect_answers()
            w.lose("close")
            w.await_standing()
        except AssertionError as problem:
            w.violate(str(problem), "a new session works")

    def _give_up(self) -> None:
        """After faults that leave the world in an unknown state."""
        w = self.world
        if not self._kept or not w.port or not w.lives:
            w.destroy()
            return
        w.monitor.close()
        w.present = False
        w.nobody_since = 0.0
        try:
            w.tell("reset-robot")
            w.expect_status("state", "idle")
        except AssertionError:
            w.destroy()

    def finish(self) -> None:
        self.world.destroy()
        self.world.link.remove()
