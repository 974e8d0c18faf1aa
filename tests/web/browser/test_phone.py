#  SPDX-License-Identifier: GPL-3.0-or-later
"""On a phone: all can be reached and touched, nothing covers the picture."""

from __future__ import annotations

import re

import pytest
from conftest import Visitors
from parties import await_
from stand import Page, Stand

WIDTH = 390

FINGER = 44
#  CSS pixels

KEYS = re.compile(
    r"arrow key|W A S D|\bclick|\bspace\b|\bEsc|\bclics?\b|Z Q S D|espace|Échap|clique",
    re.IGNORECASE,
)


def judge_screen(page: Page, state: str) -> None:
    small = page.run(
        "return [...document.querySelectorAll('button, a, input, select, summary')]"
        ".filter(e => e.checkVisibility()).map(e => [e.id || e.textContent,"
        "e.getBoundingClientRect().width, e.getBoundingClientRect().height])"
        ".filter(([, wide, high]) => Math.min(wide, high) < arguments[0])",
        FINGER,
    )
    assert not small, f"{state}: too small for a finger: {small}"
    covering = page.run(
        "const p = document.getElementById('picture');"
        "if (p.hidden) return [];"
        "const r = p.getBoundingClientRect();"
        "return [...p.parentElement.children].filter(e => {"
        "  const o = e.getBoundingClientRect();"
        "  return e.tagName !== 'CANVAS' && e.checkVisibility()"
        "    && o.width * o.height > 0 && o.left < r.right && o.right > r.left"
        "    && o.top < r.bottom && o.bottom > r.top; }).map(e => e.id || e.className)"
    )
    assert not covering, f"{state}: over the picture: {covering}"
    beyond = page.run(
        "return [...document.querySelectorAll('button, a:not(.skip), input, select')]"
        ".filter(e => e.checkVisibility()).map(e => [e.id || e.textContent,"
        "e.getBoundingClientRect().left, e.getBoundingClientRect().right])"
        ".filter(([, left, right]) => left < 0 || right > arguments[0])",
        page.run("return document.documentElement.clientWidth"),
    )
    assert not beyond, f"{state}: beyond the edge: {beyond}"
    found = KEYS.search(page.run("return document.body.innerText"))
    assert not found, f"{state}: of a keyboard or mouse: {found}"


@pytest.mark.parametrize(
    ("language", "size"),
    [("en", (WIDTH, 844)), ("fr", (WIDTH, 844)), ("fr", (844, WIDTH))],
)
def test_phone(
    recorder: Stand, visitors: Visitors, language: str, size: tuple[int, int]
) -> None:
    """Each state of a session, up to the replay of its recording."""
    address = recorder.address
    page = visitors.open(address, languages=language, size=size, touch=True)
    page.shows("link", "open")
    judge_screen(page, "at first")
    page.start()
    judge_screen(page, "the steps")
    page.close_start()
    page.click("arena-search")
    await_(lambda: page.visible("arena-question"), "the question")
    judge_screen(page, "the question")
    page.click("arena-reject")
    page.shows("arena", "none")
    page.confirm_arena()
    page.click("path")
    judge_screen(page, "a path")
    page.click("path-go")
    await_(lambda: page.text("alert"), "why not")
    judge_screen(page, "an empty path")
    page.click("path")
    other = visitors.open(address, 1, size=size, touch=True)
    other.shows("wheel", "other")
    other.click("wheel-ask")
    await_(lambda: page.visible("asking"), "the question")
    page.open_more()
    judge_screen(page, "all orders, and one who asks")
    page.replay()
    judge_screen(page, "the replay")
    page.click("replay-play")
    page.click("replay-close")


def test_finger_on_a_large_screen(stand: Stand, visitors: Visitors) -> None:
    """A tablet: its targets are as large."""
    page = visitors.open(stand.address, size=(1280, 900), touch=True)
    page.start()
    page.close_start()
    small = page.run(
        "return [...document.querySelectorAll('button')].filter(e =>"
        "e.checkVisibility() && e.getBoundingClientRect().height < arguments[0])"
        ".map(e => e.id)",
        FINGER,
    )
    assert not small
