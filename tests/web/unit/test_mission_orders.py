#  SPDX-License-Identifier: GPL-3.0-or-later
"""Missions: taken, refused, shown to everybody, ended."""

import asyncio
import json
from pathlib import Path

import pytest
from destijl_web import messages
from helpers import Json, Page, World, run, world

PATH = [[100, 120], [300.5, 120], [300.5, 240]]
SENT = "MPTH:100.0;120.0;300.5;120.0;300.5;240.0"


async def begun(w: World) -> tuple[Page, Page]:
    """The driver, whose mission is under way, and another viewer."""
    driver, other = await w.driver(), await w.page()
    answer = await driver.order("MPTH", points=PATH)
    assert answer["answer"] == "AACK" and answer["ms"] >= 0.0
    return driver, other


def mission(leg: int, distance: int | None) -> Json:
    return {"unit": "px", "points": PATH, "leg": leg, "of": 3, "distance": distance}


@pytest.mark.parametrize(
    ("label", "points", "unit", "line"),
    [
        ("MGTO", [[320, 240]], "px", "MGTO:320.0;240.0"),
        ("MPTH", PATH, "px", SENT),
        ("MGCM", [[12.5, 30]], "cm", "MGCM:12.5;30.0"),
        ("MPCM", [[0.1, 0.2], [60, 30]], "cm", "MPCM:0.1;0.2;60.0;30.0"),
    ],
)
def test_taken(label: str, points: list[list[float]], unit: str, line: str) -> None:
    async def test() -> None:
        async with world() as w:
            driver, other = await w.driver(), await w.page()
            assert (await driver.order(label, points=points))["answer"] == "AACK"
            await w.supervisor.heard(line)
            event = await other.event("order", label=label)
            assert event["args"]["value"] == len(points)
            plan = {
                "unit": unit,
                "points": points,
                "leg": 1,
                "of": len(points),
                "distance": None,
            }
            await other.state(mission=plan)
            #  who comes later sees it, too
            assert (await w.page()).welcome["state"]["mission"] == plan

    run(test())


def test_the_longest_path_fits() -> None:
    async def test() -> None:
        async with world() as w:
            driver = await w.driver()
            points = [[9999, 1079.9]] * 64
            assert (await driver.order("MPTH", points=points))["answer"] == "AACK"
            await w.supervisor.heard("MPTH:" + ";".join(["9999.0;1079.9"] * 64))
            assert max(map(len, w.supervisor.lines)) < 1024

    run(test())


def test_progress_and_end() -> None:
    async def test() -> None:
        async with world() as w:
            _, other = await begun(w)
            for leg, distance in ((1, 200), (1, 90), (2, 155), (3, 0)):
                w.supervisor.send(b"MPRG:%d;3;%d" % (leg, distance))
                await other.state(mission=mission(leg, distance))
            w.supervisor.send(b"MEND:done")
            await other.state(mission=None)
            assert (await other.event("mission_done"))["level"] == "info"

    run(test())


@pytest.mark.parametrize(
    ("reason", "level"),
    [("order by hand", "info"), ("robot not seen in 3 images", "warning")],
)
def test_aborted(reason: str, level: str) -> None:
    async def test() -> None:
        async with world() as w:
            _, other = await begun(w)
            w.supervisor.send(b"MEND:aborted;" + reason.encode())
            await other.state(mission=None)
            assert (await other.event("mission_aborted", reason=reason))[
                "level"
            ] == level
            #  the next one is another
            w.supervisor.send(b"MPRG:2;3;100", b"RBLV:1")
            await other.state(battery=1)
            assert w.service.hub.state["mission"] is None

    run(test())


def test_what_is_no_progress() -> None:
    async def test() -> None:
        async with world() as w:
            w.supervisor.send(b"MPRG:1;3;100", b"MEND:done", b"RBLV:2")
            driver, other = await begun(w)
            w.supervisor.send(
                b"MPRG:",
                b"MPRG:1;3",
                b"MPRG:0;3;1",
                b"MPRG:4;3;1",
                b"MPRG:1;2;1",
                b"MPRG:1;3;-1",
                b"MPRG:1;3;1.5",
                b"MPRG:1;3;" + b"9" * 50,
                b"MPRG:1;3;1;1",
                b"RBLV:1",
            )
            await other.state(battery=1)
            assert w.service.hub.state["mission"] == mission(1, None)
            codes = [said.get("code") for said in driver.said]
            assert "mission_done" not in codes
            w.supervisor.send(b"MEND:\x1b\xff")
            await other.event("mission_aborted", reason="?\ufffd")
            await other.state(mission=None)

    run(test())


