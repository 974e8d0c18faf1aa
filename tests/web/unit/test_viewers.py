#  SPDX-License-Identifier: GPL-3.0-or-later
"""What pages say and are told: the rows of the contract."""

import asyncio
import base64

import pytest
from destijl_web import exchange, ground, hub
from helpers import GROUND, World, jpeg


async def test_welcome(w: World) -> None:
    page = await w.page()
    assert page.welcome == {
        "type": "welcome",
        "you": 1,
        "role": "open",
        "state": {
            "supervisor": "connected",
            "robot": "closed",
            "watchdog": False,
            "camera": False,
            "camera_failed": False,
            "positions": False,
            "arena": "none",
            "ground": None,
            "battery": -1,
            "version": "",
            "driver": None,
            "asking": [],
            "offered": None,
            "viewers": [{"id": 1, "name": "#1", "role": "open"}],
            "recording": None,
            "mission": None,
        },
        "events": page.welcome["events"],
        "battery": [],
        "recordings": False,
        "pupils": False,
    }
    event = page.welcome["events"][0]
    assert event["code"] == "supervisor_connected"
    assert event["level"] == "info" and event["args"] == {}
    assert event["time"] > 1.6e12


async def test_ping_and_name(w: World) -> None:
    page, other = await w.page(), await w.page()
    await page.say("ping", n=12345, hidden=False)
    await page.expect("pong", n=12345)
    await page.say("name", name="Zoé <b>")
    state = await other.state()
    assert {"id": 1, "name": "Zoé <b>", "role": "open"} in state["viewers"]
    await page.close()
    state = await other.state()
    assert [v["id"] for v in state["viewers"]] == [2]


LABELS = exchange.LABELS - exchange.MISSIONS.keys()


async def test_every_order(w: World) -> None:
    page = await w.driver()
    assert len(LABELS) == 25
    for label in sorted(LABELS):
        value = -90 if label in ("RMOV", "RTRN") else None
        answer = await page.order(label, value=value)
        others = {
            "RGBT": "RBLV:2",
            "RVER": "RVER:3.5",
            "RGST": "RCST:0",
            "CASA": "CIMG",
        }
        assert answer["answer"] == others.get(label, "AACK")
        assert 0.0 <= answer["ms"] < 5000.0
        event = await page.event("order", label=label)
        assert event["args"]["name"] == "#1"
        assert event["args"]["answer"] == answer["answer"]
        assert event["args"].get("value") == value
        line = label if value is None else f"{label}:{value}"
        await w.supervisor.heard(line)


@pytest.mark.parametrize("answer", ["ANAK", "ACRJ", "ATIM", "ACER"])
async def test_refusals(w: World, answer: str) -> None:
    page = await w.driver()
    w.supervisor.answers["RSWW"] = answer.encode()
    assert (await page.order("RSWW"))["answer"] == answer
    event = await page.event("order", label="RSWW", answer=answer)
    assert event["level"] == "warning"
    await page.settle()
    assert w.service.hub.state["robot"] == "closed"


async def test_state_follows_the_answers(w: World) -> None:
    page = await w.driver()

    async def after(label: str, **fields: object) -> None:
        await page.order(label)
        await page.settle()
        seen = {n: w.service.hub.state[n] for n in fields}
        assert seen == fields, label

    await after("ROPN", robot="open", watchdog=False)
    await after("RSWW", robot="started", watchdog=True)
    await after("ROPN", robot="started", watchdog=True)
    await after("RSOW", robot="started", watchdog=False)
    await after("RRST", robot="open", watchdog=False)
    await after("RSWW", robot="started", watchdog=True)
    await after("RCLS", robot="closed", watchdog=False)
    await after("COPN", camera=True, positions=False, arena="none")
    await after("CPCO", positions=True)
    await after("CACO", arena="none", ground=None)
    await after("CASA", arena="found")
    await after("CACO", arena="confirmed")
    await after("RPIN", ground=ground.read(GROUND))
    await after("COPN", arena="confirmed", positions=True)
    await after("CASA", arena="found", ground=None)
    await after("CAIN", arena="none")
    await after("CPST", positions=False)
    await after("CASA", arena="found")
    await after("CCLS", camera=False, positions=False, arena="none")
    await after("RGBT", battery=2)
    await after("RVER", version="3.5")


