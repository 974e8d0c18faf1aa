#  SPDX-License-Identifier: GPL-3.0-or-later
"""Missions: the robot goes where the picture is clicked, or along a path drawn
over it, and stops for everybody."""

from __future__ import annotations

import contextlib
import itertools
import math
import re
import threading
import time
from collections.abc import Iterator

import pytest
from conftest import Pictures, Visitors
from parties import await_
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.remote.webelement import WebElement
from stand import Page, Point, Stand, held, pixel
from test_page import judge

NOTICED = 0.5
#  Seconds until a stop is with the robot


@pytest.fixture
def pilot(driver: Page) -> Page:
    """A driver who may send the robot on missions."""
    driver.confirm_arena()
    return driver


def is_over(page: Page) -> None:
    await_(lambda: not page.visible("mission"), "the mission is over")


@contextlib.contextmanager
def passes(stand: Stand, places: list[Point]) -> Iterator[list[Point]]:
    """Those of the places, in their order, that the robot has not passed yet."""
    left = list(places)
    ended = threading.Event()

    def watch() -> None:
        while left and not ended.wait(0.02):
            if stand.is_near(left[0]):
                left.pop(0)

    thread = threading.Thread(target=watch, daemon=True)
    thread.start()
    try:
        yield left
    finally:
        ended.set()
        thread.join()


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("en", ("Search the arena", "outline", "Click in the picture", "Follow")),
        ("fr", ("Chercher l", "contour", "Cliquez dans", "Suivre")),
    ],
)
def test_way_to_the_first_mission(
    stand: Stand, visitors: Visitors, language: str, words: tuple[str, ...]
) -> None:
    """The page says the next step, to who drives."""
    page = visitors.open(stand.address, languages=language)
    other = visitors.open(stand.address, 1, languages=language)

    def says(step: int) -> None:
        await_(lambda: words[step] in page.text("next"), f"step {step}")
        assert not other.visible("next")

    assert not page.visible("next")
    page.start()
    says(0)
    page.close_start()
    page.click("arena-search")
    says(1)
    page.click("arena-confirm")
    says(2)
    page.click("path")
    says(3)
    page.click("path")
    page.await_images(3)
    page.click_at((400, 240))
    page.plan()
    await_(lambda: not page.visible("next"), "it is under way")


@pytest.mark.parametrize("size", [(1280, 900), (1920, 1080), (700, 500)])
def test_click(stand: Stand, visitors: Visitors, size: tuple[int, int]) -> None:
    """The robot goes there, however large the picture is."""
    page = visitors.open(stand.address, size=size)
    page.start()
    page.confirm_arena()
    place = (55, 40)
    page.click_at(pixel(place))
    (sent,) = page.plan()
    assert math.dist(sent, pixel(place)) < 1 / page.scale() + 0.2, sent
    stand.moves()
    said = await_(
        lambda: re.search(r"Point 1 of 1: (\d+) cm left", page.text("mission-text")),
        "how far it is",
    )
    assert 0 < int(said[1]) < 40
    stand.arrives(page, place)
    assert "under way" in page.logged(label="MGTO", answer="AACK")["text"]


def test_path_by_clicks(
    stand: Stand, pilot: Page, watcher: Page, pictures: Pictures
) -> None:
    """Four points in their order; who watches sees them, too."""
    places = [(60.0, 20.0), (60.0, 42.0), (25.0, 42.0), (42.0, 30.0)]
    film = pictures.film(pilot, "web-path")
    pilot.click("path")
    for point in (*map(pixel, places), (320.0, 240.0)):
        film.take()
        pilot.click_at(point)
    assert len(pilot.points("path")) == 5
    film.take()
    pilot.click("path-undo")
    drawn = pilot.points("path")
    assert len(drawn) == 4
    assert not stand.emulator.moving, "nothing is sent yet"
    film.take()
    pilot.click("path-go")
    assert pilot.plan() == watcher.plan() == drawn
    assert not pilot.visible("path-tools")
    with passes(stand, places) as left:
        for leg in "1234":
            film.take_until(lambda at: pilot.data("leg", "mission") == at, leg)
            pilot.shows("leg", leg, element="mission")
            if leg == "3":
                stand.moves()
                time.sleep(1)
                pictures.take(pilot, "web-mission")
        film.take_until(lambda: not pilot.visible("mission"))
        stand.arrives(pilot, places[-1])
    assert left == [], "it passes each of them"
    is_over(watcher)


