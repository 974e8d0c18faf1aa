#  SPDX-License-Identifier: GPL-3.0-or-later
"""A supervisor that says what a test wants, and pages that drive."""

import asyncio
import base64
import contextlib
import json
import os
import re
import select
import socket
import subprocess
import sys
from collections.abc import AsyncIterator, Callable, Iterable
from pathlib import Path
from typing import Any

import aiohttp
import pytest
from destijl_web.options import Options
from destijl_web.server import Service
from parties import ROOT

LIMIT = 30.0
#  Seconds for what is to happen at once: reached by a test that fails

TEST_LIMIT = 120.0

WEB = ROOT / "monitor" / "web"

Json = dict[str, Any]

UPGRADE = (
    *("Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13"),
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
)
#  Of a request, to a WebSocket

TOKENS: Json = {"token": "secret-of-teacher", "viewers_token": "secret-of-viewers"}


def jpeg(number: int, size: int = 1000) -> bytes:
    """Not a picture, but it begins as one, and is known by its number."""
    return b"\xff\xd8" + number.to_bytes(4, "big") + bytes(size - 6)


def number_of(image: bytes) -> int:
    return int.from_bytes(image[2:6], "big")


async def until(condition: Callable[[], Any]) -> None:
    async with asyncio.timeout(LIMIT):
        while not condition():
            await asyncio.sleep(0.01)


GROUND = (
    b"CARN:80;60;8;100.000000;50.000000;540.000000;60.000000"
    b";600.000000;420.000000;40.000000;400.000000"
)
#  80 by 60 cm, tilted; points keep 8 cm from the border


