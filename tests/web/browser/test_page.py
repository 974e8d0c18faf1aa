#  SPDX-License-Identifier: GPL-3.0-or-later
"""One drives, others watch: the wheel, tokens, the arena, the words, what a
screen reader needs, recordings."""

from __future__ import annotations

import csv
import io
import json
import threading
import time
from collections.abc import Callable
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from conftest import TEACHERS, VIEWERS, Pictures, Visitors
from parties import await_
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.remote.webelement import WebElement
from stand import Page, Stand, held


def rename(page: Page, name: str) -> None:
    page.write("name", name)
    page.click("name-change")


def log_in(page: Page, token: str) -> None:
    page.element("token").send_keys(token)
    page.click_one("[type=submit]")


def test_wheel(stand: Stand, driver: Page, watcher: Page, pictures: Pictures) -> None:
    """Asked for, declined, asked for, given; the robot stands meanwhile."""
    other = watcher
    rename(driver, "Ada")
    rename(other, "Grace")
    await_(lambda: "Ada" in other.text("wheel-who"), "who drives")
    other.await_images(1)
    assert not other.visible("wheel-seize")

    #  who watches does not drive
    other.press("w")
    stand.stays()
    assert other.data("held") == ""

    other.click("wheel-ask")
    driver.one("#asking [data-decline]")
    pictures.take(driver, "web-wheel")
    driver.click_one("#asking [data-decline]")
    other.logged(code="wheel_declined")
    assert other.data("wheel") == "other"

    other.click("wheel-ask")
    with held(driver, "w"):
        stand.moves()
        driver.click_one("#asking [data-give]")
        other.shows("wheel", "me")
        stand.stands()
    driver.shows("wheel", "other")
    stand.drives(other)

    #  everybody may stop, and it is said who did
    with held(other, "d"):
        stand.moves()
        driver.press(" ")
        stand.stands(within=0.5)
    assert "Ada" in other.logged(code="stopped_by")["text"]

    other.click("wheel-release")
    driver.shows("wheel", "free")


def test_waiting_for_the_wheel(driver: Page, watcher: Page) -> None:
    """A request is withdrawn; who waits is told that the wheel is free; who gets
    it is told so."""
    other = watcher
    other.click("wheel-ask")
    await_(lambda: driver.visible("asking"), "the question")
    other.click("wheel-withdraw")
    await_(lambda: not driver.visible("asking"), "it is withdrawn")
    other.click("wheel-ask")
    await_(lambda: driver.visible("asking"), "the question")
    driver.click("wheel-release")
    await_(lambda: "wheel is free" in other.text("alert"), "it is told")
    assert "free" in other.run("return document.title")
    other.click("wheel-take")
    other.shows("wheel", "me")
    await_(lambda: "You drive now" in other.text("news"), "it is told")
    assert "wheel is free" not in other.text("alert")


@pytest.mark.parametrize("taken", [True, False])
def test_the_wheel_is_offered(
    stand: Stand, driver: Page, watcher: Page, taken: bool
) -> None:
    """To one who has not asked, and may decline."""
    other = watcher
    driver.click_one("#viewers [data-offer]")
    await_(lambda: other.visible("asking"), "the question")
    assert not other.all("#viewers [data-offer]")
    with held(driver, "w"):
        stand.moves()
        other.click_one(f"#asking [data-{'take' if taken else 'decline'}]")
        if taken:
            other.shows("wheel", "me")
            stand.stands()
    await_(lambda: not other.visible("asking"), "the question is away")
    if taken:
        await_(lambda: "You drive now" in other.text("news"), "it is told")
        stand.drives(other)
    else:
        driver.logged(code="wheel_unwanted")
        assert driver.data("wheel") == "me"


