#  SPDX-License-Identifier: GPL-3.0-or-later
"""Sessions that are recorded, and given back."""

import json
import os
import resource
import threading
from datetime import datetime
from pathlib import Path
from queue import Queue
from typing import Any

import pytest
from destijl_web import ground, recording
from destijl_web.recording import Recording
from destijl_web.recordings import (
    CSV_HEAD,
    Recordings,
    csv_pieces,
    make_room,
    opener,
)
from helpers import GROUND, LIMIT, TOKENS, World, jpeg, until, world


def lines_of(folder: Path) -> list[dict[str, Any]]:
    text = (folder / "events.jsonl").read_text()
    return [json.loads(line) for line in text.splitlines()]


def is_written(folder: Path) -> bool:
    """To the end of its session, which is the last line; images are first."""
    text = (folder / "events.jsonl").read_text()
    return '"connecting"' in text and text.endswith("\n")


async def drive(w: World) -> None:
    page = await w.driver()
    await page.order("ROPN")
    await page.order("RTRN", value=-90)
    await page.order("COPN")
    for number in range(5):
        w.supervisor.send_image(number, 1000 + number)
        w.supervisor.send(b"CPOS:7;1.5;%d.000000;2;3;4" % number)
        await page.image()
        await page.expect("position", x=float(number))
    w.supervisor.hang_up()
    await page.event("supervisor_lost")
    await page.event("supervisor_connected")


async def test_what_is_written(tmp_path: Path) -> None:
    async with world(record=tmp_path) as w:
        first = w.service.hub.state["recording"]
        await drive(w)
        second = w.service.hub.state["recording"]
        assert first and second and first < second
        await until(lambda: is_written(tmp_path / first))
    lines = lines_of(tmp_path / first)
    images = (tmp_path / first / "images.mjpeg").read_bytes()
    assert lines[0]["type"] == "state" and lines[0]["robot"] == "closed"
    assert [one["t"] for one in lines] == sorted(one["t"] for one in lines)
    cut = [
        images[one["offset"] : one["offset"] + one["length"]]
        for one in lines
        if one["type"] == "image"
    ]
    assert cut == [jpeg(number, 1000 + number) for number in range(5)]
    order = next(one for one in lines if one.get("label") == "RTRN")
    assert order["type"] == "order"
    assert (order["value"], order["name"]) == (-90, "#1")
    answer = next(
        o for o in lines if o.get("label") == "RTRN" and o["type"] == "answer"
    )
    assert answer["answer"] == "AACK" and answer["ms"] >= 0.0
    assert [o["x"] for o in lines if o["type"] == "position"] == [0, 1, 2, 3, 4]
    states = [one for one in lines if one["type"] == "state"]
    robots = [s["robot"] for s in states if "robot" in s]
    assert robots == ["closed", "open", "closed"]
    codes = [one["code"] for one in lines if one["type"] == "event"]
    assert codes[0] == "supervisor_connected" and "order" in codes