@pytest.mark.parametrize("answer", ["ANAK", "ACRJ", "ACER"])
def test_refused(answer: str) -> None:
    async def test() -> None:
        async with world() as w:
            driver = await w.driver()
            w.supervisor.answers["MGTO"] = (
                answer.encode() + b"\nMSSG:mission not possible: robot not started"
            )
            assert (await driver.order("MGTO", points=[[1, 2]]))["answer"] == answer
            event = await driver.event("mission_refused", reason="robot not started")
            assert event["level"] == "warning"
            assert w.service.hub.state["mission"] is None

    run(test())


def test_a_refusal_leaves_the_one_under_way() -> None:
    async def test() -> None:
        async with world() as w:
            driver, _ = await begun(w)
            w.supervisor.answers["MGTO"] = b"ACRJ"
            assert (await driver.order("MGTO", points=[[1, 2]]))["answer"] == "ACRJ"
            assert w.service.hub.state["mission"] == mission(1, None)

    run(test())


def test_who_may() -> None:
    """Only the driver sends the robot somewhere; everybody may end it."""

    async def test() -> None:
        async with world() as w:
            driver, other = await begun(w)
            assert (await other.order("MGTO", points=[[1, 2]]))["answer"] == "NOWHEEL"
            assert (await other.order("MABT"))["answer"] == "AACK"
            await driver.event("stopped_by", name="#2")
            assert w.supervisor.lines[1:] == [SENT, "MABT"]

    run(test())


def test_a_flood_of_ends_is_one() -> None:
    async def test() -> None:
        async with world() as w:
            page = await w.page()
            w.supervisor.answers |= {"RSTP": None, "MABT": None}
            for number in range(60):
                label = ("RSTP", "MABT")[number % 2]
                await page.say("order", id=number, label=label)
            await page.settle()
            sent = w.supervisor.count("RSTP") + w.supervisor.count("MABT")
            assert 2 <= sent < 10
            w.supervisor.send(*[b"AACK"] * sent)
            for number in range(60):
                await page.expect("answer", id=number, answer="AACK")

    run(test())


@pytest.mark.parametrize("silent", [True, False])
def test_stopped_with_its_driver(silent: bool) -> None:
    """Who has sent it is gone: the robot is stopped, and so is the mission."""

    async def test() -> None:
        async with world() as w:
            driver = await w.driver()
            await w.start_robot(driver)
            await driver.order("MPTH", points=PATH)
            if silent:
                driver.be_silent()
            else:
                await driver.close()
            await w.supervisor.heard("RSTP")

    run(test())


def test_not_beyond_the_session() -> None:
    async def test() -> None:
        async with world() as w:
            _, other = await begun(w)
            w.supervisor.hang_up()
            await other.state(mission=None)
            await other.event("supervisor_connected")

    run(test())


def test_messages_are_not_too_large() -> None:
    points = [[-1919.125, -1079.125]] * 64
    order = {"type": "order", "id": 2**53, "label": "MPTH", "points": points}
    assert len(json.dumps(order)) < messages.MAX_SIZE


def test_recorded(tmp_path: Path) -> None:
    """So that a replay can show it."""

    async def test() -> str:
        async with world(record=tmp_path) as w:
            name = str(w.service.hub.state["recording"])
            _, other = await begun(w)
            w.supervisor.send(b"MPRG:2;3;70", b"MEND:done")
            await other.event("mission_done")
        return name

    name = asyncio.run(test())
    text = (tmp_path / name / "events.jsonl").read_text()
    lines = [json.loads(line) for line in text.splitlines()]
    shown = [line["mission"] for line in lines if "mission" in line]
    assert shown == [None, mission(1, None), mission(2, 70), None]
    (order,) = [line for line in lines if line["type"] == "order"]
    assert (order["label"], order["value"]) == ("MPTH", 3)