class Supervisor:
    """One monitor at a time, as the real one. Answers: for each label its
    answer; None is silence."""

    def __init__(self, token: str | None = None) -> None:
        self.answers: dict[str, bytes | None] = {
            "AUTH": b"ACER",
            "RGBT": b"RBLV:2",
            "RGST": b"RCST:0",
            "RVER": b"RVER:3.5",
            "CASA": b"CIMG:" + base64.b64encode(jpeg(999)),
            "CACO": None,
            "CAIN": None,
            "CARN": GROUND,
        }
        self.lines: list[str] = []
        #  without its signs of life, which are counted
        self.signs = 0
        self.connections = 0
        self.refusal: bytes | None = None
        #  bound for the whole test: nobody else is given its port meanwhile
        self._bound = socket.socket()
        self._bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self._bound.bind(("127.0.0.1", 0))
        self.port: int = self._bound.getsockname()[1]
        self._token = token
        self._server: asyncio.Server | None = None
        self._writer: asyncio.StreamWriter | None = None

    async def start(self) -> None:
        self._server = await asyncio.start_server(self._serve, "127.0.0.1", self.port)

    async def stop(self) -> None:
        assert self._server is not None
        self._server.close()
        self.hang_up()

    def forget(self) -> None:
        self._bound.close()

    def hang_up(self) -> None:
        if self._writer is not None:
            self._writer.close()
            self._writer = None

    def send(self, *lines: bytes) -> None:
        self.send_raw(b"".join(line + b"\n" for line in lines))

    def send_raw(self, data: bytes) -> None:
        assert self._writer is not None
        self._writer.write(data)

    def send_image(self, number: int, size: int = 1000) -> None:
        self.send(b"CIMG:" + base64.b64encode(jpeg(number, size)))

    def count(self, line: str) -> int:
        return self.lines.count(line)

    async def heard(self, line: str, times: int = 1) -> None:
        await until(lambda: self.count(line) >= times)

    async def _serve(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        with contextlib.suppress(ConnectionError):
            self.connections += 1
            if self._token is not None:
                first = (await reader.readline()).decode().strip()
                if first != f"AUTH:{self._token}":
                    self.refusal = b"not authenticated"
            if self.refusal is not None:
                writer.write(b"MSSG:refused: " + self.refusal + b"\n")
                writer.close()
                return
            self._writer = writer
            while line := (await reader.readline()).decode().rstrip("\n"):
                if line == "LIVE":
                    self.signs += 1
                    continue
                answer = self.answers.get(line[:4], b"AACK")
                self.lines.append(line)
                if answer is not None:
                    writer.write(answer + b"\n")
            self.lines.append("end")
            writer.close()


class Page:
    """What a browser's page does."""

    def __init__(self, ws: aiohttp.ClientWebSocketResponse) -> None:
        self.ws = ws
        self.said: list[Json] = []
        self._new: list[Json] = []
        self.images: list[bytes] = []
        self.welcome: Json = {}
        self.acknowledges = True
        self._orders = 0
        self._code: int | None = None

    @property
    def number(self) -> int:
        return int(self.welcome["you"])

    async def say(self, kind: str, **fields: Any) -> None:
        await self.ws.send_str(json.dumps({"type": kind, **fields}))

    async def wheel(self, do: str, **fields: Any) -> None:
        await self.say("wheel", do=do, **fields)

    async def order(self, label: str, **fields: Any) -> Json:
        """Its answer."""
        self._orders += 1
        number = self._orders
        await self.say("order", id=number, label=label, **fields)
        return await self.expect("answer", id=number)

    async def receive(self) -> Json | bytes | None:
        """The next message; None: closed."""
        received = await self.ws.receive()
        if received.type is aiohttp.WSMsgType.BINARY:
            self.images.append(received.data)
            if self.acknowledges:
                await self.say("seen")
            return bytes(received.data)
        if received.type is aiohttp.WSMsgType.TEXT:
            said: Json = json.loads(received.data)
            self.said.append(said)
            self._new.append(said)
            return said
        #  its close_code is another one if the answer comes too late
        closed = received.type is aiohttp.WSMsgType.CLOSE
        self._code = received.data if closed else self.ws.close_code
        return None

    async def expect(self, kind: str, **fields: Any) -> Json:
        """The first message of that kind that has these fields, and that has
        not been returned yet."""
        wanted = {"type": kind, **fields}
        async with asyncio.timeout(LIMIT):
            while True:
                for said in self._new:
                    if wanted == {n: said.get(n) for n in wanted}:
                        self._new.remove(said)
                        return said
                got = await self.receive()
                assert got is not None, f"closed: {self.ws.close_code}"

    async def event(self, code: str, **args: Any) -> Json:
        while True:
            got = await self.expect("event", code=code)
            if all(got["args"].get(n) == v for n, v in args.items()):
                return got

    async def state(self, **fields: Any) -> Json:
        return await self.expect("state", **fields)

    async def image(self) -> bytes:
        async with asyncio.timeout(LIMIT):
            while True:
                got = await self.receive()
                assert got is not None
                if isinstance(got, bytes):
                    return got

    async def closed(self) -> int | None:
        async with asyncio.timeout(LIMIT):
            while await self.receive() is not None:
                pass
        return self._code

    async def settle(self) -> None:
        """All that the gateway had to say until now has come."""
        number = 10**6 + len(self.said)
        await self.say("ping", n=number, hidden=False)
        await self.expect("pong", n=number)

    async def close(self) -> None:
        await self.ws.close()


class Clock:
    """The hub's event loop, whose time stands still but for what a test lets pass:
    no page is silent because the machine is slow."""

    def __init__(self) -> None:
        self._loop = asyncio.get_running_loop()
        self.now = self._loop.time()

    def time(self) -> float:
        return self.now

    def __getattr__(self, name: str) -> Any:
        return getattr(self._loop, name)


class World:
    """Supervisor and gateway."""

    def __init__(self, supervisor: Supervisor, service: Service) -> None:
        self.supervisor = supervisor
        self.service = service
        self._clients: list[aiohttp.ClientSession] = []
        self._pages: list[Page] = []
        #  one that nobody has any more is closed
        self._clock: Any = Clock()
        service.hub._loop = self._clock

    def pass_time(self, seconds: float) -> None:
        self._clock.now += seconds
        #  the first may take it for a stand-still of the machine
        for _ in range(2):
            self.service.hub.tick()

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.service.port}"

    def client(self) -> aiohttp.ClientSession:
        """A browser, with cookies of its own."""
        client = aiohttp.ClientSession(
            connector=aiohttp.TCPConnector(limit=0),
            cookie_jar=aiohttp.CookieJar(unsafe=True),
        )
        self._clients.append(client)
        return client

    def request(self, line: str, *further: str) -> bytes:
        """Without its last line."""
        lines = (f"{line} HTTP/1.1", f"Host: 127.0.0.1:{self.service.port}", *further)
        return "".join(one + "\r\n" for one in lines).encode()

    async def raw(self, pieces: Iterable[bytes]) -> bytes:
        """What is answered to these, until the gateway closes."""
        reader, writer = await asyncio.open_connection("127.0.0.1", self.service.port)
        async with asyncio.timeout(LIMIT):
            try:
                for piece in pieces:
                    writer.write(piece)
                    await writer.drain()
                return await reader.read()
            except ConnectionError:
                return b""
            finally:
                writer.close()

    async def page(self, client: aiohttp.ClientSession | None = None) -> Page:
        client = client or self.client()
        ws = await client.ws_connect(f"{self.url}/ws", origin=self.url)
        page = Page(ws)
        self._pages.append(page)
        page.welcome = await page.expect("welcome")
        return page

    async def log_in(
        self, token: str, client: aiohttp.ClientSession | None = None, /, **headers: str
    ) -> aiohttp.ClientResponse:
        """What is answered."""
        async with (client or self.client()).post(
            f"{self.url}/login",
            data={"token": token},
            headers=headers,
            allow_redirects=False,
        ) as answer:
            return answer

    async def logged_in(self, token: str) -> aiohttp.ClientSession:
        client = self.client()
        assert (await self.log_in(token, client)).headers["Location"] == "/"
        return client

    async def status(self, path: str, **headers: str) -> int:
        async with self.client().get(self.url + path, headers=headers) as answer:
            return answer.status

    async def refused(
        self, client: aiohttp.ClientSession, origin: str | None = "", /, **headers: str
    ) -> int:
        """The status with which it gets no connection."""
        with pytest.raises(aiohttp.WSServerHandshakeError) as reason:
            await client.ws_connect(
                f"{self.url}/ws",
                origin=self.url if origin == "" else origin,
                headers=headers,
            )
        return reason.value.status

    async def pupil(self) -> Page:
        return await self.page(await self.logged_in(TOKENS["viewers_token"]))

    async def teacher(self) -> Page:
        return await self.page(await self.logged_in(TOKENS["token"]))

    async def driver(self) -> Page:
        """A page that has the wheel."""
        page = await self.page()
        await page.wheel("take")
        await page.state(driver=page.number)
        return page

    async def start_robot(self, driver: Page) -> None:
        await driver.order("ROPN")
        await driver.order("RSWW")
        await driver.state(robot="started")

    async def started(self) -> tuple[Page, Page]:
        """The driver, whose robot is started, and another viewer."""
        driver, other = await self.driver(), await self.page()
        await self.start_robot(driver)
        return driver, other

    async def connected(self) -> None:
        await until(lambda: self.service.hub.state["supervisor"] == "connected")

    async def end(self) -> None:
        for client in self._clients:
            await client.close()


