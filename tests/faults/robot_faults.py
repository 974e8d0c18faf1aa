#  SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of the robot and its line."""

import time
from functools import partial

from demands import (
    await_unasked,
    expect,
    expect_loss,
    expect_no_loss,
    expect_not_running,
    expect_return,
    expect_truth,
    has_watchdog,
    is_started,
    quieten,
    situation,
    start_with_watchdog,
)
from faults import Fault, telling
from parties import LIMIT
from world import NOISE, PROMPT, STOP_LIMIT, Robot, World

ENOUGH_TO_LOSE = 4
#  F8: failures in a row
QUESTIONS = {"RPIN": "AACK", "RGBT": "RBLV:2", "RGST": "RCST:0", "RLDW": "ACRJ"}
#  To a robot that is idle, and their answers. The last is one that it refuses then


def any_question(w: World) -> str:
    return w.source.choice(list(QUESTIONS))


def expect_right(w: World, times: int = 1) -> None:
    """One of them is answered correctly."""
    for _ in range(times):
        question = any_question(w)
        expect(w, question, QUESTIONS[question])


def expect_nothing(w: World, times: int = 1) -> None:
    """One of them has no valid answer."""
    for _ in range(times):
        expect(w, any_question(w), "ATIM")


def in_motion(w: World) -> bool:
    return is_started(w) and not w.chance(3)


def mend(w: World) -> None:
    """The robot answers correctly again."""
    w.tell("mend")


#  Corrupted answers, a few or many


def spoil(w: World, how: str, count: int) -> None:
    """The next count answers."""
    w.tell(
        f"{how} {count}"
        #  bits of the longest answer, the version
        + (f" {w.whole(0, 39)}" if how == "flip" else "")
        + (f" {w.whole(0, 4)}" if how == "truncate" else "")
    )


def spoil_answers(w: World, how: str) -> None:
    if not w.alone:
        spoil(w, how, w.whole(1, 2 * ENOUGH_TO_LOSE))
    elif in_motion(w):
        spoil_in_motion(w, how)
    else:
        spoil_in_quiet(w, how)


def spoil_in_quiet(w: World, how: str) -> None:
    """Every answer reported is a possible answer to the command."""
    quieten(w)
    if how == "flip":
        #  every bit of the answer to one question
        question = any_question(w)
        for bit in range(24):
            w.tell(f"flip 1 {bit}")
            expect(w, question, "ATIM")
            expect_right(w)
    if how == "wrong":
        #  every other kind for each: some answers to a battery request cannot be
        #  distinguished from a level of 0
        for question in QUESTIONS:
            for _ in range(3):
                w.tell("wrong 1")
                expect(w, question, "ATIM RBLV:0" if question == "RGBT" else "ATIM")
                expect_right(w)
    #  the answers to the probes that follow, too
    for _ in range(4):
        count = w.whole(1, ENOUGH_TO_LOSE - 1)
        spoil(w, how, count)
        for number in range(count):
            if how == "wrong":
                #  a false level of 0 cannot be detected, and with it the line seems
                #  to be synchronised
                question = any_question(w)
                false = "RBLV:0 " if question == "RGBT" else ""
                right = QUESTIONS[question] if number > 0 else ""
                expect(w, question, f"ATIM {false}{right}")
            else:
                expect_nothing(w)
        mend(w)
        expect_right(w, 2)
    if how != "wrong" and w.chance(2):
        before = situation(w)
        spoil(w, how, ENOUGH_TO_LOSE)
        expect_nothing(w, ENOUGH_TO_LOSE - 1)
        expect_no_loss(w, before)
        expect_nothing(w)
        w.expect_log("robot lost", NOISE, before.log)
        await_unasked(w)
        expect(w, "RPIN", "ANAK")
        mend(w)
        expect_return(w)


def spoil_in_motion(w: World, how: str) -> None:
    few = w.whole(1, ENOUGH_TO_LOSE - 1)
    before = situation(w)
    spoil(w, how, few)
    w.talk_some(0.4, 0.8, calm=True)
    w.expect_answers()
    expect_no_loss(w, before)
    mend(w)
    expect_truth(w)
    if how != "wrong" and w.chance(2):
        before = situation(w)
        spoil(w, how, 2 * ENOUGH_TO_LOSE)
        expect_loss(w, before)
        mend(w)
        expect_return(w)


