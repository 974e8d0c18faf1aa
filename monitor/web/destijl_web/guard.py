#  SPDX-License-Identifier: GPL-3.0-or-later
"""The guard: a process that starts the gateway, and kills it if it hangs.

A gateway that hangs shows the supervisor no sign of life, which stops the
robot. When it is killed, another can begin, and the kernel closes the
connection to a supervisor that does not watch these signs."""

import contextlib
import ctypes
import fcntl
import os
import select
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import FrameType

BEAT = 0.1
#  Seconds between two signs of life

PATIENCE = 10
#  So many times BEAT without one is a hang. Only time that the gateway has had
#  counts: none while the machine is suspended or has no processor for it

START_LIMIT = 60.0
#  Seconds to the first sign of life: start-up from a slow disk is slow

STOP_LIMIT = 6.0
#  Seconds for an orderly stop

ENDS = [signal.SIGTERM, signal.SIGINT]
if signal.getsignal(signal.SIGHUP) is not signal.SIG_IGN:
    ENDS.append(signal.SIGHUP)
#  Signals that end it in order. A hang-up that is ignored, as by nohup, stays so

_PR_SET_PDEATHSIG = 1
_SMALLEST_PIPE = 4096


def run(gateway: Callable[[int], int]) -> int:
    """Runs gateway in a separate process, with the end of the pipe for its
    signs of life. Returns the exit status for the program."""
    listening, beating = os.pipe()
    fcntl.fcntl(beating, fcntl.F_SETPIPE_SZ, _SMALLEST_PIPE)
    os.set_blocking(beating, False)
    #  Ctrl-Z would stop guard and gateway, and the robot would keep driving
    signal.signal(signal.SIGTSTP, signal.SIG_IGN)
    own = os.getpid()
    child = os.fork()
    if child == 0:
        os.close(listening)
        _end(_be_gateway(gateway, beating, own))
    os.close(beating)
    return _Guard(child, listening).watch()


def beat(heart: int) -> None:
    """A sign of life, from the gateway. Raises OSError if the guard has ended
    or hangs."""
    os.write(heart, b".")


def _be_gateway(gateway: Callable[[int], int], heart: int, guard: int) -> int:
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != guard:
        return 3
    try:
        return gateway(heart)
    except KeyboardInterrupt:
        return 0
    except Exception as error:  # noqa: BLE001, for the user a line, no traceback
        print(f"destijl_web: failure: {type(error).__name__}: {error}", file=sys.stderr)
        return 3


def _end(status: int) -> None:
    #  At once: does not wait for a thread that waits for a disk
    with contextlib.suppress(OSError):
        sys.stdout.flush()
        sys.stderr.flush()
    os._exit(status)


class _Guard:
    def __init__(self, child: int, listening: int) -> None:
        self._child = child
        self._listening = listening
        self._stop_asked: float | None = None
        self._killed = False
        self._ran = 0.0
        for number in ENDS:
            signal.signal(number, self._pass_on)

    def watch(self) -> int:
        poll = select.poll()
        poll.register(self._listening, select.POLLIN)
        begun = time.monotonic()
        alive = False
        silent = 0.0
        while True:
            if poll.poll(BEAT * 1000):
                if not os.read(self._listening, _SMALLEST_PIPE):
                    return self._buried()
                alive = True
                silent = 0.0
            else:
                silent += self._had()
            now = time.monotonic()
            if self._stop_asked is not None and now - self._stop_asked > STOP_LIMIT:
                self._kill("does not stop")
            elif alive and silent >= PATIENCE:
                self._kill(f"has shown no sign of life for {PATIENCE * BEAT:.1f} s")
            elif not alive and now - begun > START_LIMIT:
                self._kill("does not start")

    def _had(self) -> float:
        """Which part of a BEAT the gateway could use: while it waits for a processor
        (R) or its memory (D), that in which it ran."""
        stat = Path(f"/proc/{self._child}/task/{self._child}/stat").read_text()
        state, *fields = stat.rpartition(")")[2].split()
        ran = (int(fields[10]) + int(fields[11])) / os.sysconf("SC_CLK_TCK")
        had = (ran - self._ran) / BEAT
        self._ran = ran
        return min(had, 1.0) if state in "RD" else 1.0

    def _pass_on(self, number: int, frame: FrameType | None) -> None:
        if self._stop_asked is None:
            self._stop_asked = time.monotonic()
        with contextlib.suppress(ProcessLookupError):
            os.kill(self._child, signal.SIGTERM)

    def _kill(self, why: str) -> None:
        if not self._killed:
            self._killed = True
            os.kill(self._child, signal.SIGKILL)
            print(f"destijl_web: the gateway {why}: killed", file=sys.stderr)

    def _buried(self) -> int:
        #  The pipe ends just before the process
        for ignored in ENDS:
            signal.signal(ignored, signal.SIG_IGN)
        _, status = os.waitpid(self._child, 0)
        if self._killed:
            return 3
        if os.WIFEXITED(status):
            return os.WEXITSTATUS(status)
        number = os.WTERMSIG(status)
        if self._stop_asked is not None and number == signal.SIGTERM:
            return 0  # before it could listen to signals
        print(f"destijl_web: the gateway was ended by signal {number}", file=sys.stderr)
        return 3
