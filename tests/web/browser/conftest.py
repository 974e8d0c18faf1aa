#  SPDX-License-Identifier: GPL-3.0-or-later
"""What each test is given, and what is judged after each: no error on the
browser's console, no request to anywhere but the gateway."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from _pytest.runner import runtestprotocol
from stand import ROOT, Browser, Page, Stand, Standstills

ACCOUNT = pytest.StashKey[str]()
#  Of the stand, for the report of a test that fails

TRIES = 6
#  Of a test that fails while the machine stood still: nobody can tell then who
#  was late


def pytest_runtest_protocol(
    item: pytest.Function, nextitem: pytest.Item | None
) -> bool:
    hook = item.ihook
    hook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
    for left in reversed(range(TRIES)):
        with Standstills() as standstills:
            reports = runtestprotocol(item, nextitem=nextitem, log=False)
        if left == 0 or not standstills.longest or all(r.passed for r in reports):
            break
        with item.config.pluginmanager.getplugin(
            "capturemanager"
        ).global_and_fixture_disabled():
            print(f"\n{item.nodeid} again: late by {standstills.longest:.3f} s:")
            print(*(r.longreprtext for r in reports if r.failed))
        item._initrequest()
    for report in reports:
        if report.failed:
            report.sections.append(("the stand", item.stash.get(ACCOUNT, "")))
        hook.pytest_runtest_logreport(report=report)
    hook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
    return True


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--pictures",
        metavar="FOLDER",
        help="leave there the pictures of the documentation; needs pngquant",
    )


@pytest.fixture(scope="session")
def browsers(
    tmp_path_factory: pytest.TempPathFactory,
) -> Iterator[Callable[[int], Browser]]:
    """Chromium number N, which is another user's than number M."""
    made: dict[int, Browser] = {}

    def browser(number: int) -> Browser:
        if number in made and made[number].ended is not None:
            print(f"\nchromedriver {number} has ended with {made[number].ended}")
            del made[number]
        if number not in made:
            made[number] = Browser(tmp_path_factory.mktemp(f"chromium{number}"))
        return made[number]

    yield browser
    for one in made.values():
        one.end()


class Visitors:
    """Opens pages, and remembers what is to be judged of them."""

    def __init__(self, browsers: Callable[[int], Browser]) -> None:
        self._browsers = browsers
        self._used: dict[int, Browser] = {}
        self._addresses: set[str] = set()
        self._excused: list[str] = []

    def open(self, address: str, number: int = 0, **how: Any) -> Page:
        browser = self._browsers(number)
        if number not in self._used:
            browser.console()
            browser.requests()
            self._used[number] = browser
        self._addresses.add(re.sub("^http", "", address))
        return browser.page(address, **how)

    def excuse(self, pattern: str) -> None:
        """The console may tell this: the test is about it."""
        self._excused.append(pattern)

    def judge(self) -> None:
        wrong = []
        for browser in self._used.values():
            wrong += [
                line
                for line in browser.console()
                if not any(re.search(one, line) for one in self._excused)
            ]
            wrong += [
                f"asked for {url}"
                for url in browser.requests()
                if not re.match("(data|blob|about|chrome|devtools):", url)
                and not any(
                    re.sub("^(http|ws)", "", url).startswith(own + "/")
                    for own in self._addresses
                )
            ]
            browser.close_pages()
        assert not wrong, "\n".join(wrong)


@pytest.fixture
def visitors(browsers: Callable[[int], Browser]) -> Iterator[Visitors]:
    visitors = Visitors(browsers)
    yield visitors
    visitors.judge()


@pytest.fixture
def stands(
    tmp_path: Path, request: pytest.FixtureRequest
) -> Iterator[Callable[..., Stand]]:
    """Makes a stand with other options."""
    with ExitStack() as made:

        def stand(*gateway: str | Path, **others: Any) -> Stand:
            if request.config.getoption("--pictures") is not None:
                #  an image without noise is smaller
                others["emulator"] = ("--pose", "25,20,0", "--noise", "0")
            one = Stand(tmp_path, *gateway, **others)
            made.callback(end, one)
            return one

        def end(one: Stand) -> None:
            try:
                one.end()
            finally:
                request.node.stash[ACCOUNT] = one.account

        yield stand


@pytest.fixture
def stand(stands: Callable[..., Stand]) -> Stand:
    return stands()


@pytest.fixture
def page(stand: Stand, visitors: Visitors) -> Page:
    return visitors.open(stand.address)


@pytest.fixture
def driver(page: Page) -> Page:
    """A page that drives a started robot, and sees it."""
    page.start()
    return page


@pytest.fixture(scope="session")
def axe() -> str:
    """axe-core, which script/tools fetches."""
    place = subprocess.run(
        ["sh", "-c", '. script/places; echo "$axe"'],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    ).stdout.strip()
    if not Path(place).is_file():
        pytest.skip("axe-core is not there: script/tools fetches it")
    return Path(place).read_text(encoding="utf-8")


class Pictures:
    """Those of the documentation: taken in the test, made small after it."""

    LARGEST = 200_000

    def __init__(self, folder: Path | None) -> None:
        self._folder = folder
        self._taken: list[Path] = []

    def take(self, page: Page, name: str, at: str = "arena") -> None:
        """With the element at in the window."""
        if self._folder is not None:
            self._taken.append(self._folder / f"{name}.png")
            page.picture(self._taken[-1], at)

    def finish(self) -> None:
        for path in self._taken:
            subprocess.run(
                [
                    *("pngquant", "128", "--force", "--skip-if-larger", "--strip"),
                    *("--speed", "1", "--ext", ".png", path),
                ],
                check=True,
            )
            assert path.stat().st_size < self.LARGEST, f"{path} is too large"


@pytest.fixture
def pictures(request: pytest.FixtureRequest) -> Iterator[Pictures]:
    folder = request.config.getoption("--pictures")
    pictures = Pictures(None if folder is None else Path(folder).resolve())
    yield pictures
    pictures.finish()