async def test_a_robot_that_is_off(w: World) -> None:
    """By an order, or since a start or a ping is not answered; a stop that is not
    answered, or one time-out while it runs, says nothing."""
    page = await w.driver()

    async def answers(label: str, answer: bytes, robot: str) -> None:
        w.supervisor.answers[label] = answer
        await page.order(label)
        await page.settle()
        assert w.service.hub.state["robot"] == robot, (label, answer)

    await answers("RPIN", b"ATIM", "closed")
    await answers("ROPN", b"AACK", "open")
    await answers("RSTP", b"ATIM", "open")
    await answers("RSWW", b"ATIM", "off")
    await answers("ROPN", b"AACK", "off")
    await answers("RSWW", b"ACRJ", "open")
    await answers("RPIN", b"ATIM", "off")
    await answers("RPIN", b"AACK", "open")
    await answers("RSWW", b"AACK", "started")
    await answers("RGBT", b"ATIM", "started")
    await answers("RPOF", b"AACK", "off")
    await answers("RPIN", b"ANAK", "off")
    await answers("RCLS", b"AACK", "closed")


async def test_an_arena_that_is_not_found_leaves_the_one_before(w: World) -> None:
    page = await w.driver()
    for label in ("COPN", "CASA", "CACO"):
        await page.order(label)
    w.supervisor.answers["CASA"] = b"ANAK"
    assert (await page.order("CASA"))["answer"] == "ANAK"
    assert w.service.hub.state["arena"] == "confirmed"


async def test_what_comes_unasked(w: World) -> None:
    page = await w.driver()
    await w.start_robot(page)
    await page.order("COPN")
    w.supervisor.send(b"CPOS:7;-90.500000;1.25;2;3.000000;-4.5")
    position = await page.expect(
        "position", id=7, angle=-90.5, x=1.25, y=2.0, dx=3.0, dy=-4.5
    )
    assert len(position) == 8 and position["time"] > 1.6e12
    w.supervisor.send(b"CPOS:-1;0.0;0.0;0.0;0.0;0.0")
    await page.expect("position", id=-1)
    w.supervisor.send(b"RBLV:1")
    await page.state(battery=1)
    w.supervisor.send(b"RBLV:-1\r")
    await page.state(battery=-1)
    w.supervisor.send(b"MSSG:it is \x1b[31mred\xff")
    await page.event("message", text="it is ?[31mred\ufffd")
    w.supervisor.send(b"MSSG:robot no longer runs (watchdog): start again")
    await page.state(robot="open", watchdog=False)
    await page.event("robot_not_running")
    w.supervisor.send(b"ATIM")
    assert (await page.event("robot_lost"))["level"] == "error"
    await page.state(robot="lost")
    await page.order("ROPN")
    await page.state(robot="open")
    w.supervisor.send(b"MSSG:camera closed: it has delivered nothing")
    await page.state(camera=False, camera_failed=True)
    await page.event("camera_failed")
    await page.order("COPN")
    await page.state(camera=True, camera_failed=False)


async def test_garbage_from_the_supervisor(w: World) -> None:
    page = await w.driver()
    w.supervisor.send(
        b"",
        b"\x00\xff\xfe",
        b"AACK",
        b"RCST:1",
        b"RBLV:9",
        b"RBLV:",
        b"CPOS:",
        b"CPOS:1;2",
        b"CPOS:1;nan;inf;1e9;0x1;0",
        b"CPOS:1;" + b"9" * 100 + b";0;0;0;0",
        b"CIMG:",
        b"CIMG:!!!!",
        b"CIMG:" + base64.b64encode(b"GIF89a"),
        b"X" * 100_000,
    )
    w.supervisor.send_image(5)
    assert await page.image() == jpeg(5)
    assert [s for s in page.said if s["type"] == "position"] == []
    assert w.service.hub.state["battery"] == -1
    assert (await page.order("RGBT"))["answer"] == "RBLV:2"
    assert w.supervisor.connections == 1


async def test_pieces(w: World) -> None:
    """Lines come in any pieces."""
    page = await w.driver()
    data = b"CIMG:" + base64.b64encode(jpeg(6)) + b"\r\nRBLV:1\n"
    for byte in data:
        w.supervisor.send_raw(bytes([byte]))
        await asyncio.sleep(0)
    assert await page.image() == jpeg(6)
    await page.state(battery=1)


async def test_no_camera_images(w: World) -> None:
    page = await w.driver()
    await page.order("COPN")
    w.pass_time(hub.CAMERA_SILENCE + 0.1)
    await page.event("camera_silent")
    w.supervisor.send_image(1)
    await page.image()
    w.pass_time(hub.CAMERA_SILENCE + 0.1)
    await page.event("camera_silent")
    codes = [e["code"] for e in w.service.hub._events]
    assert codes.count("camera_silent") == 2


