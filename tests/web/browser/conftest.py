#  SPDX-License-Identifier: GPL-3.0-or-later
"""What each test is given, and what is judged after each: no error on the
browser's console, no request to anywhere but the gateway."""

from __future__ import annotations

import re
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from helpers import token_file
from parties import ROOT, ran
from stand import Browser, Page, Stand, be_alone


@pytest.fixture(scope="session")
def browsers(
    tmp_path_factory: pytest.TempPathFactory,
) -> Iterator[Callable[[int], Browser]]:
    """Chromium number N, which is another user's than number M."""
    be_alone()
    made: dict[int, Browser] = {}

    def browser(number: int) -> Browser:
        if number not in made or not made[number].lives():
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
                print(one.account)  # shown where the test has failed

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


@pytest.fixture
def watcher(stand: Stand, driver: Page, visitors: Visitors) -> Page:
    """Another browser's page, which sees that one drives."""
    watcher = visitors.open(stand.address, 1)
    watcher.shows("wheel", "other")
    return watcher


TEACHERS = "the-teacher-s-own-word"
VIEWERS = "the-word-for-the-class"


@pytest.fixture
def tokens(tmp_path: Path) -> tuple[str, ...]:
    """The gateway's options that name their files."""
    teachers, viewers = (token_file(tmp_path, word) for word in (TEACHERS, VIEWERS))
    return ("--token", teachers, "--viewers-token", viewers)


@pytest.fixture
def guarded(stands: Callable[..., Stand], tokens: tuple[str, ...]) -> Stand:
    """It asks for these."""
    return stands(*tokens)


@pytest.fixture
def recordings(tmp_path: Path) -> Path:
    folder = tmp_path / "recordings"
    folder.mkdir()
    return folder


@pytest.fixture
def recorder(stands: Callable[..., Stand], recordings: Path) -> Stand:
    """It records there."""
    return stands("--record", recordings)


@pytest.fixture(scope="session")
def axe() -> str:
    """axe-core, which script/tools fetches."""
    _, place = ran("sh", "-c", '. script/places; echo "$axe"', cwd=ROOT)
    if not Path(place.strip()).is_file():
        pytest.skip("axe-core is not there: script/tools fetches it")
    return Path(place.strip()).read_text(encoding="utf-8")


class Film:
    """Of the arena in a page, in pictures that are joined after the test."""

    LARGEST = 1_500_000
    FASTER = 2
    #  It is shown at so many times its speed

    def __init__(self, page: Page, path: Path | None) -> None:
        self._page = page
        self._path = path
        self._taken: list[tuple[float, str]] = []

    def take(self) -> None:
        if self._path is not None:
            path = f"{self._path}-{len(self._taken):03}.png"
            self._taken.append((time.monotonic(), path))
            self._page.element("arena").screenshot(path)

    def take_until(self, condition: Callable[..., Any], *arguments: Any) -> None:
        while self._path is not None and not condition(*arguments):
            self.take()

    def join(self) -> None:
        if self._path is None:
            return
        film = self._path.with_suffix(".webp")
        ends = [begin for begin, _ in self._taken[1:]] + [self._taken[-1][0] + 4]
        frames: list[str] = []
        for (begin, path), end in zip(self._taken, ends, strict=True):
            frames += ["-d", str(round(1000 * (end - begin) / self.FASTER)), path]
        subprocess.run(
            ["img2webp", "-lossy", "-q", "50", *frames, "-o", film], check=True
        )
        for _, path in self._taken:
            Path(path).unlink()
        assert film.stat().st_size < self.LARGEST, f"{film} is too large"


class Pictures:
    """Those of the documentation: taken in the test, made small after it."""

    LARGEST = 200_000

    def __init__(self, folder: Path | None) -> None:
        self._folder = folder
        self._taken: list[Path] = []
        self._films: list[Film] = []

    def take(self, page: Page, name: str, at: str = "arena") -> None:
        """With the element at in the window."""
        if self._folder is not None:
            self._taken.append(self._folder / f"{name}.png")
            page.picture(self._taken[-1], at)

    def film(self, page: Page, name: str) -> Film:
        film = Film(page, None if self._folder is None else self._folder / name)
        self._films.append(film)
        return film

    def finish(self) -> None:
        for film in self._films:
            film.join()
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
