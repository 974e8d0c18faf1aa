#  SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests stand on: the emulated robot, the supervisor, the gateway and
a network cable between browser and gateway, each a process or thread of the
test's own on free ports; and a real Chromium."""

from __future__ import annotations

import asyncio
import contextlib
import ctypes
import fcntl
import json
import math
import re
import shutil
import socket
import struct
import threading
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from parties import LIMIT, PROGRAMS, ROOT, Child, Emulator, Supervisor, await_
from selenium import webdriver
from selenium.webdriver import ActionChains
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.remote.webelement import WebElement

NEAR = 1.5
#  Centimetres between a point and where the robot is to pass

IMAGE = (640, 480)

Point = tuple[float, float]


def be_alone() -> None:
    """In a network of its own, if permitted: Chromium drops what it is loading when
    anything changes in the machine's, as other tests do."""
    if ctypes.CDLL(None).unshare(0x40000000) == 0:
        with socket.socket() as any_socket:
            up = struct.pack("16sH22x", b"lo", 1)
            fcntl.ioctl(any_socket, 0x8914, up)


def patient_gateway(folder: Path) -> Path:
    """A copy of the program to which nobody is gone because the machine is slow."""
    web = folder / "monitor" / "web"
    shutil.copytree(ROOT / "monitor" / "web", web)
    for name, limit in (
        ("destijl_web/hub.py", "^(SILENCE|ABSENCE) = "),
        ("destijl_web/guard.py", "^PATIENCE = "),
        ("page/link.js", "drives: "),
    ):
        text = (web / name).read_text(encoding="utf-8")
        longer = re.sub(limit + r"(?=\d)", r"\g<0>99", text, flags=re.MULTILINE)
        assert longer != text, name
        (web / name).write_text(longer, encoding="utf-8")
    (folder / "bin").mkdir()
    return Path(shutil.copy(PROGRAMS / "destijl_web", folder / "bin"))


class Gateway(Child):
    def __init__(
        self, program: Path, supervisor_port: int, *options: str | Path
    ) -> None:
        super().__init__(
            program,
            *("--supervisor", f"127.0.0.1:{supervisor_port}", "--port", "0"),
            *options,
        )
        self.port = int(self.line(r"http://127\.0\.0\.1:(\d+)")[1])
        self.precede_others()  # it owes signs of life, however busy the machine is

    @property
    def server(self) -> int:
        """The process that serves: the program's own guards it."""
        (process,) = self.children
        return process


