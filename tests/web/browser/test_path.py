#  SPDX-License-Identifier: GPL-3.0-or-later
"""The whole path through the page, as a newcomer takes it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

from conftest import Visitors
from parties import await_
from selenium.webdriver.common.keys import Keys
from stand import Stand, held, patient_gateway, pixel


def test_path(
    stands: Callable[..., Stand], visitors: Visitors, tmp_path: Path, recordings: Path
) -> None:
    """Start, a key, Space, the arena, a mission, its replay. No time is measured."""
    stand = stands("--record", recordings, program=patient_gateway(tmp_path))
    x, y, _ = stand.emulator.pose
    page = visitors.open(stand.address)
    page.start()
    assert stand.emulator.status()["watchdog"] == "on"

    stand.drives(page, "w")
    assert stand.emulator.pose[0] > x and stand.emulator.pose[1:] == (y, 0)
    with held(page, "a"):
        stand.moves()
        page.press(Keys.SPACE)
        stand.stands()
    #  how far it went depends on the machine
    stand.emulator.ask("pose 25 20 0")
    assert "Forward" in page.logged(label="RGFW", answer="AACK")["text"]

    page.confirm_arena()
    place = (55.0, 40.0)
    page.click_at(pixel(place))
    stand.arrives(page, place)

    (recording,) = recordings.iterdir()
    events = recording / "events.jsonl"
    await_(lambda: "mission_done" in events.read_text("utf-8"), "it is recorded")
    page.replay(f"[data-recording='{recording.name}']")
    await_(lambda: int(page.data("index", "replay-picture")) > 0, "it is played")
    lines = events.read_text("utf-8").splitlines()
    begun = json.loads(next(line for line in lines if '"mission":{' in line))
    (point,) = begun["mission"]["points"]
    end = float(page.element("replay-slider").get_attribute("max"))
    for moment, drawn in ((0, []), (begun["t"], [tuple(point)]), (end, [])):
        page.replay_at(moment)
        assert page.points("plan", "replay-overlay") == drawn
