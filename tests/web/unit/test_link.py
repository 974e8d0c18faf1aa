#  SPDX-License-Identifier: GPL-3.0-or-later
"""The connection to the supervisor: lost, refused, made anew."""

import asyncio
import base64
import os
import socket
from typing import Any

import pytest
from destijl_web import exchange, peers, supervisor
from helpers import LIMIT, World, jpeg, until, world


async def test_connects_again(w: World) -> None:
    page = await w.driver()
    await w.start_robot(page)
    await page.order("COPN")
    for _ in range(3):
        w.supervisor.hang_up()
        await page.event("supervisor_lost")
        await page.event("supervisor_connected")
        await page.settle()
        state = w.service.hub.state
        assert (state["robot"], state["camera"]) == ("closed", False)
        assert state["driver"] == page.number
        assert (await page.order("ROPN"))["answer"] == "AACK"


async def test_shows_that_it_lives(w: World) -> None:
    """From the beginning of each session on, again and again."""
    for _ in range(2):
        await w.connected()
        w.supervisor.signs = 0
        await until(lambda: w.supervisor.signs > 3)
        w.supervisor.hang_up()
        await until(lambda: w.service.hub.state["supervisor"] != "connected")


async def test_waits_for_its_supervisor(w: World) -> None:
    page = await w.page()
    await w.supervisor.stop()
    await page.event("supervisor_lost")
    await asyncio.sleep(3 * supervisor.FIRST_PAUSE)
    assert w.service.hub.state["supervisor"] == "connecting"
    await w.supervisor.start()
    await page.event("supervisor_connected")


@pytest.mark.world(supervisor_token="secret-of-tests", token="secret-of-tests")
async def test_token(w: World) -> None:
    assert w.supervisor.refusal is None


@pytest.mark.world(token="secret-of-tests")
async def test_a_token_that_nobody_asks_for(w: World) -> None:
    assert w.supervisor.lines[0] == "AUTH:secret-of-tests"
    await w.connected()