@pytest.mark.parametrize(
    ("language", "keys"),
    [("en", ("W A S D", "Space", "Esc")), ("fr", ("Z Q S D", "Espace", "Échap"))],
)
def test_keyboard_help(
    stand: Stand, visitors: Visitors, axe: str, language: str, keys: tuple[str, ...]
) -> None:
    """By its key and its button; not while a text is written."""
    page = visitors.open(stand.address, languages=language)
    page.start()
    for how in ("key", "button"):
        if how == "key":
            page.press("?")
        else:
            page.click("help-open")
        await_(lambda: page.visible("help"), "the help")
        assert all(key in page.text("help") for key in keys)
        judge(page, axe, "the help")
        page.click("help-close")
        assert not page.visible("help")
    page.press("?")
    page.shows("link", "open")
    if page.data("wheel") != "me":
        page.run("document.getElementById('wheel-take').click()")
        page.shows("wheel", "me")
    page.press(Keys.ESCAPE)
    await_(lambda: not page.visible("help"), "the help is away")
    page.element("name").send_keys("?")
    assert str(page.element("name").get_attribute("value")).endswith("?")
    assert not page.visible("help")


def test_tokens(guarded: Stand, visitors: Visitors) -> None:
    """A wrong one, the viewers', and the teacher's, who takes the wheel."""
    stand = guarded
    pupil = visitors.open(stand.address)
    log_in(pupil, "not-the-right-word")
    await_(lambda: pupil.text("refused"), "it is refused")
    log_in(pupil, VIEWERS)
    pupil.start()
    assert not pupil.visible("wheel-seize")
    (cookie,) = pupil.driver.get_cookies()
    assert cookie["httpOnly"] and cookie["sameSite"] in ("Strict", "Lax"), cookie
    assert VIEWERS not in cookie["value"]

    teacher = visitors.open(stand.address, 1)
    log_in(teacher, TEACHERS)
    teacher.shows("wheel", "other")
    with held(pupil, "w"):
        stand.moves()
        teacher.click("wheel-seize")
        teacher.shows("wheel", "me")
        stand.stands(within=0.5)
    pupil.shows("wheel", "other")
    assert pupil.logged(code="wheel_seized")
    assert not pupil.visible("wheel-seize")
    stand.drives(teacher)
    said = "\n".join(stand.gateway.lines + stand.supervisor.lines)
    assert TEACHERS not in said and VIEWERS not in said


def test_pupils(guarded: Stand, visitors: Visitors) -> None:
    """A teacher mutes and expels; who logs out has the form again."""
    pupil, teacher = (visitors.open(guarded.address, number) for number in range(2))
    log_in(pupil, VIEWERS)
    pupil.shows("link", "open")
    assert not pupil.all("[data-mute]")
    pupil.click("wheel-take")
    pupil.shows("wheel", "me")
    log_in(teacher, TEACHERS)
    teacher.shows("wheel", "other")

    def button(name: str) -> WebElement:
        (found,) = teacher.all(f"[data-{name}]")  # not for herself
        return found

    teacher.click_element(button("mute"))
    pupil.shows("wheel", "free")
    await_(lambda: pupil.text("alert"), "it says so")
    assert teacher.logged(code="muted")
    await_(lambda: button("mute").get_attribute("aria-pressed") == "true", "pressed")
    teacher.click_element(button("mute"))
    await_(lambda: teacher.logged(code="unmuted"), "ended")
    teacher.click_element(button("expel"))
    teacher.click("expel-yes")
    pupil.one("#token")
    assert teacher.logged(code="expelled")
    teacher.click_one("#logout button")
    teacher.one("#token")


def test_join_by_code(guarded: Stand, visitors: Visitors, axe: str) -> None:
    """What the code says leads a pupil in, who gives the token only if it does not."""
    teacher = visitors.open(guarded.address)
    log_in(teacher, TEACHERS)
    teacher.click("join-open")
    await_(lambda: teacher.visible("join-code"), "the code")
    assert teacher.text("join-address") == guarded.address + "/"
    judge(teacher, axe, "the code")
    pupil = visitors.open(teacher.text("join-address"), 1)
    assert pupil.visible("token")

    teacher.click("join-token")
    await_(lambda: VIEWERS in teacher.text("join-address"), "the class's token")
    for _ in range(2):  # a second time, too
        pupil.driver.get("about:blank")
        pupil.driver.get(teacher.text("join-address"))
        pupil.shows("link", "open")
        assert pupil.driver.current_url == guarded.address + "/"
        assert not pupil.visible("join-open")
    assert TEACHERS not in teacher.run("return document.documentElement.outerHTML")
    teacher.click("join-close")