async def test_what_is_given(tmp_path: Path) -> None:
    async with world(record=tmp_path) as w:
        page = await w.page()
        assert page.welcome["recordings"] is True
        name = page.welcome["state"]["recording"]
        await drive(w)
        await until(lambda: is_written(tmp_path / name))
        client = w.client()

        async def get(path: str, **headers: str) -> tuple[int, bytes]:
            async with client.get(w.url + path, headers=headers) as answer:
                return answer.status, await answer.read()

        status, body = await get("/recordings")
        assert status == 200
        listed = json.loads(body)
        assert [one["name"] for one in listed][1] == name
        events = (tmp_path / name / "events.jsonl").read_bytes()
        images = (tmp_path / name / "images.mjpeg").read_bytes()
        last = json.loads(events.splitlines()[-1])
        assert listed[1] == {
            "name": name,
            "title": "",
            "number": 1,
            "start": listed[1]["start"],
            "duration": last["t"],
            "images": 5,
            "bytes": len(events) + len(images),
        }
        assert listed[0]["start"] > listed[1]["start"] > 1.6e12
        base = f"/recordings/{name}"
        assert await get(f"{base}/events.jsonl") == (200, events)
        assert await get(f"{base}/images.mjpeg") == (200, images)
        part = await get(f"{base}/images.mjpeg", Range="bytes=1000-2000")
        assert part == (206, images[1000:2001]) and part[1] == jpeg(1, 1001)
        part = await get(f"{base}/images.mjpeg", Range="bytes=9999999-")
        assert part[0] == 416
        status, body = await get(f"{base}/positions.csv")
        rows = body.decode().splitlines()
        assert status == 200 and rows[0] + "\n" == CSV_HEAD
        assert [row.split(",", 1)[1] for row in rows[1:]] == [
            f"7,1.5,{x}.0,2.0,3.0,4.0,,," for x in range(5)
        ]
        for bad in (
            "/recordings/20261123T120000.123Z/events.jsonl",
            "/recordings/../events.jsonl",
            "/recordings/%2e%2e/events.jsonl",
            f"{base}/other.jsonl",
            f"{base}x/events.jsonl",
            f"{base}/events.jsonl/",
        ):
            assert (await get(bad))[0] == 404


def stored(folder: Path, name: str, size: int = 1000) -> Path:
    """A recording of an earlier session."""
    made = folder / name
    made.mkdir()
    (made / "events.jsonl").write_text('{"t":1,"type":"state"}\n')
    (made / "images.mjpeg").write_bytes(bytes(size))
    return made


OLD = [f"20261123T12000{n}.000Z" for n in range(4)]


async def test_named_and_deleted(tmp_path: Path) -> None:
    old = stored(tmp_path, OLD[0])
    async with world(record=tmp_path) as w:
        page = await w.page()
        active = page.welcome["state"]["recording"]
        await until((tmp_path / active / "images.mjpeg").exists)
        client = w.client()

        async def ask(method: str, path: str, title: str = "", **headers: str) -> int:
            own = headers or {"Origin": w.url}
            async with client.request(
                method, f"{w.url}/recordings/{path}", data=title, headers=own
            ) as answer:
                return answer.status

        async def titles() -> dict[str, str]:
            async with client.get(f"{w.url}/recordings") as answer:
                return {one["name"]: one["title"] for one in await answer.json()}

        assert await ask("PUT", f"{OLD[0]}/title", " Première fois ") == 204
        assert await ask("PUT", f"{active}/title", "now") == 204
        assert await titles() == {OLD[0]: "Première fois", active: "now"}
        for bad in ("x" * 61, "a\nb", "\x1b[31m"):
            assert await ask("PUT", f"{OLD[0]}/title", bad) == 400
        assert await ask("PUT", f"{OLD[1]}/title", "x") == 404
        assert await ask("PUT", f"{OLD[0]}x/title", "x") == 404
        assert await ask("PUT", f"{active}/title", "") == 204
        assert await titles() == {OLD[0]: "Première fois", active: ""}
        for foreign in ({"Origin": "http://robot.example"}, {"X-Other": "1"}):
            assert await ask("DELETE", OLD[0], **foreign) == 403
            assert await ask("PUT", f"{OLD[0]}/title", "x", **foreign) == 403
        assert await ask("DELETE", active) == 409
        assert await ask("DELETE", OLD[1]) == 404
        assert await ask("DELETE", f"{OLD[0]}x") == 404
        assert old.exists()
        assert await ask("DELETE", OLD[0]) == 204
        assert not old.exists()
        assert await titles() == {active: ""}