def silence(w: World, how: str, mended: str, late_by: float = 0.0) -> None:
    """All answers late, or none, or one without end."""
    if in_motion(w):
        before = situation(w)
        w.tell(how)
        expect_loss(w, before)
        w.tell(mended)
        expect(w, "ROPN", "AACK")
        #  late answers may disturb the first exchanges
        time.sleep(late_by)
        expect_return(w)
        expect_truth(w)
        return
    quieten(w)
    for _ in range(3):
        before = situation(w)
        w.tell(how)
        expect_nothing(w, w.whole(1, 2 if late_by else ENOUGH_TO_LOSE - 1))
        w.tell(mended)
        #  Late answers arrive while others are awaited, and delay these. They are never
        #  taken for them.
        if late_by:
            w.sleep(0.0, late_by)
            for _ in range(2):
                question = any_question(w)
                expect(w, question, QUESTIONS[question] + " ATIM")
        expect_right(w, 3)
        expect_no_loss(w, before)


def pile(w: World) -> None:
    """Answers held back, and sent together."""
    count = w.whole(2, 8)
    if not w.alone:
        w.tell(f"pile {count}")
        return
    if in_motion(w):
        before = situation(w)
        w.tell(f"pile {count}")
        if count > ENOUGH_TO_LOSE:
            expect_loss(w, before)
            mend(w)
            expect_return(w)
        else:
            w.talk_some(0.5, 0.8, calm=True)
            w.expect_answers()
            expect_no_loss(w, before)
            expect_truth(w)
        return
    quieten(w)
    for _ in range(3):
        before = situation(w)
        count = w.whole(2, ENOUGH_TO_LOSE)
        w.tell(f"pile {count}")
        expect_nothing(w, count - 1)
        #  with the next one all of them come
        expect_right(w, 3)
        expect_no_loss(w, before)


def answer_unasked(w: World) -> None:
    frames = (
        r"OO\r EE\r CC\r 00\r 11\r 22\r 3.5(\r \r \r\r\r OO O\r OO\rOO\r"
        r" OX\r \x00\x00\x00 \xFF\xFF\r M=0\x41\r w\x77\r"
    )
    for _ in range(w.whole(5, 30)):
        if not w.line_works:
            #  through an adapter that is not there nothing comes
            break
        noise = "".join(rf"\x{w.whole(0, 255):02X}" for _ in range(w.whole(1, 60)))
        w.tell("unasked " + (noise if w.chance(4) else w.any_of(frames)))
        w.talk_some(0.0, 0.06, calm=True)
    if w.alone:
        #  a stop among them must be effective, whatever the answers
        w.expect_answers()
        w.say("RSTP")
        w.expect_answers()
        w.expect_status("moving", "0", PROMPT + STOP_LIMIT + NOISE)
        #  and after them the line must work again
        time.sleep(0.1)
        expect(w, "RCLS", "AACK")
        expect_return(w)
        expect_truth(w)


def unplug(w: World) -> None:
    """The adapter is pulled out and put back."""
    before = situation(w) if w.alone else None
    w.line_works = False
    w.tell("hangup")
    if not before:
        return
    soon = w.chance(3)
    if soon:
        #  back before it is detected
        w.sleep(0.0, 0.06)
        w.tell("return")
    if is_started(w):
        expect_loss(w, before)
    elif w.robot is Robot.OPEN:
        for _ in range(ENOUGH_TO_LOSE):
            expect(w, "RPIN", "ATIM")
        expect(w, "RPIN", "ANAK")
        w.expect_log("robot lost", NOISE, before.log)
    if not soon:
        expect(w, "ROPN", "ANAK")
        w.sleep(0.0, 0.5)
        expect(w, "RPIN", "ANAK")
        w.tell("return")
    expect_return(w)
    w.line_works = True
    expect_truth(w)


def put_back(w: World) -> None:
    #  it may be there
    w.emulator.ask("return")


def by_radio(w: World, command: str, loses: bool) -> None:
    """loses: packets, which may be those of a stop."""
    w.tell(command)
    if w.alone:
        w.talk_some(1.0, 3.0, calm=True)
        w.expect_answers()
        mend(w)
        #  the last failure, with its probe
        time.sleep(0.5)
        w.listen()
        expect(w, "ROPN", "AACK")
        expect_truth(w)
    else:
        w.line_works = w.line_works and not loses


#  The robot is stopped and accepts nothing any more