@contextlib.asynccontextmanager
async def world(
    *, supervisor_token: str | None = None, connected: bool = True, **chosen: Any
) -> AsyncIterator[World]:
    supervisor = Supervisor(supervisor_token)
    await supervisor.start()
    options = Options(supervisor_port=supervisor.port, port=0, **chosen)
    service = Service(options)
    made = World(supervisor, service)
    await service.start()
    try:
        if connected:
            await made.connected()
        yield made
    finally:
        await made.end()
        await service.close()
        await supervisor.stop()
        supervisor.forget()


def token_file(folder: Path, token: str) -> str:
    path = folder / f"token_{token}"
    path.touch(mode=0o600)
    path.write_text(token + "\n")
    return str(path)


class Program:
    def __init__(self, *arguments: str, planted: str = "") -> None:
        run = ["-m", "destijl_web"]
        if planted:
            run = [
                "-c",
                f"from destijl_web import __main__, guard, supervisor; {planted}",
            ]
            run[1] += "; raise SystemExit(__main__.main())"
        self.process = subprocess.Popen(
            [sys.executable, *run, *arguments],
            env={**os.environ, "PYTHONPATH": str(WEB)},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def address(self) -> str:
        assert self.process.stdout is not None
        assert select.select([self.process.stdout], [], [], LIMIT)[0], "it is silent"
        line = self.process.stdout.readline()
        found = re.fullmatch(r"destijl_web: open (http://\S+:\d+/)\n", line)
        assert found is not None, line
        return found[1]

    def port(self) -> int:
        return int(self.address().rsplit(":", 1)[1].rstrip("/"))

    def gateway(self) -> int:
        """The process that the guard watches."""
        path = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children")
        (child,) = path.read_text().split()
        return int(child)

    def end(self) -> tuple[int, str, str]:
        out, error = self.process.communicate(timeout=LIMIT)
        return self.process.returncode, out, error
