#  SPDX-License-Identifier: GPL-3.0-or-later
"""Missions: taken, refused, shown to everybody, ended."""

import json
from pathlib import Path

import pytest
from destijl_web import messages
from helpers import Json, Page, World, world

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
async def test_taken(
    w: World, label: str, points: list[list[float]], unit: str, line: str
) -> None:
    driver, other = await w.driver(), await w.page()
    assert (await driver.order(label, points=points))["answer"] == "AACK"
    await w.supervisor.heard(line)
    event = await other.event("order", label=label)
    assert event["args"]["value"] == len(points)
    plan = mission(1, None) | {"unit": unit, "points": points, "of": len(points)}
    await other.state(mission=plan)
    #  who comes later sees it, too
    assert (await w.page()).welcome["state"]["mission"] == plan


async def test_the_longest_path_fits(w: World) -> None:
    driver = await w.driver()
    points = [[9999, 1079.9]] * 64
    assert (await driver.order("MPTH", points=points))["answer"] == "AACK"
    await w.supervisor.heard("MPTH:" + ";".join(["9999.0;1079.9"] * 64))
    assert max(map(len, w.supervisor.lines)) < 1024


async def test_progress_and_end(w: World) -> None:
    _, other = await begun(w)
    for leg, distance in ((1, 200), (1, 90), (2, 155), (3, 0)):
        w.supervisor.send(b"MPRG:%d;3;%d" % (leg, distance))
        await other.state(mission=mission(leg, distance))
    w.supervisor.send(b"MEND:done")
    await other.state(mission=None)
    assert (await other.event("mission_done"))["level"] == "info"


@pytest.mark.parametrize(
    ("reason", "level"),
    [("order by hand", "info"), ("robot not seen in 3 images", "warning")],
)
async def test_aborted(w: World, reason: str, level: str) -> None:
    _, other = await begun(w)
    w.supervisor.send(b"MEND:aborted;" + reason.encode())
    await other.state(mission=None)
    assert (await other.event("mission_aborted", reason=reason))["level"] == level
    #  the next one is another
    w.supervisor.send(b"MPRG:2;3;100", b"RBLV:1")
    await other.state(battery=1)
    assert w.service.hub.state["mission"] is None


async def test_what_is_no_progress(w: World) -> None:
    w.supervisor.send(b"MPRG:1;3;100", b"MEND:done", b"RBLV:2")
    driver, other = await begun(w)
    for what in (b"", b"1;3", b"0;3;1", b"4;3;1", b"1;2;1", b"1;3;-1", b"1;3;1.5"):
        w.supervisor.send(b"MPRG:" + what)
    w.supervisor.send(b"MPRG:1;3;" + b"9" * 50, b"MPRG:1;3;1;1", b"RBLV:1")
    await other.state(battery=1)
    assert w.service.hub.state["mission"] == mission(1, None)
    codes = [said.get("code") for said in driver.said]
    assert "mission_done" not in codes
    w.supervisor.send(b"MEND:\x1b\xff")
    await other.event("mission_aborted", reason="?\ufffd")
    await other.state(mission=None)


@pytest.mark.parametrize("answer", ["ANAK", "ACRJ", "ACER"])
async def test_refused(w: World, answer: str) -> None:
    driver = await w.driver()
    w.supervisor.answers["MGTO"] = (
        answer.encode() + b"\nMSSG:mission not possible: robot not started"
    )
    assert (await driver.order("MGTO", points=[[1, 2]]))["answer"] == answer
    event = await driver.event("mission_refused", reason="robot not started")
    assert event["level"] == "warning"
    assert w.service.hub.state["mission"] is None


async def test_a_refusal_leaves_the_one_under_way(w: World) -> None:
    driver, _ = await begun(w)
    w.supervisor.answers["MGTO"] = b"ACRJ"
    assert (await driver.order("MGTO", points=[[1, 2]]))["answer"] == "ACRJ"
    assert w.service.hub.state["mission"] == mission(1, None)


async def test_who_may(w: World) -> None:
    """Only the driver sends the robot somewhere; everybody may end it."""
    driver, other = await begun(w)
    assert (await other.order("MGTO", points=[[1, 2]]))["answer"] == "NOWHEEL"
    assert (await other.order("MABT"))["answer"] == "AACK"
    await driver.event("stopped_by", name="#2")
    assert w.supervisor.lines[1:] == [SENT, "MABT"]


async def test_not_beyond_the_session(w: World) -> None:
    _, other = await begun(w)
    w.supervisor.hang_up()
    await other.state(mission=None)
    await other.event("supervisor_connected")


def test_messages_are_not_too_large() -> None:
    points = [[-1919.125, -1079.125]] * 64
    order = {"type": "order", "id": 2**53, "label": "MPTH", "points": points}
    assert len(json.dumps(order)) < messages.MAX_SIZE


async def test_recorded(tmp_path: Path) -> None:
    """So that a replay can show it."""
    async with world(record=tmp_path) as w:
        name = str(w.service.hub.state["recording"])
        _, other = await begun(w)
        w.supervisor.send(b"MPRG:2;3;70", b"MEND:done")
        await other.event("mission_done")
    text = (tmp_path / name / "events.jsonl").read_text()
    lines = [json.loads(line) for line in text.splitlines()]
    shown = [line["mission"] for line in lines if "mission" in line]
    assert shown == [None, mission(1, None), mission(2, 70), None]
    (order,) = [line for line in lines if line["type"] == "order"]
    assert (order["label"], order["value"]) == ("MPTH", 3)
