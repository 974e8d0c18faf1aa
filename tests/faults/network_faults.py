#  SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of the network and its users."""

import subprocess
import sys
import time
from functools import partial

import crowds
from client import Monitor
from faults import Ends, Fault
from ledger import kind_of
from links import Skipped
from world import (
    LOOPBACK,
    NEWCOMER_TIME,
    NOISE,
    RETURN_LIMIT,
    SILENCE_LIMIT,
    STALLED_LIMIT,
    STOP_LIMIT,
    VANISHED_LIMIT,
    World,
    check,
)

COMMANDS = (
    "ROPN RCLS RSOW RSWW RRST RPIN RLDW RGFW RGBW RGLF RGRI RSTP RMOV RTRN"
    " RPOF RGBT RGST COPN CCLS CASA CACO CAIN CPCO CPST MSSG"
    " MABT MGTO MPTH MGCM MPCM"
)
#  All that the monitor can say, but LIVE, which obliges it to go on


def amid(w: World, line: str, part: str) -> str:
    """Line with part put in somewhere."""
    place = w.whole(0, len(line))
    return line[:place] + part + line[place:]


def any_command(w: World) -> str:
    return w.any_of(COMMANDS)


def depart(w: World, how: str, mid_line: bool = False) -> None:
    if mid_line:
        line = any_command(w) + ":-123"
        w.say_bytes(line[: w.whole(1, len(line))])
    w.lose(how)


def be_missed(w: World, within: float) -> None:
    """The supervisor finds that the monitor has gone without a word."""
    if w.present:
        log = w.session_log
        w.lose("silent", within)
        if w.plan.log_is_read:
            check(
                w.supervisor.says("monitor lost", within + NOISE, log),
                f"the monitor that vanished is not missed within {within + NOISE} s",
            )
        else:
            #  the next admission shows whether it was
            time.sleep(within)


def cut(w: World, how: str) -> None:
    """The way to the monitor: no packet comes any more."""
    w.reachable = False
    w.listen()
    w.link.change(how, breaks=True)
    be_missed(w, VANISHED_LIMIT)


def mend(w: World, how: str) -> None:
    w.link.change(how, breaks=False)
    w.monitor.close()
    w.reachable = True


def hang(w: World) -> None:
    """Its kernel goes on."""
    w.say("LIVE")
    be_missed(w, SILENCE_LIMIT)


def stall(w: World, length: float) -> None:
    """The monitor reads nothing."""
    filling = 1.5
    #  images in transit until the last one is taken, and a sample
    start = time.monotonic()
    w.listen()
    if not w.present:
        return
    w.monitor.pause(True)
    while (left := start + length - time.monotonic()) > 0.0:
        w.talk(0.1, calm=True)
        time.sleep(min(left, w.source.uniform(0.0, 2.0)))
    w.monitor.pause(False)
    if w.present and length > STALLED_LIMIT and w.monitor.closed(3.0):
        w.listen()
        w.nobody_in_command(start, STALLED_LIMIT + filling + STOP_LIMIT)


def send_slowly(w: World) -> None:
    for _ in range(4):
        line = w.any_of("RPIN RGST RSTP RMOV:-12 RTRN:+45 nope RGBT RLDW")
        for c in line:
            w.say_bytes(c)
            w.sleep(0.0, 0.04)
        w.say("", kind_of(line))


def send_endless_line(w: World) -> None:
    """Of 1 MB."""
    if w.chance(2):
        w.say_bytes("RMOV:")
    octets = w.source.randbytes(65_536).decode("latin-1").replace("\n", "9")
    nines = "".join(w.source.choice((c, "9")) for c in octets)
    for _ in range(16):
        w.say_bytes(nines)
    w.say("", "refused")


def send_nul_bytes(w: World) -> None:
    w.say("\0" * w.whole(1, 300), "refused")
    for _ in range(20):
        w.say(amid(w, "RMOV:12", "\0"), "refused")
        w.say(amid(w, any_command(w), "\0"), "refused")


def send_invalid_text(w: World) -> None:
    def flaw() -> str:
        return w.source.choice(
            (
                "\xc3(",  # a continuation is missing
                "\x80",  # one without a beginning
                "\xff\xfe",
                "\xc0\x8a",  # a line feed, too long
                "\xed\xa0\x80",  # half a surrogate pair
                "\xf4\x90\x80\x80",  # past the last code point
                "\xe2\x82",  # cut off
                "\xf8" + chr(w.whole(128, 255)),
            )
        )

    for _ in range(20):
        w.say(amid(w, "RTRN:-7", flaw()), "refused")
        w.say(amid(w, any_command(w), flaw()), "refused")
        w.say("MSSG:" + amid(w, "text", flaw()), "silent")


#  What follows a name, {} being many digits, and the kind of its answer, "" for that of
#  the name
MOVEMENT = [("", "refused"), (":", "refused"), (":{}", "usual"), (":-{}", "usual")]
MOVEMENT += [(":--1", "refused")]
MISSION = [("", "refused"), (":", "refused"), (":{}99;1", "refused")]
MISSION += [(":-9999999.5;-1", "usual"), (":--1;1", "refused")]
ODD_DATA = {
    "RMOV": MOVEMENT,
    "RTRN": MOVEMENT,
    "MGTO": MISSION,
    "MPTH": MISSION,
    "MGCM": MISSION,
    "MPCM": MISSION,
    "MSSG": [("", "refused"), (":", "silent"), (":{}", "perhaps"), (":-1", "silent")],
}
USUAL_DATA = [("", ""), (":", ""), (":{}", "refused"), (":-{}", "refused")]


