#  SPDX-License-Identifier: GPL-3.0-or-later
"""Driving by keys, pad and amounts; what stops the robot."""

from __future__ import annotations

import math
import os
import re
import signal
import time
from collections.abc import Callable

import pytest
from conftest import Pictures, Visitors
from parties import await_
from selenium.webdriver import ActionChains
from selenium.webdriver.common.keys import Keys
from stand import Page, Stand, held, pixel

SILENCE = 0.5
#  Seconds without a ping after which the gateway stops the robot

NOTICED = 0.5
#  Seconds for all that comes after: gateway, supervisor, serial line (80 ms),
#  on a machine with other work

HUNG = 1.0
#  Seconds without a sign of life after which the guard ends the gateway, and
#  within which the supervisor stops the robot

FREE = 1.0
#  Seconds after which a driver that has vanished has lost the wheel


def test_newcomer(stand: Stand, visitors: Visitors) -> None:
    """Opens the address, presses the one button, drives."""
    begin = time.monotonic()
    page = visitors.open(stand.address)
    page.shows("link", "open")
    assert page.data("robot") == "closed"
    page.start()
    assert page.data("watchdog") == "true"
    assert stand.emulator.status()["watchdog"] == "on"
    with held(page, "w"):
        stand.moves()
        assert time.monotonic() - begin < 30
        assert page.data("held") == "RGFW"
    stand.stands()
    assert page.data("wheel") == "me"
    assert "Forward" in page.logged(label="RGFW", answer="AACK")["text"]
    for tile in ("supervisor", "robot", "watchdog", "camera", "battery", "latency"):
        assert page.text(f"tile-{tile}-text"), tile
    assert page.text("tile-battery-text") == "full"
    #  ten images a second
    before = page.images()
    time.sleep(2)
    assert 15 <= page.images() - before <= 25
    await_(lambda: 8 <= float(page.text("tile-images-text")) <= 12, "ten a second")
    #  the times of orders: as many bars as there were, in the order's words
    plot = page.element("latency-plot")
    label = str(plot.get_attribute("aria-label"))
    said = re.fullmatch(r"The last (\d+) orders: median (\S+) ms, p99 (\S+) ms", label)
    assert said, label
    assert len(page.all("#latency-plot .bar")) == int(said[1]) >= 2
    assert 0 < float(said[2]) <= float(said[3]) < 1000
    assert "full" in str(page.element("battery-plot").get_attribute("aria-label"))


def test_keyboard_alone(stand: Stand, page: Page) -> None:
    """To the one button by Tab, pressed by Enter; then W."""
    page.shows("link", "open")
    for _ in range(30):
        page.press(Keys.TAB)
        if page.run("return document.activeElement.id") == "start":
            break
    else:
        pytest.fail("Tab does not lead to the button")
    page.press(Keys.ENTER)
    page.shows("robot", "started")
    page.shows("positions", "true")
    stand.drives(page)


def test_square(stand: Stand, driver: Page, pictures: Pictures) -> None:
    """Four sides of 20 cm by the keys; the robot is where it was."""
    emulator = stand.emulator
    first = emulator.pose
    before_driving = len(emulator.journal())

    def moved(start: tuple[float, float, float]) -> tuple[float, float]:
        now = emulator.pose
        return math.dist(start[:2], now[:2]), (now[2] - start[2]) % 360

    def hold(key: str, turns: int, enough: float, most: float) -> None:
        start = emulator.pose
        with held(driver, key):
            await_(lambda: moved(start)[turns] > enough, "so far", every=0.005)
            if side == 2 and not turns:
                pictures.take(driver, "web-driving")
        stand.stands()
        assert moved(start)[turns] <= most
        assert turns or emulator.pose[2] == start[2]

    for side in range(4):
        forward, left = [(Keys.ARROW_UP, Keys.ARROW_LEFT), ("w", "a")][side % 2]
        hold(forward, 0, 18, 30)
        hold(left, 1, 85, 110)
    assert moved(first)[0] <= 15
    driving = [n.command for n in emulator.journal()[before_driving:]]
    moves = [text for text in driving if text[:1] in ("M", "T")]
    assert len(moves) == 16, moves