class Cable:
    """Relays connections to a port, until it is cut."""

    def __init__(self) -> None:
        self.leads_to = 0
        self._writers: list[asyncio.StreamWriter] = []
        self._whole = asyncio.Event()
        self._whole.set()
        self._loop = asyncio.new_event_loop()
        self._server = self._loop.run_until_complete(
            asyncio.start_server(self._relay, "127.0.0.1", 0)
        )
        self.port: int = self._server.sockets[0].getsockname()[1]
        threading.Thread(target=self._loop.run_forever, daemon=True).start()

    async def _relay(
        self, near: asyncio.StreamReader, to_near: asyncio.StreamWriter
    ) -> None:
        try:
            far, to_far = await asyncio.open_connection("127.0.0.1", self.leads_to)
        except OSError:
            to_near.close()
            return
        self._writers.extend((to_near, to_far))
        await asyncio.gather(self._pass_on(near, to_far), self._pass_on(far, to_near))

    async def _pass_on(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        """Also that the connection has ended."""
        with contextlib.suppress(OSError):
            while data := await reader.read(65536):
                await self._whole.wait()
                writer.write(data)
                await writer.drain()
        await self._whole.wait()
        writer.close()

    def cut(self) -> None:
        """Nothing passes any more; both ends do not know."""
        self._loop.call_soon_threadsafe(self._whole.clear)

    def mend(self) -> None:
        self._loop.call_soon_threadsafe(self._whole.set)

    def tear(self) -> None:
        """All connections are closed; new ones may be made."""
        self._loop.call_soon_threadsafe(self._close_all)

    def _close_all(self) -> None:
        while self._writers:
            self._writers.pop().close()

    def end(self) -> None:
        self.tear()
        self._loop.call_soon_threadsafe(self._server.close)
        #  the closes take another turn of the loop
        self._loop.call_soon_threadsafe(self._loop.call_later, 0.1, self._loop.stop)


class Stand:
    """Robot, supervisor, gateway, cable."""

    def __init__(
        self,
        folder: Path,
        *gateway: str | Path,
        line: str = "socket",
        emulator: Sequence[str] = ("--pose", "25,20,0"),
        program: Path = PROGRAMS / "destijl_web",
    ) -> None:
        """With line="link" a pseudo-terminal, which can be hung up."""
        with contextlib.ExitStack() as made:
            self.emulator = Emulator(folder / "robot", line, *emulator)
            self.emulator.precede_others()  # it stands for a device
            made.callback(self.emulator.end)
            #  nobody else is given this port between two supervisors
            bound = made.enter_context(socket.socket())
            bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            bound.bind(("127.0.0.1", 0))
            self._port: int = bound.getsockname()[1]
            self.supervisor = self.new_supervisor()
            made.callback(lambda: self.supervisor.end())
            self.cable = Cable()
            made.callback(self.cable.end)
            self.address = f"http://127.0.0.1:{self.cable.port}"
            self._program = program
            self._options = ("--origin", self.address, *gateway)
            self.gateway = self.new_gateway()
            made.callback(lambda: self.gateway.end())
            self._made = made.pop_all()

    def new_supervisor(self) -> Supervisor:
        return Supervisor(
            self.emulator.line_at,
            *("--bind", "127.0.0.1", "--port", str(self._port)),
            *("--camera", self.emulator.camera, "--answer-timeout", "300"),
        )

    def new_gateway(self) -> Gateway:
        gateway = Gateway(self._program, self._port, *self._options)
        self.cable.leads_to = gateway.port
        return gateway

    @property
    def account(self) -> str:
        return "\n".join(
            child.account for child in (self.supervisor, self.gateway, self.emulator)
        )

    def end(self) -> None:
        with self._made, contextlib.suppress(AssertionError, OSError):
            self.emulator.journal()  # into its lines

    def stands(self, within: float = LIMIT) -> None:
        await_(lambda: not self.emulator.moving, "the robot stands", within, 0.005)

    def moves(self) -> None:
        await_(lambda: self.emulator.moving, "the robot moves", every=0.005)

    def moves_and_stands(self) -> None:
        self.moves()
        self.stands()

    def stays(self, seconds: float = 0.3) -> None:
        """It stands, and goes on so."""
        time.sleep(seconds)
        assert not self.emulator.moving, "it moves"

    def drives(self, page: Page, key: str = "w") -> None:
        """As long as the key is held."""
        with held(page, key):
            self.moves()
        self.stands()

    def is_near(self, place: Point) -> bool:
        return math.dist(self.emulator.pose[:2], place) < NEAR

    def arrives(self, page: Page, place: Point) -> None:
        """By a mission, which ends well."""
        page.logged(code="mission_done")
        await_(lambda: not page.visible("mission"), "it is over")
        self.stands()
        assert self.is_near(place), self.emulator.pose


class Browser:
    """A Chromium of its own, whose pages are windows, all in front. A window is
    used again by the next test: a new one costs as much as the page in it."""

    def __init__(self, folder: Path) -> None:
        options = webdriver.ChromeOptions()
        options.binary_location = "/usr/bin/chromium"
        for argument in (
            "--headless=new",
            "--no-sandbox",  # root, in a container
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--no-first-run",
            "--disable-component-update",
            "--disable-background-networking",
            #  one process draws all pages: to start another for each, and a
            #  spare one, costs more than a page does
            "--disable-features=SpareRendererForSitePerProcess,BackForwardCache",
            "--disable-site-isolation-trials",
            "--renderer-process-limit=1",
            "--force-color-profile=srgb",
            "--hide-scrollbars",
            "--window-size=1280,900",
            f"--user-data-dir={folder}",
        ):
            options.add_argument(argument)
        options.add_experimental_option(
            "prefs", {"download.default_directory": str(folder / "downloads")}
        )
        options.add_experimental_option("perfLoggingPrefs", {"enablePage": False})
        options.set_capability(
            "goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"}
        )
        self.driver = webdriver.Chrome(
            options=options, service=Service("/usr/bin/chromedriver")
        )
        self.driver.set_script_timeout(60)
        self.driver.set_page_load_timeout(LIMIT)
        self.driver.get("about:blank")
        self._keeper = self.driver.current_window_handle
        self._at = self._keeper
        self._free: list[str] = []

    def at(self, handle: str) -> Any:
        """The driver, at this window."""
        if handle != self._at:
            self.driver.switch_to.window(handle)
            self._at = handle
        return self.driver

    def lives(self) -> bool:
        return self.driver.service.process.poll() is None

    def command(self, name: str, **parameters: Any) -> Any:
        return self.driver.execute_cdp_cmd(name, parameters)

    def page(
        self,
        address: str,
        languages: str = "en",
        size: tuple[int, int] | None = None,
        touch: bool = False,
        dark: bool = False,
    ) -> Page:
        if self._free:
            self.at(self._free.pop())
        else:
            self.at(self._keeper).switch_to.new_window("window")
            self._at = self.driver.current_window_handle
        page = Page(self, self._at, address)
        agent = self.driver.execute_script("return navigator.userAgent")
        self.command(
            "Emulation.setUserAgentOverride", userAgent=agent, acceptLanguage=languages
        )
        if size is None:
            self.command("Emulation.clearDeviceMetricsOverride")
        else:
            self.command(
                "Emulation.setDeviceMetricsOverride",
                **{"width": size[0], "height": size[1], "deviceScaleFactor": 1},
                mobile=touch,
            )
        self.command("Emulation.setTouchEmulationEnabled", enabled=touch)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else ""}
        self.command("Emulation.setEmulatedMedia", features=[scheme])
        self.driver.get(address)
        return page

    def close_pages(self) -> None:
        for handle in self.driver.window_handles:
            if handle == self._keeper or handle in self._free:
                continue
            self.at(handle).get("about:blank")
            if self._free or self.driver.execute_script("return document.hidden"):
                self.driver.close()
            else:
                self._free.append(handle)
                ActionChains(self.driver).reset_actions()  # no key is held
        self.at(self._keeper)
        self.command("Network.clearBrowserCookies")

    def console(self) -> list[str]:
        """The errors since it was asked last."""
        return [
            entry["message"]
            for entry in self.driver.get_log("browser")
            if entry["level"] == "SEVERE"
        ]

    def requests(self) -> list[str]:
        """The addresses that pages have asked for since it was asked last."""
        result = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                result.append(message["params"]["request"]["url"])
            elif message["method"] == "Network.webSocketCreated":
                result.append(message["params"]["url"])
        return result

    def end(self) -> None:
        self.driver.quit()