@pytest.mark.parametrize("token", [None, "wrong-token"])
async def test_refused(token: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(supervisor, "LONGEST_PAUSE", LIMIT)
    async with world(
        supervisor_token="secret-of-tests", token=token, connected=False
    ) as w:
        hub = w.service.hub
        await until(lambda: hub.state["supervisor"] == "refused")
        event = hub._events[-1]
        assert event["code"] == "supervisor_refused"
        assert event["args"] == {"reason": "not authenticated"}
        await asyncio.sleep(2 * supervisor.FIRST_PAUSE)
        #  not again and again
        assert w.supervisor.connections == 1
        assert len(hub._events) == 1


async def test_another_monitor_first(w: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(supervisor, "LONGEST_PAUSE", 0.2)
    page = await w.page()
    w.supervisor.refusal = b"another monitor is connected"
    w.supervisor.hang_up()
    await page.event("supervisor_refused", reason="another monitor is connected")
    await page.state(supervisor="refused")
    w.supervisor.refusal = None
    await page.event("supervisor_connected")


@pytest.mark.parametrize(
    "said", [b"HTTP/1.0 400 Bad Request\r\n", b"SSH-2.0-OpenSSH\r\n", b"\n", b"AACKS\n"]
)
async def test_no_supervisor(said: bytes) -> None:
    come = 0

    def serve(_: Any, writer: asyncio.StreamWriter) -> None:
        nonlocal come
        come += 1
        writer.write(said)

    server = await asyncio.start_server(serve, "127.0.0.1", 0)
    async with world() as w, server:
        w.service.hub.link._port = server.sockets[0].getsockname()[1]
        w.supervisor.hang_up()
        await until(lambda: come > 1)
        assert w.service.hub.state["supervisor"] == "connecting"


async def test_unanswered(w: World, monkeypatch: pytest.MonkeyPatch) -> None:
    page = await w.driver()
    w.supervisor.answers["RPIN"] = None
    await page.say("order", id=7, label="RPIN")
    await w.supervisor.heard("RPIN")
    with monkeypatch.context() as late:
        late.setattr(exchange, "ROBOT_LIMIT", 0.0)
        w.service.hub.tick()
    event = await page.event("unanswered", label="RPIN")
    assert event["level"] == "error"
    await page.expect("answer", id=7, answer="NOLINK")
    await page.event("supervisor_lost")
    await page.event("supervisor_connected")
    assert w.supervisor.connections == 2
    w.supervisor.answers["RPIN"] = b"AACK"
    assert (await page.order("RPIN"))["answer"] == "AACK"


async def test_a_line_without_end(w: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(supervisor, "MAX_LINE", 100_000)
    page = await w.page()
    w.supervisor.send_raw(b"CIMG:" + b"A" * 200_000)
    await page.event("supervisor_lost")
    await page.event("supervisor_connected")


async def test_an_image_before_the_search_is_not_its_answer(w: World) -> None:
    """An image that the supervisor sent before it read the order arrives after
    the order was sent."""
    page = await w.driver()
    await page.order("COPN")
    w.supervisor.answers |= {"CPST": None, "CASA": None}
    await page.say("order", id=7, label="CASA")
    await w.supervisor.heard("CASA")
    w.supervisor.send_image(1)
    assert await page.image() == jpeg(1)
    assert w.service.hub.state["arena"] == "none"
    w.supervisor.send(b"AACK")
    w.supervisor.send(b"CIMG:" + base64.b64encode(jpeg(2)))
    await page.expect("answer", id=7, answer="CIMG")
    assert await page.image() == jpeg(2)
    await page.settle()
    assert w.service.hub.state["arena"] == "found"


async def test_the_search_leaves_positions_on(w: World) -> None:
    page = await w.driver()
    for label in ("COPN", "CPCO", "CASA"):
        await page.order(label)
    assert w.supervisor.lines[-2:] == ["CPCO", "CASA"]
    assert w.service.hub.state["positions"] is True


LISTENER = """
import select, socket, time
with socket.create_server(("127.0.0.1", 0)) as made:
    print(made.getsockname()[1], flush=True)
    select.select([made], [], [])
    time.sleep(0.2)  #  nobody's until it is accepted
    print(made.accept()[0].makefile().readline().strip(), flush=True)
"""


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can be other users")
@pytest.mark.parametrize(
    "user, trusted",
    [(0, True), (65000, True), (33, False), (1000, False), (65534, False)],
)
async def test_no_token_for_another_user(
    user: int, trusted: bool, caplog: pytest.LogCaptureFixture
) -> None:
    """Who listens while the supervisor does not. 65000: of a service."""
    listener = await asyncio.create_subprocess_exec(
        *("setpriv", f"--reuid={user}", "--clear-groups"),
        *("/usr/bin/python3", "-Ic", LISTENER),
        stdout=asyncio.subprocess.PIPE,
    )
    assert listener.stdout is not None
    async with world(token="secret-of-tests") as w:
        w.service.hub.link._port = int(await listener.stdout.readline())
        w.supervisor.hang_up()
        said = (await listener.stdout.readline()).decode().strip()
        assert said == ("AUTH:secret-of-tests" if trusted else "")
        if not trusted:
            text = f"a program of user {user} listens there; it is not told the token"
            await until(lambda: text in caplog.text)
        await listener.wait()


async def test_no_token_for_nobody(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """Who has not accepted the connection may be anybody, or elsewhere."""
    monkeypatch.setattr(peers, "ACCEPT_LIMIT", 0.2)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        async with world(token="secret-of-tests") as w:
            w.service.hub.link._port = listener.getsockname()[1]
            w.supervisor.hang_up()
            await until(lambda: "does not accept a connection" in caplog.text)
            assert listener.accept()[0].recv(100) == b""
