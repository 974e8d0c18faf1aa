#  SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of a camera."""

import time
from functools import partial

from demands import (
    expect,
    expect_closed,
    expect_images,
    expect_open,
    image_size,
    is_started,
    quieten,
    recover_camera,
    situation,
)
from faults import Ends, Fault, telling
from world import NOISE, PROMPT, RETURN_LIMIT, Camera, Robot, World, check, check_within

ASKED = (320, 240)
#  Which every image is made to fit
OPEN_LIMIT = 5.0
#  For a source on the network to be given up


def expect_robot_answers(w: World) -> None:
    """In the usual time, during the fault of the camera."""
    expect(w, "RPIN", "ANAK" if w.robot is Robot.CLOSED else "AACK")


def expect_fitting(w: World) -> None:
    """The last image fills the size asked for, in one direction at least."""
    width, height = image_size(w)
    check(
        0 < width <= ASKED[0]
        and 0 < height <= ASKED[1]
        and (width == ASKED[0] or height == ASKED[1]),
        f"an image of {width} x {height}",
    )


def mend(w: World) -> None:
    w.tell("camera mend")


def switch_off(w: World) -> None:
    before = situation(w)
    w.tell("camera off")
    if w.camera > Camera.CLOSED:
        expect_closed(w, before)
    for _ in range(w.whole(1, 5)):
        expect(w, "COPN", "ANAK")
        expect_robot_answers(w)
    expect(w, "CPCO", "ANAK")
    mend(w)
    recover_camera(w)


def open_no_device(w: World) -> None:
    for _ in range(w.whole(1, 5)):
        expect(w, "COPN", "ANAK")
        expect_robot_answers(w)
        expect(w, "CASA", "ANAK")


def open_late(w: World, after: int, opens: bool) -> None:
    """It opens after so many milliseconds, and opens: is waited for so long."""

    def expect_on_wire(command: str, text: str) -> None:
        said = time.monotonic()
        w.say(command)
        w.until(
            lambda: any(item.command == text for item in w.emulator.journal()),
            30.0,
            f"{text} on the wire",
        )
        on_wire = next(n.first for n in w.emulator.journal() if n.command == text)
        check_within(on_wire - said, PROMPT + NOISE, f"{command} on the wire")

    if not w.alone:
        w.tell(f"camera opening {after}")
        w.say("CCLS")
        w.say("COPN")
        return
    expect(w, "CCLS", "AACK")
    if not is_started(w):
        quieten(w)
        expect(w, "RSOW", "AACK")
    w.expect_answers()
    w.tell(f"camera opening {after}")
    w.tell("journal clear")
    levels = w.monitor.counts["RBLV"]
    number = len(w.monitor.messages)
    start = time.monotonic()
    w.say("COPN")
    #  its answer comes first, but neither the robot nor unsolicited messages wait
    w.sleep(0.0, 0.3)
    expect_on_wire("RTRN:7", "T=7")
    expect_on_wire("RSTP", "M=0")
    w.expect_status("moving", "0", NOISE)
    while time.monotonic() < start + 1.0 + NOISE and w.monitor.counts["RBLV"] == levels:
        time.sleep(0.005)
    check(w.monitor.counts["RBLV"] > levels, "the battery's level waits for the camera")
    if w.chance(3):
        #  nor does the end of the session, or the next one
        w.say("RGFW")
        w.lose("close" if w.chance(2) else "reset")
        w.join(RETURN_LIMIT + NOISE)
        expect(w, "RPIN", "ANAK")
        expect(w, "ROPN", "AACK")
        expect(w, "RSOW", "AACK")
        return
    w.expect_answers()
    answers = (m for m in w.monitor.messages[number:] if m.label in ("AACK", "ANAK"))
    answer = next(answers)
    check_within(answer.time - start, OPEN_LIMIT + NOISE, "the answer to COPN")
    if opens:
        check(answer.label == "AACK", "a camera that opens slowly is given up")
        expect_images(w, 2)
    expect_robot_answers(w)


