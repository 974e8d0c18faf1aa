#  SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests stand on: the emulated robot, the supervisor, the gateway and
a network cable between browser and gateway, each a process or thread of the
test's own on free ports; and a real Chromium."""

from __future__ import annotations

import contextlib
import json
import os
import re
import select
import signal
import socket
import subprocess
import threading
import time
import tty
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from selenium import webdriver
from selenium.webdriver import ActionChains
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.remote.webelement import WebElement

ROOT = Path(__file__).resolve().parents[3]
PROGRAMS = ROOT / "bin"

LIMIT = 10.0
#  Seconds for what has no limit of its own: a machine with other work


class Failure(AssertionError):
    """Something did not come in time."""


def await_(
    condition: Callable[[], Any], what: str, within: float = LIMIT, every: float = 0.02
) -> Any:
    """The first true value of condition."""
    end = time.monotonic() + within
    while True:
        late = time.monotonic() > end
        value = condition()
        if value:
            return value
        if late:
            raise Failure(f"not within {within} s: {what}")
        time.sleep(every)


class Standstills:
    """Notes how long a thread did not run that should have, and how late a
    byte was on a pseudo-terminal, as the robot's line is one."""

    TICK = 0.01
    TOLERATED = 0.1
    #  A fifth of the shortest limit here
    BYTE_TOLERATED = 0.02
    #  A quarter of what the robot has for an answer

    def __init__(self) -> None:
        self.longest = 0.0
        #  of those not tolerated
        self._ended = threading.Event()
        self._threads = [
            threading.Thread(target=watch, daemon=True)
            for watch in (self._watch, self._watch_line)
        ]

    def _note(self, late: float, tolerated: float) -> None:
        if late > tolerated:
            self.longest = max(self.longest, late)

    def _watch(self) -> None:
        before = time.monotonic()
        while not self._ended.wait(self.TICK):
            now = time.monotonic()
            self._note(now - before - self.TICK, self.TOLERATED)
            before = now

    def _watch_line(self) -> None:
        ends = os.openpty()
        robot, device = ends
        tty.setraw(device)
        while not self._ended.wait(self.TICK):
            begun = time.monotonic()
            os.write(device, b"x")
            os.read(robot, 1)
            self._note(time.monotonic() - begun, self.BYTE_TOLERATED)
        for end in ends:
            os.close(end)

    def __enter__(self) -> Standstills:
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        for thread in self._threads:
            thread.join()