def test_the_fifth_page(guarded: Stand, visitors: Visitors) -> None:
    """It says why it is not connected, and what to do."""
    visitors.excuse("/ws")
    first = visitors.open(guarded.address)
    log_in(first, VIEWERS)
    first.shows("link", "open")
    for _ in range(3):
        visitors.open(guarded.address).shows("link", "open")
    fifth = visitors.open(guarded.address, languages="fr")
    await_(lambda: "Fermez-en une" in fifth.text("alarms"), "it says so")
    first.driver.get("about:blank")
    fifth.shows("link", "open")
    assert not fifth.visible("alarms")


def test_nothing_from_elsewhere(stand: Stand, page: Page, visitors: Visitors) -> None:
    """The browser itself refuses what the page's policy does not allow."""
    visitors.excuse("Content Security Policy")
    page.shows("link", "open")
    page.run(
        "const s = document.createElement('script');"
        "s.textContent = 'window.planted = true'; document.body.append(s)"
    )
    assert page.run("return window.planted") is None
    asked = page.driver.execute_async_script(
        "const done = arguments[1];"
        #  without "no-cors" it would be refused in any case
        "fetch(arguments[0], {mode: 'no-cors'})"
        ".then(() => done('answered'), () => done('refused'))",
        f"http://127.0.0.1:{stand.gateway.port}/",
    )
    assert asked == "refused"


def test_foreign_page(page: Page, visitors: Visitors, tmp_path: Path) -> None:
    """That of another address gets no connection, in the same browser."""
    visitors.excuse("WebSocket connection to")
    page.shows("link", "open")
    (tmp_path / "index.html").write_text("<link rel=icon href=data:,><title>x</title>")
    serve = partial(SimpleHTTPRequestHandler, directory=tmp_path)
    #  with threads: a connection that Chromium opens in advance stays silent
    with ThreadingHTTPServer(("127.0.0.1", 0), serve) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        foreign = visitors.open(f"http://127.0.0.1:{server.server_port}")
        ended = foreign.driver.execute_async_script(
            "const socket = new WebSocket(arguments[0]), done = arguments[1];"
            "socket.onopen = () => done('open'); socket.onclose = () => done('closed')",
            page.address.replace("http", "ws") + "/ws",
        )
        server.shutdown()
    assert ended == "closed"
    assert page.data("link") == "open"


def test_arena(driver: Page, watcher: Page, pictures: Pictures) -> None:
    """Searched, rejected; searched, confirmed; who watches is not asked."""
    driver.click("arena-search")
    driver.shows("arena", "found")
    watcher.shows("arena", "found")
    await_(lambda: driver.visible("arena-question"), "the question")
    assert not watcher.visible("arena-question")
    pictures.take(driver, "web-arena")
    driver.click("arena-reject")
    driver.shows("arena", "none")
    driver.click("arena-search")
    driver.shows("arena", "found")
    driver.click("arena-confirm")
    watcher.shows("arena", "confirmed")
    watcher.await_images(5)


def test_french(stand: Stand, visitors: Visitors) -> None:
    """By the browser's language at first, then as chosen, remembered."""
    page = visitors.open(stand.address, languages="fr-FR,fr;q=0.9,en;q=0.5")
    assert page.run("return document.documentElement.lang") == "fr"
    page.start()
    assert page.text("wheel-who") == "Vous conduisez"
    french = set()
    for language in ("fr", "en"):
        page.click_one(f"[data-language={language}]")
        assert page.run("return document.documentElement.lang") == language
        texts = page.run(
            "return [...document.querySelectorAll('[data-t]')].map(e =>"
            "e.dataset.t + ': ' + e.textContent)"
        )
        assert not [one for one in texts if one.endswith(": ")]
        if language == "fr":
            french = set(texts)
        else:
            same = french & set(texts)
            assert len(same) < len(texts) / 4, same
    page.driver.refresh()
    page.shows("link", "open")
    assert page.run("return document.documentElement.lang") == "en"