def stall(w: World) -> None:
    before = situation(w)
    w.tell("camera stall")
    for _ in range(3):
        expect_robot_answers(w)
        w.sleep(0.0, 0.2)
    expect_closed(w, before)
    if w.chance(4):
        w.say("COPN")
        w.expect_answers(OPEN_LIMIT + NOISE)
        expect(w, "CPCO", "ANAK")
    mend(w)
    recover_camera(w)


def deliver_garbage(w: World) -> None:
    w.tell("camera garbage")
    for _ in range(4):
        w.sleep(0.1, 0.5)
        expect_robot_answers(w)
    check(w.monitor.broken_images == 0, "a broken image was sent")
    mend(w)
    recover_camera(w)


def change_sizes(w: World) -> None:
    before = situation(w) if w.alone else None
    for _ in range(w.whole(4, 10)):
        w.tell(f"camera size {w.whole(1, 1600)}x{w.whole(1, 1200)}")
        w.sleep(0.02, 0.25)
    if before:
        expect_images(w, 2)
        expect_fitting(w)
        expect_robot_answers(w)
        mend(w)
        expect_images(w, 3)
        expect_fitting(w)
        expect_open(w, before)


def change_size(w: World, size: str, fits: tuple[int, int]) -> None:
    """fits: what becomes of it."""
    before = situation(w)
    w.tell(f"camera size {size}")
    #  in mid-stream the images are made to fit, one way or another
    expect_images(w, 3)
    expect_fitting(w)
    expect_robot_answers(w)
    expect_open(w, before)
    #  from the beginning their proportions are kept
    expect(w, "CCLS", "AACK")
    w.order("COPN")
    expect_images(w, 1)
    seen = image_size(w)
    check(seen == fits, f"images of {seen} instead of {fits}")
    mend(w)
    expect_images(w, 3)
    expect_fitting(w)


def change_rate(w: World, rate: int) -> None:
    sent = 10
    #  images a second, at most
    before = situation(w)
    w.tell(f"camera fps {rate}")
    if rate < sent:
        #  fewer, but it is no failure
        time.sleep(2.5)
        expect_images(w, 1)
    else:
        expect_images(w, 1)
        seen = w.monitor.counts["CIMG"]
        time.sleep(1.0)
        seen = w.monitor.counts["CIMG"] - seen
        check(2 <= seen <= sent + 2, f"{seen} images a second")
    expect_robot_answers(w)
    expect_open(w, before)
    mend(w)
    expect_images(w, 2)


camera = partial(Fault, "camera", lift=mend)

FAULTS = [
    camera("camera cannot be opened", switch_off, in_pair=telling("camera off")),
    camera(
        "no such camera",
        open_no_device,
        in_pair=partial(World.say, line="COPN"),
        plan={"camera": "/dev/no_such_camera"},
        camera=False,
    ),
    camera(
        "camera stops delivering",
        stall,
        in_pair=telling("camera stall"),
        cost=4.0,
        camera=True,
    ),
    camera(
        "camera delivers garbage",
        deliver_garbage,
        in_pair=telling("camera garbage"),
        cost=2.5,
        camera=True,
    ),
    camera("images change their size", change_sizes, cost=2.5, camera=True),
    *(
        camera(
            f"images of {size}",
            partial(change_size, size=size, fits=fits),
            in_pair=telling(f"camera size {size}"),
            cost=cost,
            camera=True,
            heavy=cost > 1.0,
        )
        for size, fits, cost in (
            ("1x1", (240, 240), 1.0),
            ("3840x2160", (320, 180), 3.0),
        )
    ),
    *(
        camera(
            f"camera {name} than asked",
            partial(change_rate, rate=rate),
            in_pair=telling(f"camera fps {rate}"),
            cost=cost,
            camera=True,
        )
        for name, rate, cost in (("slower", 1, 3.5), ("faster", 100, 2.0))
    ),
    *(
        camera(
            f"camera opens only after {seconds} s",
            partial(open_late, after=1000 * seconds, opens=seconds == 2),
            cost=cost,
            ends=Ends.SESSION_MAY_END,
        )
        for seconds, cost in ((10, 4.0), (2, 3.0))
    ),
]