def test_position(stand: Stand, driver: Page) -> None:
    """What the page draws over the picture is where the robot is; in centimetres, with
    its heading, where an arena is confirmed."""
    for x, y, heading in ((25, 20, 0), (55, 40, 90)):
        stand.emulator.ask(f"pose {x} {y} {heading}")
        driver.await_images(3)
        assert driver.data("id", "overlay") == "1"
        shown = [float(driver.data(key, "overlay")) for key in ("x", "y", "angle")]
        shown[2] %= 360
        there = [*pixel((x, y)), 180 - heading]
        assert shown == pytest.approx(there, abs=2)
    stand.emulator.ask("pose 25 20 30")
    assert "px" in driver.text("tile-position-text")
    driver.confirm_arena()
    words = f"{driver.text('tile-position-text')} {driver.text('tile-position-more')}"
    shown = [float(one) for one in re.findall(r"-?\d+(?:\.\d+)?", words)]
    assert shown[:2] == pytest.approx([25, 20], abs=0.5)
    assert shown[2] == pytest.approx(30, abs=2)


def test_amounts(stand: Stand, driver: Page) -> None:
    """100 mm forward and 90 degrees, as the fields have them at first."""
    x, y, heading = stand.emulator.pose
    driver.click("move")
    stand.moves_and_stands()
    assert math.dist((x, y), stand.emulator.pose[:2]) == pytest.approx(10, abs=0.5)
    driver.click("turn")
    stand.moves_and_stands()
    assert stand.emulator.pose[2] - heading == pytest.approx(90, abs=2)


def test_stop_by_key(stand: Stand, driver: Page) -> None:
    """From anywhere on the page, at once, though a driving key is held."""
    driver.open_more()
    for focus in ("", "wheel-release", "move-value", "log-all", "name", "points-value"):
        for key in (Keys.SPACE, Keys.ESCAPE):
            driver.run("document.activeElement.blur()")
            with held(driver, Keys.ARROW_LEFT):
                stand.moves()
                driver.run(
                    "(document.getElementById(arguments[0]) || document.body).focus()",
                    focus,
                )
                driver.press(key)
                stand.stands(within=NOTICED)
                stand.stays(0.2)
            assert driver.data("wheel") == "me", f"{focus} was pressed, too"


def test_stop_while_writing(stand: Stand, other: Page, driver: Page) -> None:
    """In a field for text a blank is written, too; that of who only watches stops
    nothing."""
    for page, key in ((driver, " "), (other, Keys.ESCAPE)):
        driver.write("turn-value", "3600")
        driver.click("turn")
        stand.moves()
        name = page.write("name", "A")
        if page is other:
            name.send_keys(" B")
            time.sleep(0.3)
            assert stand.emulator.moving
        name.send_keys(key)
        stand.stands(within=NOTICED)
        assert name.get_attribute("value") == ("A B" if page is other else "A ")


@pytest.mark.parametrize("how", ["enter", "button"])
def test_arrows_after_an_amount(stand: Stand, driver: Page, how: str) -> None:
    """The arrow keys do not stay with the field."""
    for name, key in (("move", Keys.ARROW_DOWN), ("turn", Keys.ARROW_RIGHT)):
        field = driver.write(f"{name}-value", "10")
        if how == "enter":
            field.send_keys(Keys.ENTER)
        else:
            driver.click(name)
        driver.logged(label={"move": "RMOV", "turn": "RTRN"}[name], answer="AACK")
        stand.stands()
        stand.drives(driver, key)
        assert field.get_attribute("value") == "10"


def test_buttons(stand: Stand, driver: Page) -> None:
    """They stop, and drive while the mouse holds them."""
    for button in ("stop", "pad-stop"):
        with held(driver, "d"):
            stand.moves()
            driver.click(button)
            stand.stands(within=NOTICED)
    turn = driver.element("pad-RGLF")
    ActionChains(driver.driver).click_and_hold(turn).perform()
    stand.moves()
    ActionChains(driver.driver).release().perform()
    stand.stands()


