#  SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong is shown as long as it is, with what to do."""

from __future__ import annotations

import re

import pytest
from conftest import Visitors
from parties import await_
from selenium.webdriver.common.keys import Keys
from stand import Page, Stand
from test_missions import under_way
from test_page import judge


def alarmed(page: Page, name: str, words: str) -> None:
    await_(
        lambda: re.search(words, alarms(page).get(name, "")),
        f"{name}: {words}, but {alarms(page)}",
    )


def alarms(page: Page) -> dict[str, str]:
    return dict(
        page.run(
            "return [...document.querySelectorAll('#alarms > [data-alarm]')]"
            ".map(e => [e.dataset.alarm, e.innerText])"
        )
    )


def calm(page: Page) -> None:
    await_(lambda: not alarms(page), "no alarm")
    assert not page.visible("alarms")


@pytest.mark.parametrize(
    ("language", "words"), [("en", "Switch the robot on"), ("fr", "Allumez le robot")]
)
def test_switched_off(
    stand: Stand, visitors: Visitors, language: str, words: str
) -> None:
    """By an order; and again when Start finds that it is."""
    page = visitors.open(stand.address, languages=language)
    other = visitors.open(stand.address, 1, languages=language)
    page.start()
    page.order("RPOF")
    for one in (page, other):
        alarmed(one, "robot_off", words)
        one.shows("robot", "off")
    page.click("start")
    failed = page.one("#start-steps [data-step=watchdog][data-result=failed]")
    assert words in failed.text
    page.shows("robot", "off")
    stand.emulator.ask("reset-robot")
    page.close_start()
    page.click("start")
    page.shows("robot", "started")
    for one in (page, other):
        calm(one)


def test_it_has_switched_itself_off(stand: Stand, page: Page) -> None:
    """As after two minutes without an order: its line opens, it does not answer."""
    stand.emulator.ask("silent on")
    page.shows("link", "open")
    page.click("start")
    alarmed(page, "robot_off", "Switch the robot on")
    stand.emulator.ask("silent off")
    page.order("RPIN")
    calm(page)
    page.shows("robot", "open")


def test_lost(stand: Stand, driver: Page) -> None:
    """Also for a page that comes later."""
    stand.emulator.ask("silent on")
    driver.shows("robot", "lost")
    assert "switched on" in driver.logged(code="robot_lost")["text"]
    alarmed(driver, "robot_lost", "press Start")
    driver.driver.refresh()
    alarmed(driver, "robot_lost", "press Start")
    stand.emulator.ask("silent off")
    driver.start()
    calm(driver)
    assert "lost" not in driver.text("alert")


def test_battery(stand: Stand, driver: Page) -> None:
    for level, words in (("1", "low.*Charge"), ("0", "empty.*charger")):
        stand.emulator.ask(f"battery {level}")
        alarmed(driver, f"battery_{level}", words)
        assert len(alarms(driver)) == 1
    stand.emulator.ask("battery 2")
    calm(driver)


@pytest.mark.parametrize(
    ("language", "words"), [("en", "plugged in"), ("fr", "branchée")]
)
def test_camera(
    stand: Stand, visitors: Visitors, axe: str, language: str, words: str
) -> None:
    """In the page's language, until it is open again."""
    page = visitors.open(stand.address, languages=language)
    page.start()
    stand.emulator.ask("camera stall")
    alarmed(page, "camera", words)
    assert words in page.logged(code="camera_failed")["text"]
    judge(page, axe, "an alarm")
    stand.emulator.ask("camera mend")
    page.take_wheel()
    page.order("COPN")
    page.shows("camera", "true")
    calm(page)


def test_robot_runs_no_more(stand: Stand, driver: Page) -> None:
    """Its watchdog has expired: what to do is said in the page's words."""
    stand.emulator.ask("starve")
    driver.hold("w")
    driver.shows("robot", "open")
    driver.release("w")
    assert "Reset" in driver.logged(code="robot_not_running")["text"]


@pytest.mark.parametrize("how", ["hand", "wall"])
def test_mission_ended(
    stand: Stand, driver: Page, visitors: Visitors, how: str
) -> None:
    """Until another begins, or the robot is driven."""
    other = visitors.open(stand.address, 1, languages="fr")
    other.shows("wheel", "other")
    driver.confirm_arena()
    for mend in ("click", "key"):
        under_way(stand, driver)
        for page in (driver, other):
            calm(page)
        if how == "hand":
            driver.press(Keys.ESCAPE)
            alarmed(driver, "mission", "by hand.*Show in the picture")
            alarmed(other, "mission", "à la main.*Montrez dans")
        else:
            #  it does not come on
            await_(
                lambda: stand.emulator.ask("pose 25 20 0") and alarms(driver),
                "it is given up",
            )
            alarmed(driver, "mission", "Free its way")
            alarmed(other, "mission", "Dégagez son chemin")
            stand.stands()
        if mend == "click":
            driver.click_at((320, 240))
        else:
            stand.drives(driver)
        for page in (driver, other):
            calm(page)
        driver.press(Keys.ESCAPE)
        stand.stands()


def test_robot_that_turns_too_little(
    stand: Stand, driver: Page, visitors: Visitors
) -> None:
    """What was measured is said in the page's language."""
    other = visitors.open(stand.address, 1, languages="fr")
    other.shows("wheel", "other")
    driver.confirm_arena()
    stand.emulator.ask("turn-speed 10")
    driver.click_at((250, 350))
    alarmed(driver, "mission", r"turns (9|1\d) % of what is asked")
    alarmed(other, "mission", r"tourne de (9|1\d) % de ce qui")