def test_the_order_without_a_clock(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By number, also across restarts; two of the same millisecond are two."""

    class Clock(datetime):
        year_now = 1970

        @classmethod
        def now(cls, tz: Any = None) -> "Clock":
            return cls(cls.year_now, 1, 1, tzinfo=tz)

    def failed(_: Recording, reason: str) -> None:
        raise AssertionError(reason)

    def record() -> str:
        one = Recording(tmp_path, 10**9, failed)
        one.put("state", {})
        one.close()
        one.join()
        return one.name

    monkeypatch.setattr(recording, "datetime", Clock)
    stored(tmp_path, OLD[0])
    names = [OLD[0], record(), record()]
    Clock.year_now = 2026
    names.append(record())
    recording._numbers.clear()  # as after a restart
    Clock.year_now = 1970
    names.append(record())
    found = Recordings(tmp_path).all()
    assert [one["name"] for one in reversed(found)] == names
    assert [one["number"] for one in reversed(found)] == [0, 1, 2, 3, 4]
    assert make_room(tmp_path / names[-1], sum(one["bytes"] for one in found[:-2]))
    assert not (tmp_path / names[1]).exists()
    assert (tmp_path / names[2]).exists()


async def test_not_for_others(tmp_path: Path) -> None:
    """Whatever the umask; nor is anything written behind a symbolic link."""
    folder = tmp_path / "recordings"
    folder.mkdir()
    umask = os.umask(0)
    try:
        async with world(record=folder) as w:
            await w.page()
            name = w.service.hub.state["recording"]
    finally:
        os.umask(umask)
    assert Recordings(folder).entitle(name, "one")
    made = folder / name
    assert made.stat().st_mode & 0o777 == 0o750
    assert len(list(made.iterdir())) == 3
    assert all(file.stat().st_mode & 0o137 == 0 for file in made.iterdir())
    (made / "title.txt").unlink()
    (made / "title.txt").symlink_to(tmp_path / "other")
    with pytest.raises(OSError, match="symbolic links"):
        opener(str(made / "title.txt"), os.O_WRONLY)
    assert not Recordings(folder).entitle(name, "two")
    assert not (tmp_path / "other").exists()


@pytest.mark.parametrize(
    ("token", "status"),
    [("", 401), ("secret-of-viewers", 403), ("secret-of-teacher", 204)],
)
async def test_who_may_delete(tmp_path: Path, token: str, status: int) -> None:
    """Not those who have the viewers' token."""
    old = stored(tmp_path, OLD[0])
    async with world(record=tmp_path, **TOKENS) as w:
        client = w.client()
        if token:
            await client.post(f"{w.url}/login", data={"token": token})
        own = {"Origin": w.url}
        base = f"{w.url}/recordings/{OLD[0]}"
        async with client.put(f"{base}/title", data="x", headers=own) as answer:
            assert answer.status == status
        async with client.delete(base, headers=own) as answer:
            assert answer.status == status
    assert old.exists() == (status != 204)


async def test_bounded(tmp_path: Path) -> None:
    """The oldest without a name go; if that is not enough, recording ends."""
    olds = [stored(tmp_path, name, 100_000) for name in OLD]
    (olds[0] / "title.txt").write_text("kept")
    (tmp_path / "other").mkdir()
    async with world(record=tmp_path, record_limit=350_000) as w:
        page = await w.driver()
        await until(lambda: not olds[1].exists())
        assert [old.exists() for old in olds] == [True, False, True, True]
        for number in range(6):
            w.supervisor.send_image(number, 50_000)
            await page.image()
        event = await page.event("recording_failed")
        assert "limit" in event["args"]["reason"]
        assert [old.exists() for old in olds] == [True, False, False, False]
        assert (tmp_path / "other").exists()
        assert w.service.hub.state["recording"] is None
        assert (await page.order("RPIN"))["answer"] == "AACK"


async def test_nothing_is_recorded() -> None:
    async with world() as w, w.client().get(f"{w.url}/recordings") as answer:
        assert answer.status == 404


def test_no_way_out_by_a_link(tmp_path: Path) -> None:
    outside = stored(tmp_path, "outside")
    inside = tmp_path / "inside"
    inside.mkdir()
    link, folder = OLD[:2]
    (inside / link).symlink_to(outside)
    recordings = Recordings(inside)
    assert recordings.all() == []
    assert not recordings.delete(link)
    assert not recordings.entitle(link, "x")
    assert {path.name for path in outside.iterdir()} == {"events.jsonl", "images.mjpeg"}
    (inside / folder).mkdir()
    (inside / folder / "events.jsonl").symlink_to(outside / "events.jsonl")
    for name in (link, folder):
        assert recordings.file(name, "events.jsonl") is None


def test_torn_recordings(tmp_path: Path) -> None:
    folder = tmp_path / "20261123T120000.123Z"
    folder.mkdir()
    events = folder / "events.jsonl"
    events.write_text(
        '{"t":5,"type":"position","id":1,"angle":0,"x":1,"y":2,"dx":3,"dy":4}\n'
        '{"t":6,"type":"position","id":1,"angle":"0","x":1,"y":2,"dx":3,"dy":4}\n'
        '{"t":7,"type":"position"}\n'
        '{"t":8,"type":"posi'
    )
    recordings = Recordings(tmp_path)
    assert recordings.all() == []
    (folder / "images.mjpeg").touch()
    assert recordings.all()[0]["duration"] == 7
    assert "".join(csv_pieces(events)) == CSV_HEAD + "5,1,0,1,2,3,4,,,\n"


def test_images_are_counted_across_pieces(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("destijl_web.recordings._PIECE", 17)
    events = stored(tmp_path, OLD[0]) / "events.jsonl"
    events.write_text('{"t":1,"type":"image","offset":0}\n' * 50)
    assert Recordings(tmp_path).all()[0]["images"] == 50


async def test_a_full_disk(tmp_path: Path) -> None:
    """As one: no file may be larger than it is allowed to be."""
    async with world(record=tmp_path) as w:
        page = await w.driver()
        before = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, before[1]))
        try:
            for number in range(5):
                w.supervisor.send_image(number, 50_000)
                assert await page.image() == jpeg(number, 50_000)
            events = w.service.hub._events
            await until(lambda: events[-1]["code"] == "recording_failed")
            assert events[-1]["args"] == {"reason": "File too large"}
            assert w.service.hub.state["recording"] is None
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, before)
        assert (await page.order("RPIN"))["answer"] == "AACK"
        codes = [one.get("code") for one in page.said]
        assert codes.count("recording_failed") == 1


