#  SPDX-License-Identifier: GPL-3.0-or-later
"""Faults caused by the machine and its administrator."""

import contextlib
import itertools
import os
import resource
import signal
import subprocess
from functools import partial
from pathlib import Path

from client import Monitor
from faults import Ends, Fault
from links import Skipped
from parties import PROGRAMS
from standstills import prefer_real_time
from world import (
    ANSWER_LIMIT,
    BUSY_LIMIT,
    NOISE,
    WATCHDOG_LIMIT,
    Cause,
    Robot,
    World,
    check,
    descriptors,
)

ROOT = os.geteuid() == 0
REAL_TIME = prefer_real_time() and prefer_real_time(0)
#  Whether it is allowed here


def stop(w: World, number: signal.Signals) -> None:
    w.listen()
    w.supervisor.process.send_signal(number)
    w.nobody_in_command()
    w.expected_end = 0
    if w.chance(3):
        #  an impatient user
        w.supervisor.process.send_signal(number)


def break_pipes(w: World) -> None:
    for _ in range(w.whole(1, 20)):
        w.supervisor.process.send_signal(signal.SIGPIPE)
        w.talk_some(0.0, 0.02, calm=True)


def kill(w: World) -> None:
    w.listen()
    if w.present and w.line_works and w.robot is not Robot.MOVING_WITH_WATCHDOG:
        #  one without it would drive on
        w.order("RCLS", "AACK ANAK")
        w.bring_to(Robot.MOVING_WITH_WATCHDOG)
        w.talk_some(0.0, 1.5, calm=True)
    w.supervisor.process.kill()
    w.expected_end = 128 + signal.SIGKILL
    #  by itself: nothing on the line causes it
    w.expect_status("moving", "0", WATCHDOG_LIMIT + NOISE)
    w.robot_ready = False
    #  the first stop of the next supervisor is no late one
    w.listen()
    w.nobody_since = 0.0


#  Standard error, from the start

FULL_DISK = """
set -e
if [ "$1" != --mounted ]; then
   mkdir -p "$here/disk"
   unshare --mount --propagation private true 2>/dev/null || exec "$@" 2>/dev/full
   exec unshare --mount --propagation private "$0" --mounted "$@"
fi
shift
mount -t tmpfs -o size=4k tmpfs "$here/disk"
exec "$@" 2>"$here/disk/log"
"""


def log_badly(w: World, file: str) -> None:
    """file: its standard error. If closed, no other file may get its descriptor."""
    seen = os.readlink(f"/proc/{w.pid}/fd/2")
    if file == "disk/log":
        if not ROOT:
            raise Skipped("only root can make a file system of 4 kB")
        if seen == "/dev/full":
            raise Skipped("no namespace for mounts here, or / is no mount point")
    check(seen == str(w.folder / file), f"its standard error is {seen}")
    #  each produces a log line
    for _ in range(w.whole(1, 200)):
        w.say("nonsense")
    w.talk_some(0.0, 0.5)


#  The pipe fills up, and is read again later. Open for reading and writing, so no open
#  waits for the other end

PIPE = """
[ -p "$here/log" ] || mkfifo "$here/log"
exec "$@" 2<>"$here/log"
"""


def open_pipe(w: World) -> int:
    return os.open(w.folder / "log", os.O_RDWR | os.O_NONBLOCK)


def drained(file: int) -> int:
    """Takes all that is in it: how many bytes that was."""
    size = 0
    with contextlib.suppress(BlockingIOError):
        while True:
            size += len(os.read(file, 4096))
    return size


def fill_pipe(w: World) -> None:
    file = open_pipe(w)
    check(drained(file) > 0, "the log does not go to the pipe")
    #  a line of the log may have left room in its page
    for size in (4096, 1):
        with contextlib.suppress(BlockingIOError):
            while True:
                os.write(file, b"\0" * size)
    os.close(file)
    for _ in range(w.whole(1, 600)):
        w.say("nonsense")
    w.talk_some(0.0, 0.5)
    if w.chance(3):
        w.expect_answers()
        w.lose("close")
        w.try_to_join()


def empty_pipe(w: World) -> None:
    if (w.folder / "log").exists():
        file = open_pipe(w)
        drained(file)
        os.close(file)


#  The machine's clock is not changed. A library preloaded before the C library reports
#  another time to the supervisor only. A deadline computed from it is then an hour off
#  for the kernel: this detects a dependence more reliably than a real change, which
#  only affects waits in progress.

CLOCK_LIBRARY = PROGRAMS / "libclock_shift.so"
CLOCK = f"""
if cp '{CLOCK_LIBRARY}' "$here" 2>/dev/null; then
   head -c 8 /dev/zero >"$here/clock"
   export LD_PRELOAD="$LD_PRELOAD:$here/{CLOCK_LIBRARY.name}"
   export CLOCK_SHIFT="$here/clock"
fi
exec "$@"
"""


def shift_clock(w: World, seconds: int) -> None:
    with (
        contextlib.suppress(FileNotFoundError),
        open(w.folder / "clock", "r+b") as file,
    ):
        file.write(seconds.to_bytes(8, "little", signed=True))


def set_clock(w: World) -> None:
    hour = 3_600
    years = 20 * 365 * 24 * hour
    if not CLOCK_LIBRARY.exists():
        raise Skipped(f"there is no {CLOCK_LIBRARY.name}")
    check(
        CLOCK_LIBRARY.name in Path(f"/proc/{w.pid}/maps").read_text(),
        f"the supervisor has not loaded {CLOCK_LIBRARY.name}",
    )
    for _ in range(w.whole(1, 4)):
        shifts = (hour, -hour, years, -years, w.whole(-10, 10))
        shift_clock(w, w.source.choice(shifts))
        w.talk_some(0.0, 0.5)