def send_odd_data(w: World) -> None:
    """Every command without its data, with a number beyond all bounds, a negative one,
    and nonsense."""
    w.listen()
    #  RPOF will switch it off
    w.robot_ready = w.robot_ready and not w.present
    names = COMMANDS.split()
    shift = w.whole(0, len(names) - 1)
    for name in names[shift:] + names[:shift]:
        nines = "9" * w.whole(6, 400)
        for end, kind in ODD_DATA.get(name, USUAL_DATA):
            w.say(name + end.format(nines), kind)
        nonsense = "".join(chr(w.whole(32, 126)) for _ in range(20))
        w.say(f"{name}:x{nonsense}", "silent" if name == "MSSG" else "refused")


def come_in_a_crowd(w: World) -> None:
    count = 1_000
    if w.expected_end is not None or not w.reachable:
        return
    w.listen()
    #  a client that finds the kernel's queue full retries after 1, 3, 7 s
    told, closed, left = crowds.crowd((w.address, w.port), count, 20.0)
    w.listen()
    #  Without a monitor, one of them becomes it until it disconnects. A client with
    #  unread data may see a reset before the reason.
    check(
        not w.present or (closed == count and left == 0 and told > count / 2),
        f"{told} of {count} were told why, {closed} closed, {left} left to wait",
    )


def flood(w: World) -> None:
    queue = 512
    if w.expected_end is None and w.reachable and w.address == LOOPBACK:
        command = (sys.executable, crowds.__file__, str(w.port))
        with subprocess.Popen(command) as others:
            w.talk(1.0, calm=True)
            others.kill()
        w.talk(queue * NEWCOMER_TIME, calm=True)


def scan(w: World) -> None:
    count = w.whole(50, 300)
    crowds.knock((w.address, w.port), count, w.source)
    #  later clients wait behind them; the monitor in command does not
    w.talk(count * NEWCOMER_TIME, calm=True)


def scan_half_open(w: World) -> None:
    try:
        crowds.half_open((w.address, w.port), w.whole(50, 300), w.source)
    except PermissionError:
        raise Skipped("packets of one's own need CAP_NET_RAW") from None


def be_second(w: World) -> None:
    mark = 12321
    #  no other movement is so long
    for _ in range(w.whole(1, 4)):
        w.listen()
        if not w.present:
            break
        other = Monitor()
        other.connect(w.port, w.address)
        for _ in range(w.whole(1, 10)):
            if not other.send(f"RMOV:{mark}\n".encode()):
                break
            w.talk(0.0, calm=True)
        end = time.monotonic() + RETURN_LIMIT + NOISE
        while not other.messages and not other.end and time.monotonic() < end:
            time.sleep(0.001)
        w.listen()
        if not w.present:
            other.close()
            break
        #  without a descriptor it can be neither admitted nor rejected, and waits in
        #  the kernel's queue
        closed = not w.reachable or other.closed(RETURN_LIMIT + NOISE)
        other.close()
        check(closed, "a second monitor is not turned away")
        labels = [item.label for item in other.messages]
        check(labels in ([], ["MSSG"]), f"a second monitor is answered {labels}")
    check(
        not w.present
        or all(item.command != f"M={mark}" for item in w.emulator.journal()),
        "the robot has obeyed a second monitor",
    )


network = partial(Fault, "network")
session_ends = partial(network, ends=Ends.SESSION)
CUTS = {
    "vanishing without a packet": "cable pulled",
    "monitor's machine silent": "monitor gone",
    "packets to the monitor dropped": "dropped there",
    "packets from the monitor dropped": "dropped here",
    "own interface down": "interface down",
    "own address gone": "address gone",
    "own route gone": "route gone",
}

FAULTS = [
    session_ends("orderly close", partial(depart, how="close")),
    session_ends("reset", partial(depart, how="reset")),
    session_ends(
        "half a line, then close", partial(depart, how="close", mid_line=True)
    ),
    session_ends(
        "half a line, then reset", partial(depart, how="reset", mid_line=True)
    ),
    *(
        session_ends(
            name,
            partial(cut, how=how),
            partial(mend, how=how),
            plan={"through_link": True},
            cost=6.0,
        )
        for name, how in CUTS.items()
    ),
    session_ends("announced signs of life do not come", hang, cost=2.0),
    *(
        network(
            f"stall of {length} s",
            partial(stall, length=length),
            plan={"receive_buffer": 8_192},  # soon full
            cost=length,
            camera=True,
            ends=Ends.SESSION if length > STALLED_LIMIT else Ends.NOTHING,
        )
        for length in (1, 5, 14, 20)
    ),
    network("byte by byte", send_slowly),
    network("a line of 1 MB without end", send_endless_line),
    network("NUL bytes", send_nul_bytes),
    network("invalid UTF-8", send_invalid_text),
    network("every command with odd data", send_odd_data, cost=3.0),
    network("1,000 connections at once", come_in_a_crowd, cost=10.0),
    network("flood of connections", flood, cost=5.0),
    network("port scan", scan, cost=2.0),
    network("half-open port scan", scan_half_open),
    network("second monitor talks over the first", be_second),
]
