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
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from conftest import Pictures, Visitors
from parties import await_
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.remote.webelement import WebElement
from stand import Page, Stand, held

TEACHERS = "the-teacher-s-own-word"
VIEWERS = "the-word-for-the-class"


@pytest.fixture
def tokens(tmp_path: Path) -> tuple[str | Path, ...]:
    """The gateway's options that name their files."""
    options: list[str | Path] = []
    for option, word in (("--token", TEACHERS), ("--viewers-token", VIEWERS)):
        path = tmp_path / option.strip("-")
        path.touch(mode=0o600)
        path.write_text(word + "\n", encoding="ascii")
        options += [option, path]
    return tuple(options)


def rename(page: Page, name: str) -> None:
    field = page.element("name")
    field.clear()
    field.send_keys(name)
    page.click("name-change")


def log_in(page: Page, token: str) -> None:
    page.element("token").send_keys(token)
    page.click_element(page.driver.find_element(By.CSS_SELECTOR, "[type=submit]"))


def test_wheel(
    stand: Stand, driver: Page, visitors: Visitors, pictures: Pictures
) -> None:
    """Asked for, declined, asked for, given; the robot stands meanwhile."""
    other = visitors.open(stand.address, 1)
    other.shows("wheel", "other")
    rename(driver, "Ada")
    rename(other, "Grace")
    await_(lambda: "Ada" in other.text("wheel-who"), "who drives")
    other.await_images(1)
    assert not other.visible("wheel-seize")

    #  who watches does not drive
    other.press("w")
    time.sleep(0.3)
    assert not stand.emulator.moving
    assert other.data("held") == ""

    other.click("wheel-ask")
    ask = await_(
        lambda: driver.driver.find_elements(By.CSS_SELECTOR, "#asking [data-decline]"),
        "the question",
    )
    pictures.take(driver, "web-wheel")
    driver.click_element(ask[0])
    other.logged(code="wheel_declined")
    assert other.data("wheel") == "other"

    other.click("wheel-ask")
    with held(driver, "w"):
        stand.moves()
        give = await_(
            lambda: driver.driver.find_elements(By.CSS_SELECTOR, "#asking [data-give]"),
            "the question",
        )
        driver.click_element(give[0])
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


def test_waiting_for_the_wheel(stand: Stand, driver: Page, visitors: Visitors) -> None:
    """A request is withdrawn; who waits is told that the wheel is free; who gets
    it is told so."""
    other = visitors.open(stand.address, 1)
    other.shows("wheel", "other")
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
    stand: Stand, driver: Page, visitors: Visitors, taken: bool
) -> None:
    """To one who has not asked, and may decline."""
    other = visitors.open(stand.address, 1)
    other.shows("wheel", "other")
    offer = await_(
        lambda: driver.driver.find_elements(By.CSS_SELECTOR, "#viewers [data-offer]"),
        "somebody to offer it to",
    )
    driver.click_element(offer[0])
    await_(lambda: other.visible("asking"), "the question")
    assert not other.driver.find_elements(By.CSS_SELECTOR, "#viewers [data-offer]")
    which = "[data-take]" if taken else "[data-decline]"
    with held(driver, "w"):
        stand.moves()
        other.click_element(
            other.driver.find_element(By.CSS_SELECTOR, f"#asking {which}")
        )
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