LOAD: list[subprocess.Popen[bytes]] = []


def be_busy(w: World) -> None:
    for _ in range(min(4, os.cpu_count() or 1)):
        LOAD.append(subprocess.Popen(["/bin/sh", "-c", "while :; do :; done"]))
    w.talk_some(0.5, 1.5)
    #  during the load, not after it
    try:
        w.expect_answers(BUSY_LIMIT if w.alone else ANSWER_LIMIT)
    except AssertionError:
        #  a late line changes an answer, but does not delay it
        w.cause = max(w.cause, Cause.STOPPED_MACHINE)
        raise


def be_idle(_: World) -> None:
    while LOAD:
        with LOAD.pop() as one:
            one.kill()


LIMITS: list[tuple[int, int]] = []


def take_descriptors(w: World) -> None:
    spare = w.whole(0, 1)
    log = len(w.supervisor.lines)
    w.expect_answers()

    def lowest() -> int:
        """Free: the next one that it would open."""
        return next(n for n in itertools.count() if n not in descriptors(w.pid))

    few = lowest() + spare
    LIMITS.append(resource.prlimit(w.pid, resource.RLIMIT_NOFILE))
    resource.prlimit(w.pid, resource.RLIMIT_NOFILE, (few, LIMITS[-1][1]))
    w.reachable = False
    others = [Monitor() for _ in range(w.whole(0, 3))]
    for other in others:
        #  the kernel takes them, the supervisor cannot
        other.connect(w.port, w.address)
    w.talk_some(0.1, 0.5, calm=True)
    if w.plan.log_is_read and w.present and spare == 0 and others:
        #  unless another fault has set one free
        check(
            w.supervisor.says("a monitor could not connect", NOISE, log)
            or lowest() < few,
            "it could take a connection: the limit does not hold",
        )
    w.talk_some(0.2, 1.0)
    for other in others:
        other.close()


def give_descriptors(w: World) -> None:
    while LIMITS:
        usual = LIMITS.pop()
        if w.lives:
            resource.prlimit(w.pid, resource.RLIMIT_NOFILE, usual)
    w.reachable = True


#  Privileges

AS_USER = """
for word; do
   [ "$before" != --serial ] || chown 65534 "$word"
   before=$word
done
exec setpriv --reuid=65534 --regid=65534 --clear-groups """
#  The robot's line, too: another user's cannot be opened


def start(w: World, real_time: bool, possible: bool) -> None:
    if not possible:
        raise Skipped("only root can change its privileges, to those it has")
    if w.plan.log_is_read:
        kind = "FIFO, ceilings" if real_time else "none"
        w.expect_log(f"real-time priorities: {kind}", 2.0)
    w.talk_some(0.2, 1.0)


machine = partial(Fault, "machine")


def signalled(name: str) -> Fault:
    injected = partial(stop, number=signal.Signals[name])
    return machine(name, injected, cost=3.0, ends=Ends.SUPERVISOR)


def badly_logged(name: str, file: str, launcher: str) -> Fault:
    plan = {"launcher": launcher, "log_is_read": False}
    return machine(name, partial(log_badly, file=file), plan=plan)


def started(
    name: str,
    launcher: str,
    real_time: bool,
    needs_root: bool = True,
    alone: bool = True,
) -> Fault:
    possible = not needs_root or (ROOT and (not real_time or REAL_TIME))
    plan: dict[str, object] = {"fresh": True}
    if launcher and ROOT and possible:
        plan |= {"copied": True, "launcher": launcher}
    injected = partial(start, real_time=real_time, possible=possible)
    return machine(f"started {name}", injected, plan=plan, cost=3.0, alone=alone)


FAULTS = [
    signalled("SIGTERM"),
    signalled("SIGINT"),
    signalled("SIGHUP"),
    machine("SIGPIPE", break_pipes),
    machine(
        "SIGKILL while moving, with watchdog",
        kill,
        cost=8.0,
        ends=Ends.SUPERVISOR,
        robot=Robot.MOVING,
        alone=True,
    ),
    badly_logged("standard error closed", "/dev/null", 'exec "$@" 2>&-'),
    badly_logged(
        "input, output and error closed", "/dev/null", 'exec "$@" <&- >&- 2>&-'
    ),
    machine(
        "full pipe behind standard error",
        fill_pipe,
        empty_pipe,
        plan={"launcher": PIPE, "log_is_read": False},
    ),
    badly_logged(
        "full device behind standard error", "/dev/full", 'exec "$@" 2>/dev/full'
    ),
    badly_logged("full disk behind standard error", "disk/log", FULL_DISK),
    machine(
        "wall clock set back and forth",
        set_clock,
        partial(shift_clock, seconds=0),
        plan={"launcher": CLOCK},
    ),
    machine("all processors busy", be_busy, be_idle),
    machine("out of descriptors", take_descriptors, give_descriptors),
    started("as root", "", real_time=True, alone=False),
    started(
        "as an ordinary user",
        AS_USER + '--inh-caps=-all "$@"',
        real_time=False,
        needs_root=False,
    ),
    started(
        "with cap_sys_nice only",
        AS_USER
        + "--inh-caps=-all,+sys_nice --ambient-caps=+sys_nice"
        + ' --bounding-set=-all,+sys_nice "$@"',
        real_time=True,
    ),
    started(
        "as root without cap_sys_nice",
        'exec setpriv --bounding-set=-sys_nice --inh-caps=-sys_nice "$@"',
        real_time=False,
        alone=False,
    ),
]
