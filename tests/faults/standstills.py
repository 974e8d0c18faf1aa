#  SPDX-License-Identifier: GPL-3.0-or-later
"""Detects stalls of this machine's processors, whatever their cause: the host of a
virtual machine or a limit on a container. A process on each processor wakes up every
few milliseconds, with a priority above the supervisor's, if permitted; another sends
a byte through a pseudo-terminal, as the kernel's threads that carry such bytes have no
priority, and one list of work for all pseudo-terminals."""

import contextlib
import mmap
import multiprocessing
import os
import pty
import select
import time
import tty
from collections.abc import Callable, Iterator
from typing import Any

SPAN = 0.005
#  Seconds between two looks
NOTED = 0.000_5
#  A stall is noted from then on
KEPT = 8192
#  Of the newest stalls of each
ABOVE_SUPERVISOR = 60
TOO_LONG = 0.02
TOO_MUCH = 0.05
#  For a robot that has 80 ms to answer: the longest single stall, and the time stolen
#  by the host from all processors together


def prefer_real_time(priority: int = ABOVE_SUPERVISOR) -> bool:
    """For the calling thread and those that it starts, where it is permitted, which is
    told; 0: an ordinary one again."""
    policy = os.SCHED_FIFO if priority else os.SCHED_OTHER
    with contextlib.suppress(PermissionError):
        os.sched_setscheduler(0, policy, os.sched_param(priority))
        return True
    return False


def host_taken() -> float:
    """Seconds of all processors since boot that the host of a virtual machine has
    taken for others."""
    with open("/proc/stat", encoding="ascii") as file:
        return int(file.readline().split()[8]) * 0.01


class Ring:
    """Stalls, shared with other processes: how many, when the one under way began
    or 0, and the looks between which each was. span: between two others."""

    def __init__(self, span: float = 0.0) -> None:
        self._span = span
        shared = mmap.mmap(-1, 16 * (KEPT + 1))
        self.view: Any = memoryview(shared).cast("d")

    def begin(self, begun: float) -> None:
        self.view[1] = begun

    def add(self, start: float, end: float) -> None:
        self.view[1] = 0.0
        if end - start - self._span >= NOTED:
            place = 2 + 2 * (int(self.view[0]) % KEPT)
            self.view[place], self.view[place + 1] = start, end
            self.view[0] += 1

    def since(self, begun: float) -> Iterator[tuple[float, float]]:
        numbers = self.view[2 : 2 + 2 * min(KEPT, int(self.view[0]))].tolist()
        pairs = zip(numbers[::2], numbers[1::2], strict=True)
        return ((start, end) for start, end in pairs if end > begun)

    def longest(self, since: float) -> float:
        """Or what is under way."""
        stalls = [end - start - self._span for start, end in self.since(since)]
        begun = float(self.view[1])
        return max(time.monotonic() - begun if begun else 0.0, *stalls, 0.0)


class Watch:
    """For this process and those that it forks afterwards."""

    def __init__(self) -> None:
        self._processors: list[Ring] = []
        self._line = Ring()
        self._since = 0.0
        for processor in os.sched_getaffinity(0):
            self._processors.append(Ring(SPAN))
            self._start(_watch_processor, self._processors[-1], processor)
        self._start(_watch_line, self._line)

    @staticmethod
    def _start(look: Callable[..., Iterator[None]], *arguments: object) -> None:
        def run() -> None:
            parent = os.getppid()
            prefer_real_time(ABOVE_SUPERVISOR + 1)
            for _ in look(*arguments):
                if os.getppid() != parent:
                    return

        multiprocessing.get_context("fork").Process(target=run, daemon=True).start()

    def forget(self) -> None:
        self._since = time.monotonic()

    @property
    def longest(self) -> float:
        """Stall of a processor since forget."""
        return max(ring.longest(self._since) for ring in self._processors)

    @property
    def longest_line(self) -> float:
        """That a byte took."""
        return self._line.longest(self._since)

    def within(self, start: float, end: float) -> float:
        """For how much of that time a processor, or a byte, may have stood still."""
        result = 0.0
        rings = (*self._processors, self._line)
        for since, until in sorted(
            pair for ring in rings for pair in ring.since(start)
        ):
            if since < end and until > start:
                result += min(end, until) - max(start, since)
                start = min(end, until)
        return result

    def await_calm(self, limit: float) -> None:
        """A while without stalls, limit at most; forgets."""
        end = time.monotonic() + limit
        while time.monotonic() < end:
            self.forget()
            host = host_taken()
            time.sleep(2.0)
            calm = max(self.longest, self.longest_line) < TOO_LONG
            if calm and host_taken() - host < TOO_MUCH:
                return


def _watch_processor(ring: Ring, processor: int) -> Iterator[None]:
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, {processor})
    while True:
        before = time.monotonic()
        time.sleep(SPAN)
        ring.add(before, time.monotonic())
        yield


def _watch_line(ring: Ring) -> Iterator[None]:
    robot, device = pty.openpty()
    tty.setraw(device)
    poll = select.poll()
    poll.register(robot, select.POLLIN)
    while True:
        begun = time.monotonic()
        ring.begin(begun)
        os.write(device, b"x")
        if poll.poll(10_000):
            now = time.monotonic()
            os.read(robot, 1)
            ring.add(begun, now)
        time.sleep(SPAN)
        yield