@pytest.mark.parametrize("how", ["minimised", "another tab"])
def test_stop_when_hidden(stand: Stand, driver: Page, how: str) -> None:
    driver.hold("w")
    stand.moves()
    if how == "minimised":
        driver.driver.minimize_window()
    else:
        driver.browser.command("Target.createTarget", url="about:blank")
    stand.stands(within=NOTICED)
    driver.release("w")
    driver.bring_to_front()
    driver.shows("wheel", "free")
    assert driver.logged(code="wheel_released")
    driver.take_wheel()
    stand.drives(driver, "s")


@pytest.fixture
def other(stand: Stand, visitors: Visitors) -> Page:
    """Another browser's page, not by the cable. To be named before the driver's:
    while a browser starts, a page beside it may be late, and lose the wheel."""
    return visitors.open(f"http://127.0.0.1:{stand.gateway.port}", 1)


def test_stop_when_closed(stand: Stand, other: Page, driver: Page) -> None:
    other.shows("wheel", "other")
    driver.hold("w")
    stand.moves()
    driver.close()
    stand.stands(within=NOTICED)
    other.shows("wheel", "free", within=FREE)


def test_stop_when_cut(
    stand: Stand, other: Page, driver: Page, visitors: Visitors
) -> None:
    """Nothing passes any more, and nobody is told."""
    other.shows("wheel", "other")
    driver.hold("w")
    stand.moves()
    begin = time.monotonic()
    stand.cable.cut()
    stand.stands(within=SILENCE + NOTICED)
    stood = time.monotonic() - begin
    other.shows("wheel", "free", within=FREE + NOTICED - stood)
    assert stood > SILENCE - 0.2, "it was not the silence that stopped it"
    driver.shows("link", "slow")
    #  when it is mended nothing drives by itself
    stand.cable.mend()
    driver.shows("link", "open")
    driver.release("w")
    assert not stand.emulator.moving
    assert other.logged(code="stopped_silent")["level"] in ("warning", "error")


@pytest.mark.parametrize(
    ("guard", "number", "within", "status"),
    [
        (False, signal.SIGKILL, NOTICED, 3),
        (True, signal.SIGKILL, NOTICED, -signal.SIGKILL),
        (False, signal.SIGSTOP, HUNG + NOTICED, 3),
    ],
    ids=["killed", "guard killed", "hung"],
)
def test_stop_without_gateway(
    stand: Stand,
    driver: Page,
    visitors: Visitors,
    guard: bool,
    number: signal.Signals,
    within: float,
    status: int,
) -> None:
    """It dies, or the program that guards it, or it hangs and is ended by its
    guard; another one is found by the page."""
    visitors.excuse("WebSocket connection to|ERR_(CONNECTION|SOCKET|EMPTY)")
    driver.hold("w")
    stand.moves()
    gateway = stand.gateway
    os.kill(gateway.process.pid if guard else gateway.server, number)
    stand.stands(within)
    driver.shows("link", "lost")
    driver.release("w")
    assert gateway.process.wait(5) == status
    stand.gateway = stand.new_gateway()
    driver.shows("link", "open")
    driver.start()
    stand.drives(driver, "s")


def connected(page: Page) -> int:
    """How often to the supervisor."""
    return sum(line["code"] == "supervisor_connected" for line in page.log())


def test_supervisor_gone(stand: Stand, driver: Page) -> None:
    """The supervisor is ended and comes back: said, and found again."""
    assert connected(driver) == 1
    driver.hold("w")
    stand.moves()
    stand.supervisor.end()
    stand.stands(within=3)
    driver.logged(code="supervisor_lost")
    driver.release("w")
    stand.supervisor = stand.new_supervisor()
    await_(lambda: connected(driver) == 2, "it is connected again")
    driver.shows("robot", "closed")
    driver.start()
    stand.drives(driver)


def test_refusal_in_words(stands: Callable[..., Stand], visitors: Visitors) -> None:
    """The serial line is gone: the page says why and what to do."""
    stand = stands(line="link")
    page = visitors.open(stand.address)
    stand.emulator.ask("hangup")
    page.shows("link", "open")
    page.click("start")
    line = page.logged(label="ROPN", answer="ANAK")
    assert "serial line" in line["text"]


