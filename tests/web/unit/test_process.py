#  SPDX-License-Identifier: GPL-3.0-or-later
"""The program: command line, guard, signals, exit status."""

import contextlib
import os
import re
import select
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from helpers import LIMIT, WEB, Program, token_file
from parties import await_


class Served(NamedTuple):
    """The program and its supervisor's end of their connection."""

    program: Program
    port: int
    connection: socket.socket


@pytest.fixture
def served(programs: Any, request: pytest.FixtureRequest) -> Iterator[Served]:
    """The gateway has said its first line and been answered. Indirectly: a fault
    that is planted in it."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(LIMIT)
        there = f"127.0.0.1:{listener.getsockname()[1]}"
        planted = getattr(request, "param", "")
        program = programs("--port", "0", "--supervisor", there, planted=planted)
        port = program.port()
        with listener.accept()[0] as connection:
            connection.settimeout(LIMIT)
            assert connection.recv(100) == b"CPST\n"
            connection.sendall(b"AACK\n")
            yield Served(program, port, connection)


def rest(connection: socket.socket) -> bytes:
    """What comes until its end, but for signs of life."""
    data = b""
    ends = time.monotonic() + LIMIT
    with contextlib.suppress(ConnectionResetError):  # something was unread
        while more := connection.recv(100):
            data += more
            assert time.monotonic() < ends
    return data.replace(b"LIVE\n", b"")


def state(process: int) -> str:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return "gone"


def run(*arguments: str) -> tuple[int, str, str]:
    return Program(*arguments).end()


def test_help_and_version() -> None:
    status, out, error = run("--help")
    assert (status, error) == (0, "") and out.startswith("Usage: destijl_web")
    source = WEB.parents[1] / "src" / "common" / "project_version.ads"
    assert source.is_file()
    status, out, error = run("--version")
    number = re.fullmatch(r"destijl_web (\d+\.\d+\.\d+)\n", out)
    assert (status, error) == (0, "") and number is not None
    assert f'"{number[1]}"' in source.read_text()


def test_bad_usage() -> None:
    for arguments in (["--nothing"], ["--bind", "0.0.0.0"], ["--port", "x"]):
        status, out, error = run(*arguments)
        assert (status, out) == (2, "")
        assert error.startswith("destijl_web: ") and error.count("\n") == 1


def test_a_port_that_is_taken() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        status, out, error = run("--port", str(taken.getsockname()[1]))
    assert (status, out) == (1, "")
    assert error.startswith("destijl_web: cannot listen on 127.0.0.1 port ")
    assert error.count("\n") == 1


@pytest.fixture
def hang_up(request: pytest.FixtureRequest) -> Iterator[None]:
    """Ignored, as by nohup, or not, also where these tests are run by it."""
    before = signal.signal(signal.SIGHUP, request.param)
    yield
    signal.signal(signal.SIGHUP, before)


@pytest.mark.parametrize("hang_up", [signal.SIG_DFL], indirect=True)
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
def test_an_orderly_stop(hang_up: None, served: Served, number: signal.Signals) -> None:
    served.program.process.send_signal(number)
    assert rest(served.connection) == b""
    served.connection.close()
    status, out, error = served.program.end()
    assert (status, out) == (0, "")
    assert "Traceback" not in error


@pytest.mark.parametrize("hang_up", [signal.SIG_IGN], indirect=True)
def test_not_stopped_by_an_ignored_hang_up(hang_up: None, served: Served) -> None:
    for process in (served.program.gateway(), served.program.process.pid):
        os.kill(process, signal.SIGHUP)
    signs = b""
    while signs.count(b"LIVE") < 10:
        more = served.connection.recv(100)
        assert more, "it has ended"
        signs += more


def test_stopped_before_it_runs(programs: Any) -> None:
    for delay in (0.05, 0.1, 0.2, 0.4):
        program = programs("--port", "0")
        time.sleep(delay)
        program.process.terminate()
        status, _, error = program.end()
        assert status in (0, -signal.SIGTERM), error
        assert "Traceback" not in error


@pytest.mark.parametrize("number", [signal.SIGSTOP, signal.SIGKILL, signal.SIGSEGV])
def test_a_gateway_that_hangs_or_dies(served: Served, number: signal.Signals) -> None:
    """Its connection ends, so that the supervisor stops the robot."""
    os.kill(served.program.gateway(), number)
    assert rest(served.connection) == b""
    status, _, error = served.program.end()
    assert status == 3
    assert "Traceback" not in error
    if number == signal.SIGSTOP:
        assert "no sign of life for 1.0 s" in error


@pytest.mark.parametrize(
    "served", ["supervisor._Session.connection_lost = lambda *_: 1 / 0"], indirect=True
)
def test_a_gateway_that_believes_to_be_connected(served: Served) -> None:
    served.connection.close()
    status, _, error = served.program.end()
    assert status == 3
    assert "says that it has a supervisor, and has none" in error
    assert "no sign of life" in error


def test_a_gateway_without_a_processor(served: Served) -> None:
    """It is not killed. Without its signs of life the supervisor stops the robot."""
    gateway = served.program.gateway()
    processor = max(os.sched_getaffinity(gateway))
    os.sched_setaffinity(gateway, {processor})
    os.sched_setscheduler(gateway, os.SCHED_IDLE, os.sched_param(0))
    #  64 processes of one group
    work = f"import os; os.sched_setaffinity(0, {{{processor}}})"
    work += "; [os.fork() for _ in range(6)]\nwhile True: pass"
    busy = subprocess.Popen([sys.executable, "-c", work], process_group=0)
    end = time.monotonic() + LIMIT
    try:
        while select.select([served.connection], [], [], 2.0)[0]:
            assert served.connection.recv(1000)
            if time.monotonic() > end:
                pytest.skip("it always has a processor")
    finally:
        os.killpg(busy.pid, signal.SIGKILL)
        busy.wait()
    assert served.connection.recv(1000)
    assert served.program.process.poll() is None


@pytest.mark.parametrize(
    "served",
    ["supervisor._Session.watch = lambda *_: exec('while True: pass')"],
    indirect=True,
)
def test_a_gateway_that_is_busy_for_ever(served: Served) -> None:
    assert rest(served.connection) == b""
    assert "no sign of life" in served.program.end()[2]


@pytest.mark.timed
def test_a_hang_is_not_seen_too_early(served: Served) -> None:
    """It is counted from the last sign of life."""
    begun = time.monotonic()
    os.kill(served.program.gateway(), signal.SIGSTOP)
    assert rest(served.connection) == b""
    assert time.monotonic() - begun > 0.35


def test_no_gateway_without_its_guard(served: Served) -> None:
    gateway = served.program.gateway()
    served.program.process.kill()
    await_(lambda: state(gateway) in ("gone", "Z"), "it has ended")
    assert rest(served.connection) == b""


def test_not_stopped_by_the_terminal(programs: Any) -> None:
    """Ctrl-Z would leave the robot driving."""
    program = programs("--port", "0")
    program.address()
    for process in (program.gateway(), program.process.pid):
        os.kill(process, signal.SIGTSTP)
    time.sleep(0.2)
    for process in (program.gateway(), program.process.pid):
        assert state(process) not in ("T", "gone")


def test_tokens_are_not_shown(programs: Any, tmp_path: Path) -> None:
    token = token_file(tmp_path, "very-secret-token")
    viewers = token_file(tmp_path, "less-secret-token")
    program = programs("--port", "0", "--token", token, "--viewers-token", viewers)
    port = program.port()
    command = Path(f"/proc/{program.gateway()}/cmdline").read_bytes()
    assert b"very-secret" not in command.replace(token.encode(), b"")
    body = b"token=nearly-secret"
    with socket.create_connection(("127.0.0.1", port), LIMIT) as client:
        client.sendall(
            b"POST /login HTTP/1.1\r\nHost: 127.0.0.1:%d\r\n"
            b"Content-Type: application/x-www-form-urlencoded\r\n"
            b"Content-Length: %d\r\n\r\n%s" % (port, len(body), body)
        )
        assert client.recv(100).startswith(b"HTTP/1.1 303")
    program.process.terminate()
    status, out, error = program.end()
    assert status == 0
    assert "wrong token" in error
    assert "secret" not in out + error


def test_a_flood_of_connections(served: Served) -> None:
    """Connections that say nothing keep nobody out."""
    there = ("127.0.0.1", served.port)
    idle = [socket.create_connection(there) for _ in range(600)]
    for one in idle:
        one.setblocking(False)

    def is_open(one: socket.socket) -> bool:
        try:
            return one.recv(1) != b""
        except BlockingIOError:
            return True
        except ConnectionResetError:
            return False

    await_(lambda: sum(map(is_open, idle)) <= 450, "the oldest are closed")
    host = f"localhost:{served.port}".encode()
    with socket.create_connection(there, LIMIT) as client:
        client.sendall(b"GET /recordings HTTP/1.1\r\nHost: %s\r\n\r\n" % host)
        assert client.recv(100).startswith(b"HTTP/1.1 404")
    for one in idle:
        one.close()
    assert served.program.process.poll() is None