class Child:
    """A process whose lines are kept."""

    def __init__(self, *arguments: str | Path, real_time: bool = False) -> None:
        before: list[str | Path] = []
        if real_time and os.geteuid() == 0:
            #  as the other system tests have it: it stands for a device
            before = ["chrt", "--fifo", "1"]
        self.name = Path(arguments[0]).name
        self.process = subprocess.Popen(
            [*before, *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            bufsize=1,
            cwd=ROOT,
        )
        self.lines: list[str] = []
        self._news = threading.Condition()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            with self._news:
                self.lines.append(line.rstrip("\n"))
                self._news.notify_all()

    def line(
        self, pattern: str, after: int = 0, within: float = LIMIT
    ) -> re.Match[str]:
        """The first of its lines, from number after on, with pattern."""

        def found() -> re.Match[str] | None:
            for line in self.lines[after:]:
                match = re.search(pattern, line)
                if match:
                    return match
            return None

        with self._news:
            self._news.wait_for(found, within)
            match = found()
        if match is None:
            raise Failure(
                f"no line with {pattern!r} within {within} s of {self.account}"
            )
        return match

    def write(self, line: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    @property
    def account(self) -> str:
        """Its last lines, told where a test fails."""
        return "\n".join([f"{self.name}:", *self.lines[-20:]])

    @property
    def children(self) -> list[int]:
        path = f"/proc/{self.process.pid}/task/{self.process.pid}/children"
        return [int(word) for word in Path(path).read_text(encoding="ascii").split()]

    def end(self, number: int = signal.SIGTERM) -> None:
        if self.process.poll() is None:
            self.process.send_signal(number)
            try:
                self.process.wait(LIMIT)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
                raise Failure(f"{self.name} does not end") from None


@dataclass
class Command:
    """One that the robot was sent; times are those of time.monotonic."""

    at: float
    text: str


class Emulator(Child):
    def __init__(self, folder: Path, *options: str) -> None:
        self.link = folder / "robot"
        super().__init__(
            PROGRAMS / "destijl_emulator",
            *("--link", self.link, "--camera-port", "0", "--boot-ms", "100"),
            *options,
            real_time=True,
        )
        self.camera = self.line("^camera (.*)")[1]
        self._lock = threading.Lock()

    def ask(self, command: str) -> str:
        with self._lock:
            before = len(self.lines)
            self.write(command)
            return self.line("", before).string

    def status(self) -> dict[str, str]:
        return dict(word.split("=", 1) for word in self.ask("status").split())

    @property
    def pose(self) -> tuple[float, float, float]:
        """Centimetres, degrees."""
        now = self.status()
        return float(now["x"]), float(now["y"]), float(now["heading"])

    @property
    def moving(self) -> bool:
        return self.status()["moving"] == "1"

    def journal(self) -> list[Command]:
        with self._lock:
            before = len(self.lines)
            self.write("journal")
            self.line("^end$", before)
            lines = self.lines[before:-1]
        result = []
        for line in lines:
            words = dict(word.split("=", 1) for word in re.findall(r"\w+=\S*", line))
            result.append(Command(float(words["last"]), words.get("command", "")))
        return result


class Supervisor(Child):
    def __init__(self, emulator: Emulator, *options: str | Path, port: int = 0) -> None:
        super().__init__(
            PROGRAMS / "destijl",
            *("--bind", "127.0.0.1", "--port", str(port)),
            *("--serial", emulator.link, "--camera", emulator.camera),
            *options,
        )
        self.port = int(self.line(r"listening on 127\.0\.0\.1:(\d+)")[1])


class Gateway(Child):
    def __init__(self, supervisor_port: int, *options: str | Path) -> None:
        super().__init__(
            PROGRAMS / "destijl_web",
            *("--supervisor", f"127.0.0.1:{supervisor_port}", "--port", "0"),
            *options,
        )
        self.port = int(self.line(r"http://127\.0\.0\.1:(\d+)", within=20)[1])

    @property
    def server(self) -> int:
        """The process that serves: the program's own guards it."""
        (process,) = self.children
        return process


class Cable:
    """Relays connections to a port, until it is cut."""

    def __init__(self) -> None:
        self.leads_to = 0
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listener.getsockname()[1]
        self._pairs: dict[socket.socket, socket.socket] = {}
        self._lock = threading.Lock()
        self._silent = False
        self._ended = False
        threading.Thread(target=self._relay, daemon=True).start()

    def _relay(self) -> None:
        while not self._ended:
            with self._lock:
                silent = self._silent
                watched = [self._listener, *([] if silent else self._pairs)]
            try:
                ready, _, _ = select.select(watched, [], [], 0.02)
            except (OSError, ValueError):
                continue  # closed meanwhile
            with self._lock:
                for one in ready:
                    if one is self._listener:
                        self._connect()
                    elif one in self._pairs:
                        self._pass_on(one)

    def _connect(self) -> None:
        near = None
        try:
            near, _ = self._listener.accept()
            far = socket.create_connection(("127.0.0.1", self.leads_to))
        except OSError:
            if near is not None:
                near.close()
            return
        for one in (near, far):
            one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._pairs[near] = far
        self._pairs[far] = near

    def _pass_on(self, one: socket.socket) -> None:
        other = self._pairs[one]
        try:
            data = one.recv(65536)
            if data:
                other.sendall(data)
                return
        except OSError:
            pass
        self._close(one)

    def _close(self, one: socket.socket) -> None:
        other = self._pairs.pop(one)
        self._pairs.pop(other, None)
        one.close()
        other.close()

    def cut(self) -> None:
        """Nothing passes any more; both ends do not know."""
        with self._lock:
            self._silent = True

    def mend(self) -> None:
        with self._lock:
            self._silent = False

    def tear(self) -> None:
        """All connections are closed; new ones may be made."""
        with self._lock:
            for one in list(self._pairs):
                if one in self._pairs:
                    self._close(one)

    def end(self) -> None:
        self._ended = True
        self.tear()
        self._listener.close()


class Stand:
    """Robot, supervisor, gateway, cable."""

    def __init__(
        self,
        folder: Path,
        *gateway: str | Path,
        emulator: Sequence[str] = ("--pose", "25,20,0"),
        supervisor: Sequence[str | Path] = (),
    ) -> None:
        with contextlib.ExitStack() as made:
            self.emulator = Emulator(folder, *emulator)
            made.callback(self.emulator.end)
            self.supervisor = Supervisor(self.emulator, *supervisor)
            made.callback(lambda: self.supervisor.end())
            self.cable = Cable()
            made.callback(self.cable.end)
            self.address = f"http://127.0.0.1:{self.cable.port}"
            self._options = ("--origin", self.address, *gateway)
            self.gateway = self.new_gateway()
            made.callback(lambda: self.gateway.end())
            self._made = made.pop_all()

    def new_gateway(self) -> Gateway:
        gateway = Gateway(self.supervisor.port, *self._options)
        self.cable.leads_to = gateway.port
        return gateway

    @property
    def account(self) -> str:
        return "\n".join(
            child.account for child in (self.supervisor, self.gateway, self.emulator)
        )

    def end(self) -> None:
        with contextlib.suppress(Failure, OSError):
            self.emulator.journal()  # into its lines
        self._made.close()

    def stands(self, within: float = 1.0) -> float:
        """Waits until the robot stands; the time it took."""
        begin = time.monotonic()
        await_(
            lambda: not self.emulator.moving, "the robot stands", within, every=0.005
        )
        return time.monotonic() - begin

    def moves(self, within: float = LIMIT) -> None:
        await_(lambda: self.emulator.moving, "the robot moves", within, every=0.005)


class Browser:
    """A Chromium of its own, whose pages are windows, all in front."""

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
        self.driver.set_script_timeout(LIMIT)
        self.driver.set_page_load_timeout(LIMIT)
        self.driver.get("about:blank")
        self._keeper = self.driver.current_window_handle

    @property
    def ended(self) -> int | None:
        """The status with which its driver has ended, if it has."""
        status: int | None = self.driver.service.process.poll()
        return status

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
        self.driver.switch_to.window(self._keeper)
        self.driver.switch_to.new_window("window")
        page = Page(self, self.driver.current_window_handle, address)
        agent = self.driver.execute_script("return navigator.userAgent")
        self.command(
            "Emulation.setUserAgentOverride", userAgent=agent, acceptLanguage=languages
        )
        if size is not None:
            self.command(
                "Emulation.setDeviceMetricsOverride",
                width=size[0],
                height=size[1],
                deviceScaleFactor=1,
                mobile=touch,
            )
        if touch:
            self.command("Emulation.setTouchEmulationEnabled", enabled=True)
        if dark:
            self.command(
                "Emulation.setEmulatedMedia",
                features=[{"name": "prefers-color-scheme", "value": "dark"}],
            )
        self.driver.get(address)
        return page

    def close_pages(self) -> None:
        for handle in self.driver.window_handles:
            if handle != self._keeper:
                self.driver.switch_to.window(handle)
                self.driver.close()
        self.driver.switch_to.window(self._keeper)
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


class Page:
    """The page in a window. What it relies on is in the head of index.html."""

    def __init__(self, browser: Browser, handle: str, address: str) -> None:
        self.browser = browser
        self.address = address
        self._handle = handle

    @property
    def driver(self) -> Any:
        driver = self.browser.driver
        driver.switch_to.window(self._handle)
        return driver

    def run(self, script: str, *arguments: Any) -> Any:
        return self.driver.execute_script(script, *arguments)

    def element(self, name: str) -> WebElement:
        return self.driver.find_element(By.ID, name)

    def data(self, key: str, element: str = "") -> str:
        """An attribute data-KEY, of the page or of an element."""
        value = self.run(
            "const e = arguments[1] ? document.getElementById(arguments[1])"
            " : document.documentElement;"
            "return e.getAttribute('data-' + arguments[0])",
            key,
            element,
        )
        return "" if value is None else str(value)

    def shows(self, key: str, value: str, within: float = LIMIT) -> None:
        try:
            await_(lambda: self.data(key) == value, f"data-{key}={value}", within, 0.05)
        except Failure as failure:
            raise Failure(f"{failure}; {self.data(key)!r}, log: {self.log()}") from None

    def text(self, name: str) -> str:
        return str(
            self.run(
                "return document.getElementById(arguments[0])?.innerText ?? ''", name
            )
        ).strip()

    def visible(self, name: str) -> bool:
        return bool(self.element(name).is_displayed())

    def images(self) -> int:
        return int(self.data("images", "picture") or 0)

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

    def refresh_recordings(self) -> None:
        """What is in the list then is new: no row that is about to go."""
        self.run("document.getElementById('recordings-list').replaceChildren()")
        self.click("recordings-refresh")

    def middle(self, name: str) -> tuple[float, float]:
        """Of an element, brought into the window, where it is now."""
        x, y = self.run(
            "const e = document.getElementById(arguments[0]);"
            "e.scrollIntoView({block: 'center', behavior: 'instant'});"
            "const r = e.getBoundingClientRect();"
            "return [(r.left + r.right) / 2, (r.top + r.bottom) / 2]",
            name,
        )
        return float(x), float(y)

    def touch(self, event: str, *point: float) -> None:
        """Of one finger: touchStart, touchMove, touchEnd, touchCancel."""
        points = [{"x": point[0], "y": point[1]}] if point else []
        assert self.driver
        self.browser.command("Input.dispatchTouchEvent", type=event, touchPoints=points)

    def hold(self, key: str) -> None:
        ActionChains(self.driver).key_down(key).perform()

    def release(self, key: str) -> None:
        ActionChains(self.driver).key_up(key).perform()

    def press(self, key: str) -> None:
        ActionChains(self.driver).key_down(key).key_up(key).perform()

    def log(self) -> list[dict[str, str]]:
        """The lines of its log, the latest first."""
        lines = self.run(
            "return [...document.querySelectorAll('#log > li')].map(e =>"
            "({...e.dataset, text: e.innerText}))"
        )
        return list(lines)

    def logged(self, within: float = LIMIT, **wanted: str) -> dict[str, str]:
        def found() -> dict[str, str] | None:
            for line in self.log():
                if all(line.get(key) == value for key, value in wanted.items()):
                    return line
            return None

        line: dict[str, str] = await_(found, f"in the log: {wanted}", within)
        return line

    def start(self) -> None:
        """The one button for a newcomer; then the picture is there."""
        self.shows("link", "open")
        await_(
            lambda: self.element("start").get_attribute("aria-disabled") != "true",
            "it can be started",
        )
        self.click("start")
        self.shows("robot", "started")
        self.shows("positions", "true")
        await_(lambda: self.images() > 0, "an image")

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