async def test_no_silence_while_the_arena_is_decided(w: World) -> None:
    page = await w.driver()
    await page.order("COPN")
    await page.order("CASA")
    w.pass_time(hub.CAMERA_SILENCE + 0.1)
    await page.settle()
    assert [s for s in page.said if s.get("code") == "camera_silent"] == []


async def test_battery_history(w: World) -> None:
    page = await w.page()
    for level in (2, 2, 1, 1, 0):
        w.supervisor.send(b"RBLV:%d" % level)
    await page.state(battery=0)
    late = await w.page()
    assert [level for _, level in late.welcome["battery"]] == [2, 1, 0]
    assert all(t > 1.6e12 for t, _ in late.welcome["battery"])


async def test_events_are_bounded(w: World) -> None:
    page = await w.page()
    w.supervisor.send(*(b"MSSG:%d" % n for n in range(150)))
    await page.event("message", text="149")
    late = await w.page()
    texts = [e["args"]["text"] for e in late.welcome["events"]]
    assert texts == [str(n) for n in range(50, 150)]


async def test_orders_of_a_viewer_are_bounded(w: World) -> None:
    page = await w.driver()
    await w.start_robot(page)
    w.supervisor.answers["RPIN"] = None
    for number in range(hub.ORDERS_PER_VIEWER):
        await page.say("order", id=1000 + number, label="RPIN")
    assert (await page.order("RPIN"))["answer"] == "BUSY"
    #  a stop goes out all the same
    await page.say("order", id=2000, label="RSTP")
    await w.supervisor.heard("RSTP")
    w.supervisor.send(*[b"AACK"] * hub.ORDERS_PER_VIEWER)
    await page.expect("answer", id=2000, answer="AACK")
    w.supervisor.answers["RPIN"] = b"AACK"
    assert (await page.order("RPIN"))["answer"] == "AACK"


@pytest.mark.parametrize("labels", [["RSTP"], ["RSTP", "MABT"]])
async def test_a_flood_of_stops_is_one(w: World, labels: list[str]) -> None:
    page = await w.page()
    w.supervisor.answers |= dict.fromkeys(labels)
    for number in range(90):
        await page.say("order", id=number, label=labels[number % len(labels)])
    await page.settle()
    counts = [w.supervisor.count(label) for label in labels]
    assert all(counts) and sum(counts) < 10
    w.supervisor.send(*[b"AACK"] * sum(counts))
    for number in range(90):
        await page.expect("answer", id=number, answer="AACK")
    told = [e for e in page.said if e.get("code") == "stopped_by"]
    assert len(told) <= 2


async def test_without_supervisor(w: World) -> None:
    page = await w.driver()
    w.supervisor.answers["RPIN"] = None
    await page.say("order", id=77, label="RPIN")
    await w.supervisor.heard("RPIN")
    await w.supervisor.stop()
    await page.expect("answer", id=77, answer="NOLINK")
    assert (await page.event("supervisor_lost"))["level"] == "error"
    answer = await page.order("RSTP")
    assert answer["answer"] == "NOLINK" and "ms" not in answer
    assert w.service.hub.state["supervisor"] == "connecting"


async def test_the_last_image_for_a_newcomer(w: World) -> None:
    page = await w.driver()
    await page.order("COPN")
    await page.order("CASA")
    assert await page.image() == jpeg(999)
    for _ in range(3):
        w.pass_time(hub.IMAGE_AGE / 2)
        await page.settle()
    late = await w.page()
    assert await late.image() == jpeg(999)
    await page.order("CAIN")
    later = await w.page()
    await later.settle()
    assert later.images == []


@pytest.mark.parametrize(
    "text",
    [
        "x",
        '{"type":"nothing"}',
        '{"type":"order","id":1,"label":"RLDW"}',
        '{"type":"name","name":"' + "a" * 5000 + '"}',
        b"binary",
    ],
)
async def test_malformed_ends_the_connection(w: World, text: str | bytes) -> None:
    other, page = await w.page(), await w.page()
    if isinstance(text, bytes):
        await page.ws.send_bytes(text)
    else:
        await page.ws.send_str(text)
    assert await page.closed() == 1008
    await other.settle()
    assert len(w.service.hub.viewers) == 1


async def test_huge_messages_end_the_connection(w: World) -> None:
    page = await w.page()
    await page.ws.send_str("x" * 10**6)
    assert await page.closed() in (1006, 1008, 1009)
    await (await w.page()).settle()


async def test_the_gateway_ends_in_order(w: World) -> None:
    page = await w.driver()
    await w.start_robot(page)
    closing = asyncio.create_task(w.service.close())
    assert await page.closed() == 1001
    await closing
    assert w.supervisor.lines[-2:] == ["RSTP", "end"]