ELEMENT = (
    "arguments[1] ? document.getElementById(arguments[1]) : document.documentElement"
)
#  In a script: that of this name, or the page itself


class Page:
    """The page in a window. What it relies on is in the head of index.html."""

    def __init__(self, browser: Browser, handle: str, address: str) -> None:
        self.browser = browser
        self.address = address
        self._handle = handle

    @property
    def driver(self) -> Any:
        return self.browser.at(self._handle)

    def run(self, script: str, *arguments: Any) -> Any:
        return self.driver.execute_script(script, *arguments)

    def element(self, name: str) -> WebElement:
        return self.driver.find_element(By.ID, name)

    def data(self, key: str, element: str = "") -> str:
        """An attribute data-KEY, of the page or of an element."""
        script = f"return ({ELEMENT})?.getAttribute('data-' + arguments[0]) ?? ''"
        return str(self.run(script, key, element))

    def all(self, selector: str) -> list[WebElement]:
        return list(self.driver.find_elements(By.CSS_SELECTOR, selector))

    def one(self, selector: str) -> WebElement:
        """The first that there is."""
        found: list[WebElement] = await_(lambda: self.all(selector), selector)
        return found[0]

    def click_one(self, selector: str) -> None:
        self.click_element(self.one(selector))

    def write(self, name: str, *text: str) -> WebElement:
        """Into that field, which then has nothing else."""
        field = self.element(name)
        field.clear()
        field.send_keys(*text)
        return field

    def open_more(self) -> None:
        """All orders, and the field for points."""
        self.run("document.querySelector('details.more').open = true")

    def order(self, label: str) -> None:
        self.open_more()
        self.click(f"order-{label}")

    def rectangle(self, name: str) -> dict[str, float]:
        """Where an element is in the window."""
        script = "return arguments[0].getBoundingClientRect().toJSON()"
        return dict(self.run(script, self.element(name)))

    def shows(
        self, key: str, value: str, within: float = LIMIT, element: str = ""
    ) -> None:
        await_(
            lambda: self.data(key, element) == value,
            lambda: f"data-{key}={value}; log: {self.log()}",
            *(within, 0.05),
        )

    def text(self, name: str) -> str:
        script = "return document.getElementById(arguments[0])?.innerText ?? ''"
        return str(self.run(script, name)).strip()

    def visible(self, name: str) -> bool:
        return bool(self.element(name).is_displayed())

    def images(self) -> int:
        return int(self.data("images", "picture") or 0)

    def await_images(self, count: int) -> None:
        """That many more."""
        wanted = self.images() + count
        await_(lambda: self.images() >= wanted, f"{count} images")

    def click(self, name: str) -> None:
        await_(lambda: self.visible(name), f"{name} is visible")
        self.click_element(self.element(name))

    def click_element(self, element: WebElement) -> None:
        """As a user would: not where the page's head covers it."""
        self.run(
            "const e = arguments[0], r = e.getBoundingClientRect();"
            "const at = document.elementFromPoint("
            "(r.left + r.right) / 2, (r.top + r.bottom) / 2);"
            "if (!e.contains(at)) e.scrollIntoView({block: 'center'})",
            element,
        )
        element.click()

    def replay(self, row: str = "#recordings-list") -> None:
        """The first recording there, at its first picture. What is in the list is
        new: no row that is about to go."""
        self.run("document.getElementById('recordings-list').replaceChildren()")
        self.click("recordings-refresh")
        self.click_one(f"{row} [data-do=replay]")
        await_(lambda: self.data("index", "replay-picture"), "the first picture")

    def replay_at(self, moment: float) -> None:
        """In milliseconds from its beginning."""
        self.run(
            "const s = document.getElementById('replay-slider');"
            "s.value = arguments[0]; s.dispatchEvent(new Event('input'))",
            moment,
        )

    def middle(self, name: str) -> tuple[float, float]:
        """Of an element, brought into the window, where it is now."""
        script = "arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})"
        self.run(script, self.element(name))
        r = self.rectangle(name)
        return r["x"] + r["width"] / 2, r["y"] + r["height"] / 2

    def touch(self, event: str, *point: float) -> None:
        """Of one finger: touchStart, touchMove, touchEnd, touchCancel."""
        points = [{"x": point[0], "y": point[1]}] if point else []
        self.driver.execute_cdp_cmd(
            "Input.dispatchTouchEvent", {"type": event, "touchPoints": points}
        )

    def hold(self, key: str) -> None:
        ActionChains(self.driver).key_down(key).perform()

    def release(self, key: str) -> None:
        ActionChains(self.driver).key_up(key).perform()

    def press(self, key: str) -> None:
        ActionChains(self.driver).key_down(key).key_up(key).perform()

    def log(self) -> list[dict[str, str]]:
        """The lines of its log, the latest first."""
        return list(
            self.run(
                "return [...document.querySelectorAll('#log > li')].map(e =>"
                "({...e.dataset, text: e.innerText}))"
            )
        )

    def logged(self, within: float = LIMIT, **wanted: str) -> dict[str, str]:
        lines: list[dict[str, str]] = await_(
            lambda: [line for line in self.log() if wanted.items() <= line.items()],
            lambda: f"{wanted} in the log: {self.log()}",
            *(within, 0.05),
        )
        return lines[0]

    def start(self) -> None:
        """The one button for a newcomer: all its steps are done, and the picture
        is there."""
        self.shows("link", "open")
        button = self.element("start")
        await_(
            lambda: button.get_dom_attribute("aria-disabled") != "true",
            "it can be started",
        )
        self.click("start")
        self.shows("robot", "started")
        self.shows("positions", "true")
        self.await_images(1)
        close = self.element("start-close")
        await_(lambda: not close.get_property("hidden"), "the steps are done")

    def close_start(self) -> None:
        """The steps of the start, which lie over the picture."""
        self.run("arguments[0].click()", self.element("start-close"))

    def take_wheel(self) -> None:
        """A page that was late, or hidden, may have lost it."""
        self.shows("link", "open")
        if self.data("wheel") != "me":
            self.click("wheel-take")
            self.shows("wheel", "me")

    def confirm_arena(self) -> None:
        self.close_start()
        self.click("arena-search")
        self.shows("arena", "found")
        self.click("arena-confirm")
        self.shows("arena", "confirmed")
        self.await_images(3)

    def points(self, key: str, element: str = "overlay") -> list[Point]:
        numbers = [float(one) for one in self.data(key, element).split(";") if one]
        return list(zip(numbers[::2], numbers[1::2], strict=True))

    def plan(self) -> list[Point]:
        """That of the mission under way."""
        await_(lambda: self.visible("mission"), "a mission")
        return self.points("plan")

    def offset(self, point: Point) -> tuple[int, int]:
        """Of a pixel of the image from the middle of the picture, as it is shown."""
        x, y = point[0] - IMAGE[0] / 2, point[1] - IMAGE[1] / 2
        scale = self.scale()
        return round(x * scale), round(y * scale)

    def scale(self) -> float:
        """Pixels of the page for one of the image."""
        r = self.rectangle("picture")
        return min(r["width"] / IMAGE[0], r["height"] / IMAGE[1])

    def pointer(self, point: Point) -> ActionChains:
        """At a pixel of the image."""
        return ActionChains(self.driver, duration=10).move_to_element_with_offset(
            self.element("picture"), *self.offset(point)
        )

    def click_at(self, point: Point) -> None:
        self.pointer(point).click().perform()

    def bring_to_front(self) -> None:
        """From behind another tab, or minimised; a hidden page takes no key."""
        self.driver.set_window_rect(0, 0, 1280, 900)
        self.browser.command("Page.bringToFront")
        self.driver.execute_async_script(
            "const done = arguments[0];"
            "if (document.visibilityState === 'visible') done();"
            "else document.addEventListener('visibilitychange', () => done(),"
            " {once: true})"
        )

    def close(self) -> None:
        self.driver.close()

    def picture(self, path: Path, at: str) -> None:
        self.run("document.getElementById(arguments[0]).scrollIntoView()", at)
        self.driver.save_screenshot(str(path))


@contextlib.contextmanager
def held(page: Page, key: str) -> Iterator[None]:
    page.hold(key)
    try:
        yield
    finally:
        page.release(key)


def pixel(place: Point) -> Point:
    """Where a robot at that place of the arena (cm) is seen, as the emulated camera
    hangs: their middles are the same, and the picture is upside down."""
    scale = 6.33
    x, y = scale * (place[0] - 40), scale * (place[1] - 30)
    return IMAGE[0] / 2 + x, IMAGE[1] / 2 - y