def test_without_watchdog_asks(stand: Stand, page: Page) -> None:
    page.take_wheel()
    page.order("ROPN")
    page.shows("robot", "open")
    for button in ("unguarded-cancel", "unguarded-yes"):
        page.order("RSOW")
        page.click(button)
        assert not page.visible("unguarded")
    page.shows("robot", "started")
    assert page.data("watchdog") == "false"
    assert stand.emulator.status()["watchdog"] == "off"
    stand.drives(page)


def test_reload(stand: Stand, driver: Page) -> None:
    """The robot stands; the page comes back to all that was, also while the arena is
    searched, and while it is to be confirmed."""
    driver.hold("w")
    stand.moves()
    begin = time.monotonic()
    driver.driver.refresh()
    stand.stands(within=max(0.1, NOTICED + SILENCE - (time.monotonic() - begin)))
    driver.release("w")
    driver.shows("link", "open")
    driver.shows("robot", "started")
    driver.shows("positions", "true")
    driver.await_images(1)
    driver.shows("wheel", "me")
    assert not stand.emulator.moving
    stand.drives(driver, "s")
    assert driver.logged(label="RGFW", answer="AACK")
    driver.click("arena-search")
    driver.driver.refresh()
    driver.shows("link", "open")
    driver.shows("arena", "found")
    driver.shows("wheel", "me")
    driver.driver.refresh()
    driver.shows("wheel", "me")
    driver.click("arena-confirm")
    driver.shows("arena", "confirmed")
    driver.await_images(3)


def test_a_hundred_reconnects(stand: Stand, driver: Page, visitors: Visitors) -> None:
    """Nothing is left of them, and the driver drives."""
    #  Chromium tells of a socket that was closed without a farewell
    visitors.excuse("WebSocket connection to")
    files = f"/proc/{stand.gateway.server}/fd"
    first = len(os.listdir(files))
    driver.run(
        "window.seen = new MutationObserver(() => {"
        "if (document.documentElement.dataset.link === 'lost') {"
        " window.lost = true; dispatchEvent(new Event('online')); }});"
        "window.seen.observe(document.documentElement, {attributes: true})"
    )
    for _ in range(100):
        driver.run("window.lost = false")
        stand.cable.tear()
        await_(lambda: driver.run("return window.lost"), "it was lost")
        driver.shows("link", "open")
    driver.shows("wheel", "me")
    await_(lambda: len(os.listdir(files)) <= first, "its files are closed")
    assert len(driver.all("#viewers > li")) == 1
    stand.drives(driver)
    driver.await_images(5)


def test_phone(stand: Stand, visitors: Visitors, pictures: Pictures) -> None:
    """360 px wide: nothing beyond the edge; the pad works by touch."""
    page = visitors.open(stand.address, size=(360, 740), touch=True)
    page.start()
    wide = page.run("return document.documentElement.scrollWidth")
    assert wide <= 360
    await_(lambda: not page.visible("start-steps"), "its steps are away")
    pictures.take(page, "web-phone")
    right, _ = page.middle("pad-RGRI")
    x, y = page.middle("pad-RGFW")
    page.touch("touchStart", x, y)
    stand.moves()
    page.touch("touchEnd")
    stand.stands()
    #  it slides on the pad as on a stick, and beyond it
    stand.emulator.ask("clear")
    page.touch("touchStart", x, y)
    page.touch("touchMove", right, y)
    page.shows("held", "RGFW RGRI")
    await_(
        lambda: (
            {"M=32767", "T=-32768"} <= {n.command for n in stand.emulator.journal()}
        ),
        "forward and to the right",
    )
    page.touch("touchMove", x, y - 150)
    page.shows("held", "RGFW")
    stand.moves()
    time.sleep(0.3)
    assert stand.emulator.moving
    page.touch("touchEnd")
    stand.stands()
    #  and one that the system takes for a gesture of its own holds nothing
    page.touch("touchStart", x, y)
    stand.moves()
    page.touch("touchCancel")
    stand.stands()