def test_path_by_dragging(stand: Stand, pilot: Page) -> None:
    """A line drawn over the picture is few points; the robot goes to its end."""
    places = [(25.0, 20.0), (45.0, 20.0), (45.0, 40.0)]
    there = [*map(pixel, places)]
    chain = pilot.pointer(there[0]).click_and_hold()
    before = pilot.offset(there[0])
    for begin, end in itertools.pairwise(there):
        for step in range(1, 11):
            x, y = (a + (b - a) * step / 10 for a, b in zip(begin, end, strict=True))
            to = pilot.offset((x, y))
            chain.move_by_offset(to[0] - before[0], to[1] - before[1])
            before = to
    chain.release().perform()
    drawn = pilot.points("path")
    assert 3 <= len(drawn) <= 6
    for want in there:
        assert min(math.dist(want, point) for point in drawn) < 4, (there, drawn)
    stand.stays()  # nothing is sent yet
    pilot.click("path-go")
    assert pilot.plan() == drawn
    stand.arrives(pilot, places[-1])


def test_undo_by_stroke(stand: Stand, pilot: Page) -> None:
    """A drag is undone as a whole, a click as the one point that it is."""
    pilot.click("path")

    def drawn() -> list[Point]:
        return pilot.points("path")

    pilot.click_at((200, 150))
    first = drawn()
    chain = pilot.pointer((240, 160)).click_and_hold()
    for way in (60, 0), (0, 60), (-60, 0):
        for _ in range(5):
            chain.move_by_offset(way[0] // 5, way[1] // 5)
    chain.release().perform()
    with_drag = drawn()
    assert len(with_drag) >= 4
    pilot.click_at((400, 300))
    assert len(drawn()) == len(with_drag) + 1
    for left in (with_drag, first, [], []):
        pilot.click("path-undo")
        assert drawn() == left


def test_a_wild_line_is_64_points(stand: Stand, pilot: Page) -> None:
    """As many as the supervisor takes, and no more can be added."""
    chain = pilot.pointer((200, 150)).click_and_hold()
    for step in range(150):
        chain.move_by_offset(*[(8, 20), (0, -20), (-8, 20), (0, -20)][step % 4])
    chain.release().perform()
    drawn = len(pilot.points("path"))
    assert 2 <= drawn <= 64
    for _ in range(66 - drawn):
        pilot.click_at((300, 200))
    assert len(pilot.points("path")) == 64
    await_(lambda: "64" in pilot.text("alert"), "why not")
    pilot.click("path-clear")
    assert pilot.data("path", "overlay") == ""
    pilot.click("path-go")
    await_(lambda: "Click points" in pilot.text("alert"), "what to do")


def test_centimetres_by_keyboard(stand: Stand, pilot: Page) -> None:
    """Without pointing: the points are typed."""
    field = typed(pilot, "40 30; 55")
    await_(lambda: "two numbers" in pilot.text("alert"), "what is wrong")
    assert field.get_attribute("aria-invalid") == "true"
    field.send_keys(" 35,5", Keys.ENTER)
    pilot.shows("leg", "2", element="mission")
    assert stand.is_near((40, 30))
    stand.arrives(pilot, (55, 35.5))


@pytest.mark.parametrize(
    ("language", "said"), [("en", "in two ways"), ("fr", "de deux façons")]
)
def test_ambiguous_points(
    stand: Stand, visitors: Visitors, language: str, said: str
) -> None:
    """A comma within a number, or between two? Not guessed: an example is shown."""
    page = visitors.open(stand.address, languages=language)
    page.start()
    page.confirm_arena()
    for text in ("20,30 60,30", "20,30 60,30; 40 30", "20,5 30 60,5 40"):
        field = typed(page, text)
        await_(lambda: said in page.text("alert"), "what is wrong")
        assert "20.5 30" in page.text("alert"), "an example"
        assert field.get_attribute("aria-invalid") == "true"
        page.run("document.getElementById('alert').textContent = ''")
    #  one reading alone
    typed(page, "20,30; 60,30")
    await_(lambda: "20,30" in page.text("alert"), "what is wrong")
    assert not any(line.get("label") in ("MGCM", "MPCM") for line in page.log())
    assert not stand.emulator.moving
    assert not page.visible("mission")


def test_points_are_shown_before_they_are_sent(stand: Stand, pilot: Page) -> None:
    """As they were read, and the first that is wrong."""
    pilot.open_more()

    def read() -> list[str]:
        return pilot.text("points-list").splitlines()

    field = pilot.element("points-value")
    field.send_keys("40 30; 55 35,5")
    assert read() == [
        "40 cm to the right, 30 cm up",
        "55 cm to the right, 35.5 cm up",
    ]
    field.send_keys("; 60; 40 30")
    assert len(read()) == 3 and "“60”" in read()[2]
    assert not any(line.get("label") == "MPCM" for line in pilot.log())
    field.send_keys(Keys.ENTER)
    await_(lambda: "“60”" in pilot.text("alert"), "which is wrong")
    (bad,) = pilot.all("#points-list .bad")
    good = pilot.one("#points-list li:not(.bad)")
    colour = "color"
    assert bad.value_of_css_property(colour) != good.value_of_css_property(colour)
    assert not stand.emulator.moving


def typed(page: Page, text: str) -> WebElement:
    page.open_more()
    return page.write("points-value", text, Keys.ENTER)


def test_typed_mission_is_drawn_for_everybody(pilot: Page, watcher: Page) -> None:
    """In the picture, and where points may be."""
    typed(pilot, "60 20; 60 40")
    for page in (pilot, watcher):
        assert page.plan() == [pytest.approx(pixel((60, y)), abs=2) for y in (20, 40)]
        assert page.points("permitted") == [
            pytest.approx(pixel(corner), abs=2)
            for corner in ((8, 8), (72, 8), (72, 52), (8, 52))
        ]


def under_way(stand: Stand, page: Page) -> None:
    """A mission of ten seconds and more."""
    typed(page, "60 20; 60 40; 20 40; 20 20")
    await_(lambda: page.visible("mission"), "a mission")
    stand.moves()


@pytest.mark.parametrize(
    "how", ["space", "stop", "end", "other", "wheel", "reload", "close"]
)
def test_stopped(stand: Stand, pilot: Page, watcher: Page, how: str) -> None:
    """By key, by buttons, by who only watches, with the wheel that is given back, with
    the page, also one that comes anew."""
    under_way(stand, pilot)
    button = {"stop": "stop", "wheel": "wheel-release"}.get(how, "mission-end")
    page = watcher if how == "other" else pilot
    match how:
        case "space":
            page.press(" ")
        case "reload":
            page.driver.refresh()
        case "close":
            page.close()
        case _:
            page.click(button)
    stand.stands(within=1.0 if how == "reload" else NOTICED)
    for page in (watcher,) if how == "close" else (pilot, watcher):
        assert "by hand" in page.logged(code="mission_aborted")["text"]
        is_over(page)
    stand.stays(1)


def test_driven_by_hand(stand: Stand, pilot: Page) -> None:
    """The driver's key counts at once; then the robot does what the key says."""
    under_way(stand, pilot)
    pilot.hold("a")
    pilot.logged(code="mission_aborted")
    before = stand.emulator.pose
    time.sleep(0.5)
    after = stand.emulator.pose
    assert stand.emulator.moving
    assert math.dist(before[:2], after[:2]) < 0.2 and before[2] != after[2]
    pilot.release("a")
    stand.stands(within=NOTICED)


def test_refused(stand: Stand, driver: Page) -> None:
    """What is missing is said in words, with what to do."""
    driver.close_start()
    driver.click_at((320, 240))
    line = driver.logged(code="mission_refused")
    assert "arena is not confirmed" in line["text"]
    await_(lambda: "not confirmed" in driver.text("alert"), "it is said")
    driver.confirm_arena()
    driver.click_at((3, 3))
    await_(lambda: "too near" in driver.text("alert"), "it is said")
    (bad,) = await_(lambda: driver.points("bad"), "a mark where it was")
    assert math.dist(bad, (3, 3)) < 3
    assert driver.data("plan", "overlay") == ""
    #  until the next one
    driver.click_at((400, 240))
    assert len(driver.plan()) == 1
    assert driver.data("bad", "overlay") == ""
    driver.press(Keys.ESCAPE)
    stand.stands(within=NOTICED)
    driver.order("CPST")
    driver.shows("positions", "false")
    driver.click_at((320, 240))
    await_(lambda: "positions are off" in driver.text("alert"), "it is said")
    assert not driver.visible("mission")
    assert not stand.emulator.moving


@pytest.mark.parametrize("clicks", [1, 3])
def test_new_target(stand: Stand, pilot: Page, clicks: int) -> None:
    """A mission during another takes its place; the last of several clicks counts."""
    places = [(45.0, 40.0), (30.0, 30.0), (55.0, 25.0)][-clicks:]
    under_way(stand, pilot)
    typed(pilot, "40 30")
    await_(lambda: "of 1" in pilot.text("mission-text"), "typed, it counts, too")
    for place in places:
        pilot.click_at(pixel(place))
    (last,) = pilot.points("plan")
    assert math.dist(last, pixel(places[-1])) < 3, "the sign is there at once"
    pilot.logged(code="mission_aborted")
    stand.arrives(pilot, places[-1])


def test_stray_click(stand: Stand, pilot: Page) -> None:
    """Escape withdraws the target at once, also the one that is yet to begin."""
    pilot.click_at((400, 240))
    assert pilot.data("plan", "overlay"), "a sign where it goes"
    stand.moves()
    pilot.press(Keys.ESCAPE)
    stand.stands(within=NOTICED)
    is_over(pilot)
    assert pilot.data("plan", "overlay") == ""
    under_way(stand, pilot)
    pilot.click_at((400, 240))
    pilot.press(Keys.ESCAPE)
    stand.stands(within=NOTICED)
    stand.stays(1)
    assert not pilot.visible("mission")
    assert pilot.data("plan", "overlay") == ""


def test_stop_by_another_withdraws_a_target(
    stand: Stand, pilot: Page, watcher: Page
) -> None:
    """That which waits for the end of the mission before it does not begin."""
    under_way(stand, pilot)
    pilot.run(
        "const send = WebSocket.prototype.send;"
        "WebSocket.prototype.send = function (text) {"
        "if (text.includes('MABT')) window.held = () => send.call(this, text);"
        "else send.call(this, text); }"
    )
    pilot.click_at((400, 240))
    await_(lambda: pilot.run("return !!window.held"), "it ends the first")
    watcher.press(" ")
    stand.stands(within=NOTICED)
    pilot.logged(code="stopped_by")
    await_(lambda: pilot.data("plan", "overlay") == "", "nothing is drawn")
    pilot.run("window.held()")
    pilot.logged(label="MABT")
    stand.stays(1)
    assert not any(line.get("label") == "MGTO" for line in pilot.log())


@pytest.mark.parametrize("name", ["turn-value", "name"])
def test_click_that_leaves_a_field(stand: Stand, pilot: Page, name: str) -> None:
    """It does not drive; the next one does. In path mode it adds no point."""
    pilot.element(name).click()
    pilot.click_at((400, 240))
    await_(lambda: "Click again" in pilot.text("news"), "it is said")
    assert pilot.run("return document.activeElement === document.body")
    stand.stays()
    assert not any(line.get("label") == "MGTO" for line in pilot.log())
    pilot.click("path")
    pilot.element(name).click()
    for drawn in (0, 1):
        pilot.click_at((400, 240))
        assert len(pilot.points("path")) == drawn
    pilot.click("path")
    pilot.click_at((400, 240))
    assert len(pilot.plan()) == 1
    stand.moves()


def test_who_watches_sends_nothing(pilot: Page, watcher: Page) -> None:
    watcher.await_images(1)
    watcher.click_at((320, 240))
    await_(lambda: "Ask for the wheel" in watcher.text("news"), "why not")
    watcher.click("path")
    assert not watcher.visible("path-tools")
    time.sleep(0.3)
    assert not pilot.visible("mission")


def test_phone(stand: Stand, visitors: Visitors) -> None:
    """A finger goes where it taps; in path mode it draws and does not scroll."""
    page = visitors.open(stand.address, size=(360, 740), touch=True)
    page.start()
    page.confirm_arena()
    place = (50.0, 35.0)

    def finger(point: Point) -> Point:
        x, y = page.middle("picture")
        dx, dy = page.offset(point)
        return x + dx, y + dy

    page.touch("touchStart", *finger(pixel(place)))
    page.touch("touchEnd")
    assert len(page.plan()) == 1
    stand.arrives(page, place)
    page.click("path")
    wide = page.run("return document.documentElement.scrollWidth")
    assert wide <= 360
    page.touch("touchStart", *finger((200, 100)))
    for down in range(110, 210, 10):
        page.touch("touchMove", *finger((200, down)))
    page.touch("touchEnd")
    assert 2 <= len(page.points("path")) <= 3
    assert page.run("return scrollY") == 0


@pytest.mark.parametrize("dark", [False, True])
def test_axe(stand: Stand, visitors: Visitors, axe: str, dark: bool) -> None:
    """Each state of the page, up to a mission."""
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
    page.confirm_arena()
    page.order("RSOW")
    judge(page, axe, "the question")
    page.click("unguarded-cancel")
    judged("all orders")
    other = visitors.open(stand.address, 1, languages="fr", size=(360, 740), dark=dark)
    other.shows("wheel", "other")
    other.click("wheel-ask")
    await_(lambda: page.visible("asking"), "the question")
    judge(page, axe, "asked for the wheel")
    judge(other, axe, "watching, in French, on a phone")
    page.take_wheel()
    page.click("path")
    page.click_at((320, 240))
    judged("a path")
    under_way(stand, page)
    await_(lambda: other.visible("mission"), "a mission")
    judge(other, axe, "a mission, in French, on a phone")
