#  SPDX-License-Identifier: GPL-3.0-or-later
"""Images, to fast viewers and slow ones."""

import asyncio
import functools
import socket
from typing import Any

import pytest
from aiohttp import web
from destijl_web import fan_out, viewer
from helpers import LIMIT, UPGRADE, World, jpeg, number_of, until

LARGE = 100_000


def is_sent_on(w: World, image: bytes) -> bool:
    """Where it may be."""
    return w.service.hub._image == image and all(
        one._image is None or one._unseen >= viewer.IMAGES_UNDER_WAY
        for one in w.service.hub.viewers.values()
    )


async def send(w: World, numbers: range) -> None:
    for number in numbers:
        w.supervisor.send_image(number)
        await until(functools.partial(is_sent_on, w, jpeg(number)))


async def test_every_image_to_everybody(w: World) -> None:
    pages = [await w.page() for _ in range(20)]
    for number in range(10):
        w.supervisor.send_image(number, LARGE)
        for page in pages:
            assert await page.image() == jpeg(number, LARGE)


async def test_a_few_viewers_in_a_turn(w: World) -> None:
    """What is to be done at once, an order, comes between them."""
    pages = [await w.page() for _ in range(20)]
    turns: list[int] = []
    sent = 0
    send_bytes = web.WebSocketResponse.send_bytes

    async def counted(ws: Any, data: bytes, **more: Any) -> None:
        nonlocal sent
        sent += 1
        await send_bytes(ws, data, **more)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(web.WebSocketResponse, "send_bytes", counted)
        w.supervisor.send_image(1)
        async with asyncio.timeout(LIMIT):
            while sent < len(pages):
                before = sent
                await asyncio.sleep(0)
                turns.append(sent - before)
    assert max(turns) <= fan_out.PER_TURN


async def test_no_more_than_two_under_way(w: World) -> None:
    page = await w.page()
    page.acknowledges = False
    await send(w, range(1, 7))
    await page.settle()
    assert [number_of(i) for i in page.images] == [1, 2]
    #  and of those that came meanwhile the newest
    await page.say("seen")
    assert number_of(await page.image()) == 6
    await page.settle()
    await page.say("seen")
    await page.say("seen")
    await page.settle()
    await send(w, range(7, 10))
    await page.settle()
    assert [number_of(i) for i in page.images] == [1, 2, 6, 7, 8]
    #  more than it has got is not shown
    for _ in range(10):
        await page.say("seen")
    await page.settle()
    await send(w, range(10, 15))
    await page.settle()
    assert [number_of(i) for i in page.images] == [1, 2, 6, 7, 8, 9, 10]


async def stalled_page(w: World) -> socket.socket:
    """A page whose machine takes little, and whose program reads nothing."""
    page = socket.socket()
    page.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    page.connect(("127.0.0.1", w.service.port))
    page.setblocking(False)
    loop = asyncio.get_running_loop()
    asked = w.request("GET /ws", f"Origin: {w.url}", *UPGRADE) + b"\r\n"
    await loop.sock_sendall(page, asked)
    assert (await loop.sock_recv(page, 12)).endswith(b"101")
    return page


async def test_a_stalled_viewer_delays_nobody(w: World) -> None:
    driver = await w.driver()
    with await stalled_page(w):
        for number in range(20):
            w.supervisor.send_image(number, 400_000)
            assert number_of(await driver.image()) == number
            assert (await driver.order("RGFW"))["answer"] == "AACK"
        await driver.settle()
        #  and is closed after a while, however long the test took
        w.pass_time(1000.0)
        await driver.state(viewers=[{"id": 1, "name": "#1", "role": "open"}])


async def test_a_viewer_that_takes_no_texts_is_closed(w: World) -> None:
    page = await w.page()
    other = next(iter(w.service.hub.viewers.values()))
    for number in range(viewer.TEXTS_WAITING + 1):
        other.put(str(number))
    assert await page.closed() == 1013


async def test_the_state_of_a_slow_viewer_is_whole(w: World) -> None:
    page = await w.page()
    slow = next(iter(w.service.hub.viewers.values()))
    for number in range(viewer.STATES_WAITING + 100):
        w.service.hub.state.set(battery=number % 3)
        w.service.hub._publish()
    w.service.hub.state.set(robot="lost")
    w.service.hub._publish()
    assert len(slow._texts) <= viewer.STATES_WAITING
    state = await page.state(robot="lost")
    assert state["battery"] == w.service.hub.state["battery"]
    assert set(state) == {"type", *w.service.hub.state.all()}


async def test_slow_viewers_get_the_newest_position(w: World) -> None:
    await w.page()
    slow = next(iter(w.service.hub.viewers.values()))
    for number in range(100):
        slow.put_position(str(number))
    assert slow._position == "99"