def starve(w: World) -> None:
    start_with_watchdog(w)
    before = situation(w)
    w.tell("starve")
    w.expect_status("state", "watchdog_disabled", NOISE)
    expect_not_running(w, before)
    expect_truth(w)
    start_anew(w)


def start_anew(w: World) -> None:
    expect(w, "RGFW", "ACRJ")
    expect(w, "RRST", "AACK")
    expect(w, "RSWW", "AACK")
    expect(w, "RGFW", "AACK")
    w.expect_status("moving", "1", NOISE)


def stop_robot(w: World, command: str, state: str) -> None:
    """With a watchdog or without."""
    if w.chance(2):
        start_with_watchdog(w)
    watchdog = has_watchdog(w)
    before = situation(w)
    w.tell(command)
    w.expect_status("state", state, LIMIT if state == "idle" else NOISE)
    if watchdog:
        expect_not_running(w, before)
    elif w.robot is Robot.CLOSED:
        expect(w, "ROPN", "AACK")
        w.robot = Robot.OPEN
    expect_truth(w)


def switch_off_and_on(w: World) -> None:
    stop_robot(w, "reset-robot", "idle")
    start_anew(w)


def reset(w: World) -> None:
    w.tell("reset-robot")
    #  it needs 100 ms, by a tick of 100 ms
    time.sleep(0.25)


def charge(w: World) -> None:
    stop_robot(w, "charge on", "in_charge")
    expect(w, "RGFW", "ACRJ")
    expect(w, "RRST", "ACRJ AACK")
    expect(w, "RSOW", "ACRJ")


def empty(w: World) -> None:
    w.robot_ready = False
    if not w.alone:
        w.tell("battery critical")
        return
    start_with_watchdog(w)
    situation(w)
    w.tell("battery 0")
    expect(w, "RGBT", "RBLV:0")
    before = situation(w)
    w.tell("battery critical")
    expect_loss(w, before)
    w.expect_log("its battery was empty", NOISE, before.log)
    w.robot = Robot.CLOSED
    if w.chance(4):
        #  at last it switches itself off
        w.expect_status("state", "off", 6.0)


def silent(name: str, how: str, mended: str, late_by: float = 0.0) -> Fault:
    injected = partial(silence, how=how, mended=mended, late_by=late_by)
    return robot(name, injected, in_pair=telling(how))


def spoilt(name: str, how: str, cost: float) -> Fault:
    return robot(name, partial(spoil_answers, how=how), cost=cost)


def radio(name: str, command: str, loses: bool = False) -> Fault:
    injected = partial(by_radio, command=command, loses=loses)
    plan = {"emulator_options": "--radio", "options": "--answer-timeout 150"}
    return robot(f"by radio{name}", injected, cost=3.0, plan=plan)


robot = partial(Fault, "robot", lift=mend)
#  A socket cannot be hung up, and takes no noise while it is closed
on_terminal = partial(robot, plan={"terminal": True})

FAULTS = [
    silent("robot silent", "silent on", "silent off"),
    silent("answers 90 ms late", "delay 90", "delay 0", 0.1),
    silent("answers 200 ms late", "delay 200", "delay 0", 0.25),
    robot("answers come together", pile),
    spoilt("answers lost", "drop", 2.0),
    spoilt("each bit of an answer flipped", "flip", 3.0),
    spoilt("answers cut short", "truncate", 2.0),
    spoilt("random bytes for answers", "garbage", 1.5),
    silent("answer without an end", "endless on", "endless off"),
    on_terminal("answers nobody asked for", answer_unasked, cost=2.0),
    spoilt("answers of another kind", "wrong", 2.0),
    on_terminal("device pulled and put back", unplug, lift=put_back, cost=1.5),
    robot(
        "robot disabled by its watchdog",
        starve,
        in_pair=telling("starve"),
        cost=2.0,
    ),
    robot("robot reset by its watchdog", switch_off_and_on, in_pair=reset, cost=2.0),
    robot("robot's battery empty", empty, lift=telling("battery 2"), cost=2.5),
    robot(
        "robot charging",
        charge,
        lift=telling("charge off"),
        in_pair=telling("charge on"),
        cost=2.0,
    ),
    radio("", "mend"),
    radio(", retries in bursts", "radio-bursts 5"),
    radio(", packets lost", "radio-losses 5", loses=True),
]