def test_projector(stand: Stand, visitors: Visitors) -> None:
    """1920 by 1080: all that one watches is seen at once, in larger letters."""
    page = visitors.open(stand.address, size=(1920, 1080))
    page.start()
    for name in ("stop", "picture", "pad", "tiles", "people", "log-section"):
        r = page.rectangle(name)
        assert 0 <= r["left"] < r["right"] <= 1920, name
        assert 0 <= r["top"] < r["bottom"] <= 1080, name
    letters = page.run("return getComputedStyle(document.documentElement).fontSize")
    assert float(letters.removesuffix("px")) >= 19


def test_projector_view(stand: Stand, driver: Page, visitors: Visitors) -> None:
    """The picture and the state, nothing to press but Stop and the way back; what is
    wrong is still said."""
    page = visitors.open(stand.address + "/#projector", 1, size=(1280, 900))
    page.shows("wheel", "other")
    page.await_images(1)

    def buttons() -> set[str]:
        return set(
            page.run(
                "return [...document.querySelectorAll('button, input, select, a')]"
                ".filter(e => e.checkVisibility() && !e.classList.contains('skip'))"
                ".map(e => e.id)"
            )
        )

    assert buttons() == {"stop", "projector"}
    picture = page.rectangle("picture")
    assert picture["width"] > 1200 and picture["height"] > 600, "it is large"
    assert page.visible("tiles")
    stand.emulator.ask("battery 0")
    await_(lambda: "charger" in page.text("alarms"), "what is wrong")
    page.click("projector")
    assert {"start", "path"} < buttons()
    page.click("projector")
    assert page.run("return location.hash") == "#projector"
    with held(driver, "d"):
        stand.moves()
        page.click("stop")
        stand.stands(within=NOTICED)


def test_gamepad(stand: Stand, driver: Page) -> None:
    """Its stick and its cross drive while they are held, its buttons stop. The
    browser has none here: what it would say of one is given to the page."""

    def hold(axes: tuple[float, float] = (0, 0), button: int = -1) -> None:
        driver.run(
            "window.pads = [{axes: arguments[0], buttons: Array.from({length: 17},"
            "(_, n) => ({pressed: n === arguments[1]}))}]",
            *(axes, button),
        )

    hold()
    driver.run(
        "navigator.getGamepads = () => window.pads;"
        "dispatchEvent(new Event('gamepadconnected'))"
    )
    for axes, button, order in (
        ((0.1, -0.9), -1, "RGFW"),
        ((-0.9, 0.3), -1, "RGLF"),
        ((-0.6, 0.6), -1, "RGBW RGLF"),
        ((0, 0), 13, "RGBW"),
        ((0, 0), 15, "RGRI"),
    ):
        hold(axes, button)
        stand.moves()
        driver.shows("held", order)
        hold((0.2, 0.2))
        stand.stands()
    #  a stop holds, though the stick does, too
    hold((0, -1))
    stand.moves()
    hold((0, -1), 0)
    stand.stands(within=NOTICED)
    hold((0, -1))
    stand.stays()
    hold()
    time.sleep(0.1)
    hold((0, -1))
    stand.moves()
    #  one that is pulled out holds nothing
    driver.run("window.pads = [null]")
    stand.stands()


def test_frozen_gateway(stand: Stand, driver: Page) -> None:
    """It and its guard, as by a container's pause: nobody ends it. When it goes on,
    so does its user."""
    frozen = (stand.gateway.process.pid, stand.gateway.server)
    driver.hold("w")
    stand.moves()
    for process in frozen:
        os.kill(process, signal.SIGSTOP)
    stand.stands()
    stand.supervisor.line("monitor lost: its program has been silent")
    driver.release("w")
    for process in frozen:
        os.kill(process, signal.SIGCONT)
    driver.logged(code="supervisor_lost")
    await_(lambda: connected(driver) == 2, "it is connected again")
    assert not stand.emulator.moving
    driver.take_wheel()
    driver.start()
    stand.drives(driver, "s")