def test_a_folder_that_is_gone(tmp_path: Path) -> None:
    reasons: Queue[str] = Queue()
    made = Recording(tmp_path / "gone", 10**9, lambda _, reason: reasons.put(reason))
    assert reasons.get(timeout=LIMIT) == "No such file or directory"
    made.put("event", {})
    made.join()
    assert reasons.empty()


def test_a_disk_that_is_slow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recording, "MAX_WAITING", 1_000_000)
    hangs = threading.Event()
    monkeypatch.setattr(Recording, "_write", lambda self: hangs.wait(LIMIT))
    reasons: list[str] = []
    made = Recording(tmp_path, 10**9, lambda _, reason: reasons.append(reason))
    for number in range(20):
        made.put("image", {}, jpeg(number, 100_000))
    assert reasons == ["the disk is too slow"]
    hangs.set()
    made.join()


def test_positions_in_centimetres(tmp_path: Path) -> None:
    """From the confirmation of an arena to its end."""
    events = tmp_path / "events.jsonl"
    position = {"type": "position", "id": 1, "angle": 0, "x": 100, "y": 50}
    lines: list[dict[str, object]] = [
        {"type": "state", "ground": ground.read(GROUND)},
        position | {"t": 5, "dx": 540, "dy": 60},
        position | {"t": 6, "dx": 540, "dy": 60, "id": -1},
        {"type": "state", "ground": None, "arena": "none"},
        position | {"t": 7, "dx": 540, "dy": 60},
    ]
    events.write_text(
        "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines)
    )
    rows = "".join(csv_pieces(events)).splitlines()[1:]
    ends = [row.split(",")[7:] for row in rows]
    none = ["", "", ""]
    assert ends == [["0.00", "60.00", "0.00"], none, none]