def judge(page: Page, axe: str, state: str) -> None:
    """Nothing serious, nothing critical."""
    page.run(axe)
    found = page.driver.execute_async_script(
        "const done = arguments[arguments.length - 1];"
        "axe.run(document, {resultTypes: ['violations']}).then("
        "r => done(r.violations), e => done([{impact: 'critical', id: String(e)}]))"
    )
    serious = [
        f"{state}: {one['id']}: {json.dumps(one.get('nodes', ''), indent=1)[:1500]}"
        for one in found
        if one["impact"] in ("serious", "critical")
    ]
    assert not serious, "\n".join(serious)


def test_axe_login(guarded: Stand, visitors: Visitors, axe: str) -> None:
    judge(visitors.open(guarded.address), axe, "the form")


def test_recording(
    recorder: Stand,
    recordings: Path,
    visitors: Visitors,
    request: pytest.FixtureRequest,
    pictures: Pictures,
) -> None:
    """Recorded, replayed with the slider, exported as CSV."""
    stand = recorder
    page = visitors.open(stand.address)
    page.start()
    page.click("move")
    stand.moves_and_stands()
    time.sleep(1)
    (recording,) = [path.name for path in recordings.iterdir()]
    row = f"[data-recording='{recording}']"
    page.replay(row)
    page.click("replay-play")
    length = float(page.element("replay-slider").get_attribute("max"))
    assert length > 1000

    def picture() -> int:
        return int(page.data("index", "replay-picture"))

    def goes_on_at(moment: float) -> None:
        before = picture()
        page.replay_at(moment)
        await_(lambda: picture() > before, f"{moment} of {length} ms")

    #  the very beginning; the last second has images in any case
    page.replay_at(0.0)
    page.shows("index", "0", element="replay-picture")
    goes_on_at(length - 500)
    goes_on_at(length)
    pictures.take(page, "web-replay", at="replay")

    text = page.run(
        "return fetch(document.querySelector(arguments[0]).href).then(r => r.text())",
        f"{row} a",
    )
    rows = list(csv.DictReader(io.StringIO(text)))
    assert list(rows[0]) == [
        *("time_ms", "id", "angle_deg", "x_px", "y_px", "dx_px", "dy_px"),
        *("x_cm", "y_cm", "heading_deg"),
    ]
    there = [row for row in rows if row["id"] == "1"]
    moved = float(there[-1]["x_px"]) - float(there[0]["x_px"])
    assert moved > 30, moved
    judge(page, request.getfixturevalue("axe"), "a replay")


def test_recordings_are_named_and_deleted(
    stands: Callable[..., Stand],
    tokens: tuple[str, ...],
    visitors: Visitors,
    recordings: Path,
    axe: str,
) -> None:
    """A name is kept; a deletion is asked for; that being written stays. Viewers
    replay."""
    old = recordings / "20261123T120000.123Z"
    old.mkdir()
    (old / "events.jsonl").write_text('{"t":1,"type":"state"}\n', encoding="ascii")
    (old / "images.mjpeg").touch()
    stand = stands("--record", recordings, *tokens)
    viewer, page = (visitors.open(stand.address, number) for number in range(2))
    for one, word in ((viewer, VIEWERS), (page, TEACHERS)):
        log_in(one, word)
        one.shows("link", "open")
    viewer.one("#recordings-list [data-do=replay]")
    assert not viewer.all("[data-do=name], [data-do=delete]")
    row = f"[data-recording='{old.name}']"
    page.click_one(f"{row} [data-do=name]")
    page.one(f"{row} input").send_keys("Première fois", Keys.ENTER)
    await_(lambda: page.one(f"{row} strong").text, "the name")
    page.driver.refresh()
    page.shows("link", "open")
    assert page.one(f"{row} strong").text == "Première fois"
    assert (old / "title.txt").read_text(encoding="utf-8") == "Première fois"
    deletes = page.all("[data-do=delete]")
    assert len(deletes) == 1, "not of the recording that is being written"
    for button in ("delete-no", "delete-yes"):
        page.click_one(f"{row} [data-do=delete]")
        await_(lambda: page.visible("delete"), "the question")
        assert "Première fois" in page.text("delete")
        judge(page, axe, "the question")
        assert old.exists()
        page.click(button)
    await_(lambda: not page.all(f"{row} td"), "it is gone")
    assert not old.exists()
