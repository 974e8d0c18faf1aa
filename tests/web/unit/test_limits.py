#  SPDX-License-Identifier: GPL-3.0-or-later
"""What one who may come in, or nobody, cannot do to the others."""

import asyncio
import gzip

import pytest
from aiohttp import MultipartWriter, WSServerHandshakeError
from destijl_web import connections, hub, logins, server
from helpers import LIMIT, TOKENS, Page, World, until

#  Requests


async def test_one_request_a_connection(w: World) -> None:
    one = w.request("GET /recordings") + b"\r\n"
    answer = await w.raw([one, one])
    assert answer.startswith(b"HTTP/1.1 404 ")
    assert answer.count(b"HTTP/1.1") == 1
    assert b"Connection: close\r\n" in answer


async def test_pipelined(w: World) -> None:
    one = w.request("GET /recordings") + b"\r\n"
    assert (await w.raw([one * 10_000])).count(b"HTTP/1.1") <= 1


async def test_no_request(w: World, caplog: pytest.LogCaptureFixture) -> None:
    for said in (b"\x16\x03\x01\x02\x00", b"HELO there", b"GET / HTTP/x.y"):
        assert b" 400 " in await w.raw([said + b"\r\n\r\n"])
    assert caplog.text == ""


@pytest.mark.parametrize("size", [1, 10_000])
async def test_a_request_without_end(w: World, size: int) -> None:
    line = b"X: " + b"x" * size + b"\r\n"
    await w.raw([w.request("GET /"), *[line * (10_000 // size)] * 100])


@pytest.mark.parametrize("length", ["Content-Length: 9999999", "Expect: 100-continue"])
async def test_a_body_without_end(w: World, length: str) -> None:
    chunked = "Transfer-Encoding: chunked"[: len(length)]
    head = w.request("POST /login", length, chunked)
    await w.raw([head + b"\r\n", *[b"fff\r\n" + b"x" * 0xFFF + b"\r\n"] * 1000])


@pytest.mark.world(TOKENS)
async def test_forms_of_other_kinds(w: World) -> None:
    """Nothing is unpacked for who has no token."""
    parts = MultipartWriter("form-data")
    parts.append(TOKENS["token"]).set_content_disposition("form-data", name="token")
    packed = gzip.compress(b"token=" + TOKENS["token"].encode())
    for data, headers in (
        (parts, {}),
        (packed, {"Content-Encoding": "gzip"}),
        (packed + bytes(4000), {"Content-Encoding": "deflate"}),
    ):
        async with w.client().post(
            f"{w.url}/login", data=data, headers=headers, allow_redirects=False
        ) as answer:
            assert "Set-Cookie" not in answer.headers


async def test_connections_are_bounded_at_once(w: World) -> None:
    most = connections.MAX_PENDING
    there = "127.0.0.1", w.service.port
    page = await w.page()
    idle = [await asyncio.open_connection(*there) for _ in range(most + 20)]
    async with asyncio.timeout(LIMIT):
        for reader, _ in idle[:20]:
            assert await reader.read() == b""
    await page.settle()
    assert not any(reader.at_eof() for reader, _ in idle[20:])
    for _, writer in idle:
        writer.close()


#  Places


@pytest.fixture
def no_heartbeat(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of pages that read nothing for long."""
    monkeypatch.setattr(server, "HEARTBEAT", None)


@pytest.mark.usefixtures("no_heartbeat")
async def test_viewers_are_bounded(w: World) -> None:
    client = w.client()
    for _ in range(hub.MAX_VIEWERS):
        await w.page(client)
    assert await w.refused(client) == 503


@pytest.mark.usefixtures("no_heartbeat")
@pytest.mark.world(TOKENS)
async def test_places_for_teachers(w: World) -> None:
    clients = []
    for _ in range((hub.MAX_VIEWERS - hub.FOR_TEACHERS) // hub.MAX_PER_SESSION + 1):
        clients.append(await w.logged_in(TOKENS["viewers_token"]))
        with pytest.raises(WSServerHandshakeError) as reason:
            for _ in range(hub.MAX_PER_SESSION + 1):
                await w.page(clients[-1])
        assert reason.value.status == 503
    assert len(w.service.hub.viewers) == hub.MAX_VIEWERS - hub.FOR_TEACHERS
    for _ in range(hub.FOR_TEACHERS):
        teacher = await w.teacher()
    #  and the places are free again
    for client in clients:
        await client.close()
    await until(lambda: len(w.service.hub.viewers) == hub.FOR_TEACHERS)
    await w.pupil()
    await teacher.settle()


@pytest.mark.world(TOKENS)
async def test_nobody_comes_and_goes_too_often(w: World) -> None:
    client = await w.logged_in(TOKENS["viewers_token"])
    for _ in range(10):
        await (await w.page(client)).close()
    assert await w.refused(client) == 429
    w.pass_time(1.1)
    await (await w.page(client)).settle()


#  Floods


async def flood(page: Page, frames: int) -> None:
    for _ in range(frames):
        await page.ws.ping()


async def test_frames_that_are_pings_count(w: World) -> None:
    other = await w.page()
    page = await w.page()
    await flood(page, 100)
    await page.settle()
    await flood(page, 1000)
    assert await page.closed() == 1008
    await other.settle()


async def test_pings_are_answered(w: World, monkeypatch: pytest.MonkeyPatch) -> None:
    page = await w.page()
    client = page.ws._response.connection
    assert client is not None and client.protocol is not None
    heard = bytearray()
    feed = client.protocol.data_received

    def hear(data: bytes) -> None:
        heard.extend(data)
        feed(data)

    monkeypatch.setattr(client.protocol, "data_received", hear)
    await page.ws.ping(b"are you there?")
    await page.settle()
    assert b"are you there?" in heard


async def test_frames_that_are_no_message_count(w: World) -> None:
    page = await w.page()
    transport = page.ws._response.connection.transport  # type: ignore[union-attr]
    assert transport is not None
    begun, continued = b"\x01\x80" + bytes(4), b"\x00\x80" + bytes(4)
    transport.write(begun + continued * 20_000)
    assert await page.closed() == 1008


@pytest.mark.world(TOKENS)
async def test_pages_of_a_session_share_its_budget(
    w: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    take = logins.Budget.take

    def take_of_the_first(
        budget: logins.Budget, now: float, amount: float = 1.0
    ) -> bool:
        """However long the flood takes, nothing is given back meanwhile."""
        return take(budget, 0.0, amount)

    monkeypatch.setattr(logins.Budget, "take", take_of_the_first)
    client = await w.logged_in(TOKENS["viewers_token"])
    pages = [await w.page(client) for _ in range(hub.MAX_PER_SESSION)]
    other = await w.pupil()
    for page in pages:
        await flood(page, 150)
    codes = [await page.closed() for page in pages[-1:]]
    assert codes == [1008]
    await other.settle()


#  The log


async def test_stops_do_not_wipe_the_log(w: World) -> None:
    one, two, three = await w.page(), await w.page(), await w.page()
    await one.order("RSTP")
    for _ in range(hub.EVENTS + 20):
        w.pass_time(hub.STOP_TOLD + 0.1)
        await two.order("RSTP")
    await three.wheel("take")
    for number in range(hub.EVENTS + 20):
        w.pass_time(0.1)
        if number % 4 == 0:
            await three.settle()
        assert (await three.order("RSTP"))["answer"] == "AACK"
    told = (await w.page()).welcome["events"]
    stopped = [e["args"] for e in told if e["code"] == "stopped_by"]
    assert stopped == [{"name": "#1"}, {"name": "#2", "count": hub.EVENTS + 20}]
    assert [e["time"] for e in told] == sorted(e["time"] for e in told)
    assert [e["code"] for e in told].count("order") == hub.EVENTS


async def test_nobody_is_logged_as_another(w: World) -> None:
    one, two = await w.page(), await w.page()
    await one.say("name", name="Zoé")
    await one.say("name", name="Zoé")
    for said, got in (
        *((taken, taken + " #2") for taken in ("Zoé", "ZOÉ", "Zo é", "Zoe\u0301")),
        *((taken, taken + " #2") for taken in ("Zoé\ufe0f", "Zoé\u2800", "\u3164Zoé")),
        *(("#1", "1"), ("Zoé #2", "Zoé  2")),
    ):
        await two.say("name", name=said)
        await two.settle()
        names = [viewer["name"] for viewer in w.service.hub.state["viewers"]]
        assert names == ["Zoé", got]


async def test_wishes_of_one_are_bounded(w: World) -> None:
    """So that the others are not told too much, and the log stays."""
    driver, other = await w.driver(), await w.page()
    for _ in range(40):
        await other.wheel("ask")
        await other.wheel("withdraw")
        await other.say("name", name="me")
        await other.settle()
    await driver.settle()
    asked = [s for s in driver.said if s.get("code") == "wheel_asked"]
    assert 1 <= len(asked) <= 10
    told = (await w.page()).welcome["events"]
    assert [e["code"] for e in told].count("wheel_asked") == 1
    w.pass_time(5.0)
    await other.wheel("ask")
    await driver.state(asking=[other.number])


async def test_orders_told_are_bounded(w: World) -> None:
    driver, other = await w.driver(), await w.page()
    for _ in range(100):
        assert (await driver.order("RPIN"))["answer"] == "AACK"
    await other.settle()
    await other.settle()
    told = [s for s in other.said if s.get("code") == "order"]
    assert 20 <= len(told) <= 45


#  Stops of others


async def acts(w: World, page: Page) -> bool:
    before = w.supervisor.count("RSTP")
    answer = (await page.order("RSTP"))["answer"]
    assert answer in ("AACK", "MUTED")
    assert w.supervisor.count("RSTP") - before == (answer == "AACK")
    return bool(answer == "AACK")


@pytest.mark.world(TOKENS)
async def test_nobody_keeps_the_others_from_driving(w: World) -> None:
    driver, pupil, other = await w.pupil(), await w.pupil(), await w.pupil()
    teacher = await w.teacher()
    await driver.wheel("take")
    await driver.state(driver=driver.number)

    async def seconds(count: int, page: Page) -> list[bool]:
        acted = []
        for _ in range(count):
            for _ in range(3):
                w.pass_time(0.35)
                await driver.settle()
            acted.append(await acts(w, page))
        return acted

    assert await acts(w, pupil)
    assert await acts(w, pupil)  # within the same second
    assert (await seconds(30, pupil)).count(True) in (6, 7)
    assert await acts(w, other)
    assert all(await seconds(30, teacher))
    assert all(await seconds(3, driver))
    #  all stop a robot that nobody drives
    await driver.wheel("release")
    await pupil.state(driver=None)
    assert all([await acts(w, pupil) for _ in range(10)])


@pytest.mark.world(TOKENS)
async def test_nor_do_many_sessions(w: World) -> None:
    driver = await w.pupil()
    await driver.wheel("take")
    await driver.state(driver=driver.number)
    acted = [await acts(w, await w.pupil()) for _ in range(20)]
    assert acted == [True] * 10 + [False] * 10
    assert await acts(w, await w.teacher())


#  Pupils


@pytest.mark.world(TOKENS)
async def test_muted(w: World) -> None:
    teacher, pupil, other = await w.teacher(), await w.pupil(), await w.pupil()
    await pupil.wheel("take")
    await w.start_robot(pupil)
    for page, to in ((other, 2), (pupil, 3), (teacher, 1), (teacher, 77)):
        await page.say("pupil", do="mute", to=to)
        await page.settle()
    assert not any("muted" in one for one in w.service.hub.state["viewers"])
    await teacher.say("pupil", do="mute", to=pupil.number)
    await other.event("muted", **{"from": "#1", "name": "#2"})
    #  the robot stands, and others drive
    await w.supervisor.heard("RSTP")
    await other.settle()
    state = w.service.hub.state
    assert state["driver"] is None
    assert state["viewers"][1] == {
        **{"id": 2, "name": "#2", "role": "viewer", "muted": True}
    }
    for wish in ("take", "ask"):
        await pupil.wheel(wish)
    await pupil.say("name", name="somebody else")
    await pupil.settle()
    assert state["driver"] is None
    assert w.service.hub.viewers[2].name == "#2"
    assert await acts(w, pupil)
    await other.wheel("take")
    await other.state(driver=other.number)
    assert not await acts(w, pupil)
    await teacher.say("pupil", do="unmute", to=pupil.number)
    await pupil.event("unmuted")
    assert await acts(w, pupil)


@pytest.mark.world(TOKENS)
async def test_expelled(w: World) -> None:
    teacher, other = await w.teacher(), await w.pupil()
    client = await w.logged_in(TOKENS["viewers_token"])
    pupil, second = await w.page(client), await w.page(client)
    await pupil.wheel("take")
    await w.start_robot(pupil)
    for page, to in ((other, pupil), (pupil, other), (teacher, teacher)):
        await page.say("pupil", do="expel", to=to.number)
        await page.settle()
    await teacher.say("pupil", do="expel", to=pupil.number)
    await other.event("expelled", **{"from": "#1", "name": "#3"})
    for page in (pupil, second):
        assert await page.closed() == hub.SESSION_OVER
    await w.supervisor.heard("RSTP")
    await other.state(driver=None)
    assert await w.refused(client) == 401
    await other.settle()


@pytest.mark.world(TOKENS, origins=("https://robot.example",))
async def test_expelled_with_its_address(w: World) -> None:
    there = {"Host": "robot.example", "X-Forwarded-For": "192.0.2.1"}
    client, teacher = w.client(), await w.teacher()

    async def log_in() -> str:
        answer = await w.log_in(TOKENS["viewers_token"], client, **there)
        return answer.headers["Location"]

    assert await log_in() == "/"
    (cookie,) = client.cookie_jar
    pupil = await w.client().ws_connect(
        f"{w.url}/ws",
        origin="https://robot.example",
        headers={"Cookie": f"{cookie.key}={cookie.value}"},
    )
    await teacher.say("pupil", do="expel", to=2)
    await teacher.event("expelled")
    assert await Page(pupil).closed() == hub.SESSION_OVER
    assert await log_in() == "/?failed=expelled"
    there["X-Forwarded-For"] = "192.0.2.2"
    assert await log_in() == "/"


async def test_nobody_is_muted_without_tokens(w: World) -> None:
    one, two = await w.page(), await w.page()
    for do in ("mute", "expel"):
        await one.say("pupil", do=do, to=two.number)
    await one.settle()
    await two.settle()