@pytest.mark.parametrize("language", ["en", "fr"])
def test_keyboard_help(
    stand: Stand, visitors: Visitors, axe: str, language: str
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
        for key in {
            "en": ("W A S D", "Space", "Esc"),
            "fr": ("Z Q S D", "Espace", "Échap"),
        }[language]:
            assert key in page.text("help")
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


def test_tokens(
    stands: Callable[..., Stand], tokens: tuple[str | Path, ...], visitors: Visitors
) -> None:
    """A wrong one, the viewers', and the teacher's, who takes the wheel."""
    stand = stands(*tokens)
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


def test_pupils(
    stands: Callable[..., Stand], tokens: tuple[str | Path, ...], visitors: Visitors
) -> None:
    """A teacher mutes and expels; who logs out has the form again."""
    stand = stands(*tokens)
    pupil, teacher = visitors.open(stand.address), visitors.open(stand.address, 1)
    log_in(pupil, VIEWERS)
    pupil.shows("link", "open")
    assert not pupil.driver.find_elements(By.CSS_SELECTOR, "[data-mute]")
    pupil.click("wheel-take")
    pupil.shows("wheel", "me")
    log_in(teacher, TEACHERS)
    teacher.shows("wheel", "other")

    def button(name: str) -> WebElement:
        found = teacher.driver.find_elements(By.CSS_SELECTOR, f"[data-{name}]")
        assert len(found) == 1  # not for herself
        return found[0]

    teacher.click_element(button("mute"))
    pupil.shows("wheel", "free")
    await_(lambda: pupil.text("alert"), "it says so")
    assert teacher.logged(code="muted")
    await_(lambda: button("mute").get_attribute("aria-pressed") == "true", "pressed")
    teacher.click_element(button("mute"))
    await_(lambda: teacher.logged(code="unmuted"), "ended")
    teacher.click_element(button("expel"))
    teacher.click("expel-yes")
    await_(lambda: pupil.driver.find_elements(By.ID, "token"), "the form")
    assert teacher.logged(code="expelled")
    teacher.click_element(
        teacher.driver.find_element(By.CSS_SELECTOR, "#logout button")
    )
    await_(lambda: teacher.driver.find_elements(By.ID, "token"), "the form")


def test_join_by_code(
    stands: Callable[..., Stand],
    tokens: tuple[str | Path, ...],
    visitors: Visitors,
    axe: str,
) -> None:
    """What the code says leads a pupil in, who gives the token only if it does not."""
    stand = stands(*tokens)
    teacher = visitors.open(stand.address)
    log_in(teacher, TEACHERS)
    teacher.click("join-open")
    await_(lambda: teacher.visible("join-code"), "the code")
    assert teacher.text("join-address") == stand.address + "/"
    judge(teacher, axe, "the code")
    pupil = visitors.open(teacher.text("join-address"), 1)
    assert pupil.visible("token")

    teacher.click("join-token")
    await_(lambda: VIEWERS in teacher.text("join-address"), "the class's token")
    for _ in range(2):  # a second time, too
        pupil.driver.get("about:blank")
        pupil.driver.get(teacher.text("join-address"))
        pupil.shows("link", "open")
        assert pupil.driver.current_url == stand.address + "/"
        assert not pupil.visible("join-open")
    assert TEACHERS not in teacher.run("return document.documentElement.outerHTML")
    teacher.click("join-close")


def test_the_fifth_page(
    stands: Callable[..., Stand], tokens: tuple[str | Path, ...], visitors: Visitors
) -> None:
    """It says why it is not connected, and what to do."""
    visitors.excuse("/ws")
    stand = stands(*tokens)
    first = visitors.open(stand.address)
    log_in(first, VIEWERS)
    first.shows("link", "open")
    for _ in range(3):
        visitors.open(stand.address).shows("link", "open")
    fifth = visitors.open(stand.address, languages="fr")
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


class Foreign(BaseHTTPRequestHandler):
    """A page of somebody else."""

    def do_GET(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(b"<!doctype html><link rel=icon href=data:,><title>x</title>")

    def log_message(self, *_: object) -> None:
        pass


def test_foreign_page(page: Page, visitors: Visitors) -> None:
    """That of another address gets no connection, in the same browser."""
    visitors.excuse("WebSocket connection to")
    page.shows("link", "open")
    #  with threads: a connection that Chromium opens in advance stays silent
    server = ThreadingHTTPServer(("127.0.0.1", 0), Foreign)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        foreign = visitors.open(f"http://127.0.0.1:{server.server_port}")
        ended = foreign.driver.execute_async_script(
            "const socket = new WebSocket(arguments[0]), done = arguments[1];"
            "socket.onopen = () => done('open'); socket.onclose = () => done('closed')",
            page.address.replace("http", "ws") + "/ws",
        )
    finally:
        server.shutdown()
        server.server_close()
    assert ended == "closed"
    assert page.data("link") == "open"


def test_arena(
    stand: Stand, driver: Page, visitors: Visitors, pictures: Pictures
) -> None:
    """Searched, rejected; searched, confirmed; who watches is not asked."""
    other = visitors.open(stand.address, 1)
    driver.click("arena-search")
    driver.shows("arena", "found")
    other.shows("arena", "found")
    await_(lambda: driver.visible("arena-question"), "the question")
    assert not other.visible("arena-question")
    pictures.take(driver, "web-arena")
    driver.click("arena-reject")
    driver.shows("arena", "none")
    driver.click("arena-search")
    driver.shows("arena", "found")
    driver.click("arena-confirm")
    other.shows("arena", "confirmed")
    other.await_images(5)


def test_french(stand: Stand, visitors: Visitors) -> None:
    """By the browser's language at first, then as chosen, remembered."""
    page = visitors.open(stand.address, languages="fr-FR,fr;q=0.9,en;q=0.5")
    assert page.run("return document.documentElement.lang") == "fr"
    page.start()
    assert page.text("wheel-who") == "Vous conduisez"
    french = set()
    for language in ("fr", "en"):
        page.click_element(
            page.driver.find_element(By.CSS_SELECTOR, f"[data-language={language}]")
        )
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


@pytest.mark.parametrize("dark", [False, True])
def test_axe(stand: Stand, visitors: Visitors, axe: str, dark: bool) -> None:
    page = visitors.open(stand.address, dark=dark)

    def judged(state: str) -> None:
        """The driver may have been taken for gone: axe keeps the page busy."""
        judge(page, axe, state)
        page.take_wheel()

    page.shows("link", "open")
    judged("at first")
    page.start()
    with held(page, "w"):
        stand.moves()
        judged("driving")
    stand.stands()
    page.click("arena-search")
    page.shows("arena", "found")
    judged("arena to be confirmed")
    page.click("arena-reject")
    page.run("document.querySelector('details.more').open = true")
    page.click("order-RSOW")
    judge(page, axe, "the question")
    page.click("unguarded-cancel")
    judged("all orders")
    other = visitors.open(stand.address, 1, languages="fr", size=(360, 740), dark=dark)
    other.shows("wheel", "other")
    other.click("wheel-ask")
    await_(lambda: page.visible("asking"), "the question")
    judge(page, axe, "asked for the wheel")
    judge(other, axe, "watching, in French, on a phone")


def test_axe_login(
    stands: Callable[..., Stand],
    tokens: tuple[str | Path, ...],
    visitors: Visitors,
    axe: str,
) -> None:
    page = visitors.open(stands(*tokens).address)
    judge(page, axe, "the form")


def test_recording(
    stands: Callable[..., Stand],
    visitors: Visitors,
    tmp_path: Path,
    request: pytest.FixtureRequest,
    pictures: Pictures,
) -> None:
    """Recorded, replayed with the slider, exported as CSV."""
    folder = tmp_path / "recordings"
    folder.mkdir()
    stand = stands("--record", folder)
    page = visitors.open(stand.address)
    page.start()
    page.click("move")
    stand.moves()
    stand.stands()
    time.sleep(1)
    (recording,) = [path.name for path in folder.iterdir()]
    row = f"[data-recording='{recording}']"
    page.replay(row)
    page.click("replay-play")
    length = float(page.element("replay-slider").get_attribute("max"))
    assert length > 1000
    shown: list[int] = []
    #  the last second has images in any case
    for moment in (0.0, length - 500, length):
        page.replay_at(moment)
        #  the one at the very beginning, then later and later ones
        await_(
            lambda: (
                int(page.data("index", "replay-picture")) > shown[-1]
                if shown
                else page.data("index", "replay-picture") == "0"
            ),
            f"the picture at {moment} of {length} ms, but {page.text('replay-note')}",
        )
        shown.append(int(page.data("index", "replay-picture")))
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
    stands: Callable[..., Stand], visitors: Visitors, tmp_path: Path, axe: str
) -> None:
    """A name is kept; a deletion is asked for; that being written stays."""
    folder = tmp_path / "recordings"
    old = folder / "20261123T120000.123Z"
    old.mkdir(parents=True)
    (old / "events.jsonl").write_text('{"t":1,"type":"state"}\n', encoding="ascii")
    (old / "images.mjpeg").touch()
    stand = stands("--record", folder)
    page = visitors.open(stand.address)
    page.shows("link", "open")

    def row(selector: str) -> list[WebElement]:
        found: list[WebElement] = page.driver.find_elements(
            By.CSS_SELECTOR, f"[data-recording='{old.name}'] {selector}"
        )
        return found

    page.click_element(await_(lambda: row("[data-do=name]"), "its buttons")[0])
    row("input")[0].send_keys("Première fois", Keys.ENTER)
    await_(lambda: row("strong") and row("strong")[0].text, "the name")
    page.driver.refresh()
    page.shows("link", "open")
    await_(lambda: row("strong"), "the name")
    assert row("strong")[0].text == "Première fois"
    assert (old / "title.txt").read_text(encoding="utf-8") == "Première fois"
    deletes = page.driver.find_elements(By.CSS_SELECTOR, "[data-do=delete]")
    assert len(deletes) == 1, "not of the recording that is being written"
    for button in ("delete-no", "delete-yes"):
        page.click_element(row("[data-do=delete]")[0])
        await_(lambda: page.visible("delete"), "the question")
        assert "Première fois" in page.text("delete")
        judge(page, axe, "the question")
        assert old.exists()
        page.click(button)
    await_(lambda: not row("td"), "it is gone")
    assert not old.exists()


def test_viewers_do_not_delete(
    stands: Callable[..., Stand],
    tokens: tuple[str | Path, ...],
    visitors: Visitors,
    tmp_path: Path,
) -> None:
    """They replay."""
    folder = tmp_path / "recordings"
    folder.mkdir()
    stand = stands("--record", folder, *tokens)
    for number, word in enumerate((VIEWERS, TEACHERS)):
        page = visitors.open(stand.address, number)
        log_in(page, word)
        page.shows("link", "open")
        page.until(
            "return document.querySelector('#recordings-list button')",
            what="the recording",
        )
        names = page.driver.find_elements(By.CSS_SELECTOR, "[data-do=name]")
        assert len(names) == number
