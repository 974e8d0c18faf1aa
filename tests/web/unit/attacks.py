#  SPDX-License-Identifier: GPL-3.0-or-later
"""usage: attacks.py PORT
What a neighbour without a token, and a pupil with the class's, may try against a
gateway with the tokens of these tests, on this machine. Ends with status 0 if a
teacher came in and went out after each."""

import asyncio
import contextlib
import gzip
import sys
from collections.abc import Awaitable, Callable, Iterable

import aiohttp
from helpers import TOKENS, Page, World

ORIGIN = "https://robot.example"
#  Of a proxy before that gateway


class Gateway(World):
    """One that runs elsewhere."""

    def __init__(self, port: int) -> None:
        self._clients = []
        self._pages = []
        self.port = port

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"


async def log_in(g: Gateway, client: aiohttp.ClientSession, token: str) -> str:
    """Where it leads to, for somebody who says to come from somewhere."""
    there = {"Host": "robot.example", "Origin": ORIGIN, "X-Forwarded-For": "192.0.2.77"}
    answer = await g.log_in(token, client, **there)
    return answer.headers.get("Location", str(answer.status))


async def together(work: Iterable[Awaitable[object]]) -> None:
    for result in await asyncio.gather(*work, return_exceptions=True):
        if isinstance(result, BaseException) and not isinstance(
            result, (aiohttp.ClientError, ConnectionError)
        ):
            raise result


async def packed_bodies(g: Gateway) -> None:
    body = gzip.compress(b"token=" + bytes(300 * 2**20), 9)
    headers = {
        "Content-Encoding": "gzip",
        "Content-Type": "application/x-www-form-urlencoded",
    }

    async def post() -> None:
        async with g.client().post(f"{g.url}/login", data=body, headers=headers):
            pass

    await together(post() for _ in range(8))


async def pipelined(g: Gateway) -> None:
    _, writer = await asyncio.open_connection("127.0.0.1", g.port)
    one = f"GET /recordings HTTP/1.1\r\nHost: 127.0.0.1:{g.port}\r\n\r\n".encode()
    with contextlib.suppress(ConnectionError):
        for _ in range(300):
            writer.write(one * 2000)
            await writer.drain()
    writer.close()


async def class_of_sockets(g: Gateway) -> list[Page]:
    """All that a pupil gets."""
    pages: list[Page] = []
    for _ in range(30):
        client = await g.logged_in(TOKENS["viewers_token"])
        with contextlib.suppress(aiohttp.WSServerHandshakeError):
            while True:
                pages.append(await g.page(client))
    return pages


async def no_place(g: Gateway) -> None:
    pages = await class_of_sockets(g)
    assert len(pages) > 10
    await (await g.teacher()).settle()
    await asyncio.gather(*(page.close() for page in pages))


async def flood(g: Gateway) -> None:
    """48 stops a second, and pings, on each of 40 sockets."""
    pages = (await class_of_sockets(g))[:40]

    async def send(page: Page) -> None:
        for number in range(2 * 48):
            await page.say("order", id=number, label="RSTP")
            await page.ws.ping()
            await asyncio.sleep(1 / 48)

    async def read(page: Page) -> None:
        while await page.receive() is not None:
            pass

    readers = [asyncio.create_task(read(page)) for page in pages]
    await together(send(page) for page in pages)
    await (await g.teacher()).settle()
    for reader in readers:
        reader.cancel()


async def guesses(g: Gateway) -> None:
    client = g.client()
    there = [await log_in(g, client, f"wrong {number}") for number in range(500)]
    assert there.count("/?failed=wait") > 400
    assert await log_in(g, client, TOKENS["token"]) == "/"


async def logins(g: Gateway) -> None:
    teacher = await g.logged_in(TOKENS["token"])
    client = g.client()
    for _ in range(1001):
        assert await log_in(g, client, TOKENS["viewers_token"]) == "/"
    await (await g.page(teacher)).settle()


ATTACKS: list[Callable[[Gateway], Awaitable[None]]] = [
    *(packed_bodies, pipelined, no_place, flood, guesses, logins)
]


async def main(port: int) -> None:
    for attack in ATTACKS:
        g = Gateway(port)
        print("attack:", attack.__name__, flush=True)
        await attack(g)
        await (await g.teacher()).settle()
        await g.end()


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1])))
