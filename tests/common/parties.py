#  SPDX-License-Identifier: GPL-3.0-or-later
"""The parties of a test in Python, each a process of its own: the emulated robot
with its arena camera, and the supervisor."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ROOT / "bin"

LIMIT = 30.0
#  Seconds for what has no limit of its own: reached by a test that fails


def ran(*command: str | Path, **how: Any) -> tuple[int, str]:
    """A command's status, and what it says, also of errors. how: subprocess.run's."""
    how = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, **how}
    done = subprocess.run(command, text=True, check=False, **how)
    return done.returncode, done.stdout


def fact(process: int, key: str) -> int:
    """From the process's status: 0 when there is none."""
    with contextlib.suppress(OSError):
        status = Path(f"/proc/{process}/status").read_text(encoding="ascii")
        if found := re.search(rf"^{key}:\s*(\d+)", status, re.M):
            return int(found[1])
    return 0


def await_(
    condition: Callable[[], Any],
    what: str | Callable[[], str],
    within: float = LIMIT,
    every: float = 0.02,
) -> Any:
    """The first true value of condition; what: that it did not become so."""
    end = time.monotonic() + within
    while True:
        late = time.monotonic() > end
        value = condition()
        if value:
            return value
        if late:
            what = what if isinstance(what, str) else what()
            raise AssertionError(f"not within {within:.3f} s: {what}")
        time.sleep(every)


class Child:
    """A process whose lines are kept."""

    def __init__(self, *command: str | Path, before: Sequence[str | Path] = ()) -> None:
        self.name = Path(command[0]).name
        self.process = subprocess.Popen(
            [*before, *command],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            bufsize=1,
            cwd=ROOT,
        )
        self.lines: list[str] = []
        self._said_all = False
        self._news = threading.Condition()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            if line.startswith("late by "):
                continue  # the emulator's line: no answer to a question
            with self._news:
                self.lines.append(line.rstrip("\n"))
                self._news.notify_all()
        with self._news:
            self._said_all = True
            self._news.notify_all()

    def _found(self, pattern: str, after: int, within: float) -> re.Match[str] | None:
        def found() -> re.Match[str] | None:
            return next(
                filter(None, (re.search(pattern, x) for x in self.lines[after:])), None
            )

        with self._news:
            self._news.wait_for(lambda: found() or self._said_all, within)
            return found()

    def line(
        self, pattern: str, after: int = 0, within: float = LIMIT
    ) -> re.Match[str]:
        """The first of its lines, from number after on, with pattern."""
        match = self._found(pattern, after, within)
        assert match, f"no line with {pattern!r} within {within} s of {self.account}"
        return match

    def says(self, text: str, within: float = 0.0, after: int = 0) -> bool:
        return self._found(re.escape(text), after, within) is not None

    def write(self, line: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    @property
    def account(self) -> str:
        """Its last lines, told where a test fails."""
        return "\n".join([f"{self.name}:", *self.lines[-20:]])

    def precede_others(self) -> None:
        """Where that is permitted. Each of its threads by itself: an Ada task does
        not inherit how its process is scheduled."""
        with contextlib.suppress(PermissionError):
            for process in (self.process.pid, *self.children):
                for name in os.listdir(f"/proc/{process}/task"):
                    if os.sched_getscheduler(int(name)) == os.SCHED_OTHER:
                        lowest = os.sched_param(1)
                        os.sched_setscheduler(int(name), os.SCHED_FIFO, lowest)

    @property
    def children(self) -> list[int]:
        path = f"/proc/{self.process.pid}/task/{self.process.pid}/children"
        return [int(word) for word in Path(path).read_text(encoding="ascii").split()]

    def end(self) -> None:
        """It has not ended before, and does so in order."""
        assert self.process.poll() is None, f"it has ended: {self.account}"
        self.process.terminate()
        try:
            status = self.process.wait(LIMIT)
        except subprocess.TimeoutExpired:
            self.kill()
            raise
        assert status in (0, -signal.SIGTERM), f"{status}: {self.account}"

    def kill(self) -> None:
        self.process.kill()
        self.process.wait()


@dataclass
class Note:
    """A command on the robot's line: seconds of its first byte and its last."""

    first: float
    last: float
    command: str
    answer: str


class Emulator(Child):
    def __init__(self, line_at: Path, line: str, *options: str) -> None:
        """Its line: a socket or a link to a terminal."""
        self.line_at = line_at
        super().__init__(
            PROGRAMS / "destijl_emulator",
            *(f"--{line}", line_at, "--camera-port", "0", "--boot-ms", "100"),
            *options,
        )
        self.camera = self.line("^camera (.*)")[1]
        self._lock = threading.Lock()

    def ask(self, command: str) -> str:
        with self._lock:
            before = len(self.lines)
            self.write(command)
            return self.line("", before).string

    def status(self) -> dict[str, str]:
        return dict(word.split("=", 1) for word in self.ask("status").split())

    @property
    def pose(self) -> tuple[float, float, float]:
        """Centimetres, degrees."""
        now = self.status()
        return float(now["x"]), float(now["y"]), float(now["heading"])

    @property
    def moving(self) -> bool:
        return self.status()["moving"] == "1"

    def journal(self) -> list[Note]:
        with self._lock:
            before = len(self.lines)
            self.write("journal")
            self.line("^end$", before)
            noted = [
                dict(word.partition("=")[::2] for word in line.split())
                for line in self.lines[before:]
                if line.startswith("first=")
            ]
        return [
            Note(float(n["first"]), float(n["last"]), n["command"], n["answer"])
            for n in noted
        ]


class Supervisor(Child):
    def __init__(
        self,
        line_at: Path,
        *options: str | Path,
        launcher: Sequence[str | Path] = (),
        program: Path = PROGRAMS / "destijl",
        listens: bool = True,
    ) -> None:
        """Listens: it is waited for until it says so."""
        preloaded: list[str | Path] = []
        if line_at.is_socket():
            #  a copy in the line's folder: in this list a blank separates
            library = line_at.with_name("socket_line.so")
            if not library.exists():
                shutil.copy(PROGRAMS / "libsocket_line.so", library)
            preloaded = ["env", f"LD_PRELOAD={library}"]
        super().__init__(
            program,
            "--serial",
            line_at,
            *options,
            before=[*preloaded, *launcher],
        )
        self.port = 0
        if listens:
            self.port = int(self.line(r"listening on .*:(\d+)")[1])
