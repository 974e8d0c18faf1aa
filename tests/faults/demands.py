#  SPDX-License-Identifier: GPL-3.0-or-later
"""Requirements that a fault checks during the session, beside the invariants."""

import base64
import time
from dataclasses import dataclass

from ledger import Message
from world import NOISE, PROMPT, STOP_LIMIT, Robot, World, check, check_within

LOSS_OF_ROBOT = 1.0
#  F9: while the robot is started
RELOAD_PERIOD = 1.0
#  F11
IMAGES_LIMIT = 6.0
#  For one image more: ten a second, by programs of low priority


def text_of(item: Message) -> str:
    """Such as RBLV:2"""
    return item.label + (f":{item.data}" if item.data else "")


def expect(w: World, command: str, answers: str) -> None:
    """The answer is one of these, such as "AACK" or "RBLV:2 ATIM", in time."""
    item, took = w.asked(command)
    check(
        text_of(item) in answers.split(),
        f"{command} was answered {text_of(item)} instead of {answers}",
    )
    check_within(took, PROMPT + NOISE, f"the answer to {command}")


@dataclass
class Before:
    """What there was, with every command answered."""

    log: int
    losses: int
    time: float


def situation(w: World) -> Before:
    w.expect_answers()
    return Before(len(w.supervisor.lines), w.monitor.counts["ATIM"], time.monotonic())


def expect_told(w: World, before: Before, text: str, within: float) -> None:
    """The monitor, by a message."""
    w.until(
        lambda: any(
            item.label == "MSSG" and item.time > before.time and text in item.data
            for item in w.monitor.messages
        ),
        within + NOISE,
        f"the monitor is told: {text}",
        since=before.time,
    )


#  The robot


def quieten(w: World) -> None:
    """Line open, robot not started: only requested exchanges are on the line, and all
    messages are answers."""
    expect(w, "ROPN", "AACK")
    expect(w, "RRST", "AACK")
    #  a level that was held back for this answer may follow it
    time.sleep(0.1)
    w.listen()
    w.robot = Robot.OPEN


def is_started(w: World) -> bool:
    """It was, when the fault came."""
    return w.robot >= Robot.STARTED


def has_watchdog(w: World) -> bool:
    return w.robot in (Robot.STARTED_WITH_WATCHDOG, Robot.MOVING_WITH_WATCHDOG)


def start_with_watchdog(w: World) -> None:
    """Where it was not."""
    if not has_watchdog(w):
        quieten(w)
        expect(w, "RSWW", "AACK")
        expect(w, "RGLF", "AACK")
        w.robot = Robot.MOVING_WITH_WATCHDOG


def expect_truth(w: World) -> None:
    """The monitor's messages on battery and movement are true."""
    before = w.emulator.status()
    item, _ = w.asked("RGST")
    after = w.emulator.status()["moving"]
    check(
        before["moving"] != after or text_of(item) == f"RCST:{after}",
        f"RGST was answered {text_of(item)}, but moving={after}",
    )
    level = before["battery"]
    expect(w, "RGBT", "RBLV:" + ("0" if level == "critical" else level))


def expect_loss(w: World, before: Before) -> None:
    """Within a second a started robot counts as lost: a last stop on the wire, one
    message, and from then on ANAK."""
    w.until(
        lambda: w.monitor.counts["ATIM"] > before.losses,
        LOSS_OF_ROBOT + NOISE,
        "it is told that the robot is lost",
        since=before.time,
    )
    w.expect_log("robot lost", NOISE, before.log)
    if w.line_works:
        #  it may still be in transit, at 9600 baud
        w.until(
            lambda: [n.command for n in w.emulator.journal()][-1:] == ["M=0"],
            LOSS_OF_ROBOT + 2 * NOISE,
            "the last word to a lost robot is a stop",
            since=before.time,
        )
        w.expect_status("moving", "0", STOP_LIMIT + NOISE)
    expect(w, "RPIN", "ANAK")
    check(
        w.monitor.counts["ATIM"] == before.losses + 1,
        "told more than once that the robot is lost",
    )


def expect_no_loss(w: World, before: Before) -> None:
    check(
        not w.supervisor.says("robot lost", after=before.log),
        "the robot was given up after fewer than four failures",
    )


def await_unasked(w: World) -> None:
    """The unsolicited ATIM of a lost robot, which a monitor could take for the next
    answer."""
    time.sleep(0.1)
    w.listen()


def expect_return(w: World) -> None:
    """The line can be opened again, and works."""
    #  a line that is opened at once: system test F09_Reopened_At_Once
    await_unasked(w)
    expect(w, "ROPN", "AACK")
    expect(w, "RPIN", "AACK")
    w.expect_status("moving", "0", STOP_LIMIT + NOISE)
    w.robot = Robot.OPEN


def expect_not_running(w: World, before: Before) -> None:
    """A started robot with watchdog is found not to run at the next reload: a message,
    and the session is not started."""
    within = RELOAD_PERIOD + PROMPT + NOISE
    w.expect_log("robot no longer runs", within, before.log)
    expect_told(w, before, "robot no longer runs", within)
    w.tell("journal clear")
    expect(w, "RGFW", "ACRJ")
    orders = [n.command for n in w.emulator.journal() if n.command[:1] in ("M", "T")]
    check(not orders, f"an order to a robot that is not started: {orders}")
    w.robot = Robot.OPEN


#  The camera


def expect_images(w: World, count: int) -> None:
    """So many, soon."""
    before = w.monitor.counts["CIMG"]
    w.until(
        lambda: w.monitor.counts["CIMG"] >= before + count,
        IMAGES_LIMIT + 0.1 * count,
        lambda: f"{count} images, but {w.monitor.counts['CIMG'] - before}",
    )
    check(w.monitor.broken_images == 0, "a broken image")


def expect_closed(w: World, before: Before) -> None:
    """The monitor is informed that the camera has failed."""
    #  2.5 s without an image, and a little
    expect_told(w, before, "camera closed: ", 3.5)


def expect_open(w: World, before: Before) -> None:
    """It has not been closed since."""
    check(
        not w.supervisor.says("camera closed", after=before.log),
        "the camera was closed",
    )


def image_size(w: World) -> tuple[int, int]:
    """Width and height of the last image."""
    #  the frame header comes before
    data = base64.b64decode(w.monitor.last_image[:2000], validate=True)
    place = 2
    while data[place + 1] not in (0xC0, 0xC1, 0xC2):
        place += 2 + int.from_bytes(data[place + 2 : place + 4], "big")
    height, width = (
        int.from_bytes(data[place + n : place + n + 2], "big") for n in (5, 7)
    )
    return width, height


def recover_camera(w: World) -> None:
    """Open or not: it can be opened, and delivers images."""
    #  a late effect of the fault may close it once more
    for last in (False, False, True):
        item, _ = w.asked("COPN")
        check(
            item.label == "AACK",
            f"COPN was answered {text_of(item)} though the camera works again",
        )
        try:
            expect_images(w, 3)
            return
        except AssertionError:
            if last:
                raise
