#  SPDX-License-Identifier: GPL-3.0-or-later
"""How long an order takes to its answer: from a program that is connected to
the supervisor itself, and from a page through the gateway while others watch.

usage: fan_out.py [--samples N] [--viewers N,N,...] [--out FOLDER] [--docs]

Section web of script/bench. Starts supervisor, emulator and gateway, 10 images
a second. A line for each number of viewers, and one more with a fifth of the
last number slow: they show an image half a second after it has come. All of
them, but not the page that drives, are in a process of their own. RSTP goes to
the robot and back, at 9600 baud; CPST the supervisor answers by itself. --docs
writes docs/fan-out.md."""

import argparse
import asyncio
import contextlib
import json
import os
import platform
import random
import statistics
import sys
import tempfile
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import aiohttp
from parties import LIMIT, PROGRAMS, ROOT, Child, Emulator, Supervisor

DOCUMENT = ROOT / "docs" / "fan-out.md"
LABELS = ("RSTP", "CPST")
PAUSES = (0.02, 0.06)
#  Seconds between an answer and the next order, at random: no rhythm is to
#  meet that of the images

SLOW = 0.5
#  Seconds from an image's coming to its being shown by a slow viewer


Ask = Callable[[str], Awaitable[None]]


@dataclass
class Row:
    """Of the result."""

    name: str
    times: dict[str, list[float]]
    #  Milliseconds from an order to its answer, of each label
    load: float | None = None
    #  Percent of a processor that the gateway took
    rates: list[float] = field(default_factory=list)
    #  Images a second, of each viewer
    slow_rates: list[float] = field(default_factory=list)

    def figures(self, label: str) -> tuple[float, float, float]:
        """Median, p99, maximum."""
        times = sorted(self.times[label])
        return statistics.median(times), times[int(len(times) * 0.99)], times[-1]

    def line(self) -> str:
        said = f"{self.name:22}"
        for label in LABELS:
            median, p99, largest = self.figures(label)
            said += f" {label} median {median:6.2f} p99 {p99:6.2f}"
            said += f" max {largest:6.2f} ms "
        if self.load is not None:
            said += f" {self.load:.0f} % of a processor"
        if self.rates:
            said += f", {min(self.rates):.1f} to {max(self.rates):.1f} images/s"
        if self.slow_rates:
            said += f", slow ones {min(self.slow_rates):.1f}"
            said += f" to {max(self.slow_rates):.1f}"
        return said

    def cells(self) -> str:
        cells = [self.name]
        for label in LABELS:
            cells += [f"{figure:.2f}" for figure in self.figures(label)]
        cells += ["" if self.load is None else f"{self.load:.0f}"]
        for rates in (self.rates, self.slow_rates):
            cells += [f"{min(rates):.1f} to {max(rates):.1f}" if rates else ""]
        return "| " + " | ".join(cells) + " |"


def processor_time(gateway: Child) -> float:
    """Seconds that the gateway has had, without its guard."""
    (server,) = gateway.children
    fields = Path(f"/proc/{server}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@contextlib.asynccontextmanager
async def direct(port: int) -> AsyncIterator[Ask]:
    reader, writer = await asyncio.open_connection("127.0.0.1", port, limit=2**23)
    answers: asyncio.Queue[str] = asyncio.Queue()

    async def read() -> None:
        while line := await reader.readline():
            if line[:5] not in (b"CIMG:", b"RBLV:", b"CPOS:", b"MSSG:"):
                answers.put_nowait(line.decode().strip())

    async def ask(label: str) -> None:
        writer.write(label.encode() + b"\n")
        answer = await asyncio.wait_for(answers.get(), LIMIT)
        if answer != "AACK":
            raise RuntimeError(f"{label}: {answer}")

    reading = asyncio.create_task(read())
    yield ask
    reading.cancel()
    writer.close()


async def connect(
    client: aiohttp.ClientSession, port: int
) -> aiohttp.ClientWebSocketResponse:
    url = f"http://127.0.0.1:{port}"
    return await client.ws_connect(f"{url}/ws", origin=url, max_msg_size=2**23)


@contextlib.asynccontextmanager
async def through(port: int) -> AsyncIterator[Ask]:
    """From a page that drives."""
    async with aiohttp.ClientSession() as client:
        page = await connect(client, port)
        answers: asyncio.Queue[Any] = asyncio.Queue()
        orders = 0

        async def say(**fields: object) -> None:
            await page.send_str(json.dumps(fields))

        async def read() -> None:
            async for message in page:
                if message.type is aiohttp.WSMsgType.BINARY:
                    await say(type="seen")
                elif '"answer"' in message.data[:20]:
                    answers.put_nowait(json.loads(message.data))

        async def ping() -> None:
            while True:
                await say(type="ping", n=0, hidden=False)
                await asyncio.sleep(0.1)

        async def ask(label: str) -> None:
            nonlocal orders
            orders += 1
            await say(type="order", id=orders, label=label)
            answer = await asyncio.wait_for(answers.get(), LIMIT)
            if answer["id"] != orders or answer["answer"] != "AACK":
                raise RuntimeError(f"{label}: {answer}")

        tasks = [asyncio.create_task(work) for work in (read(), ping())]
        await say(type="wheel", do="take")
        yield ask
        for task in tasks:
            task.cancel()
        await page.close()


async def watch(port: int, count: int, slow: int) -> None:
    """Viewers, the first of them slow ones, until the input ends. Prints how
    many images a second each had."""
    images = [0] * count
    loop = asyncio.get_running_loop()
    async with aiohttp.ClientSession(connector=aiohttp.TCPConnector(limit=0)) as client:

        async def view(number: int) -> None:
            page = await connect(client, port)
            async for message in page:
                if message.type is aiohttp.WSMsgType.BINARY:
                    images[number] += 1
                    if number < slow:
                        await asyncio.sleep(SLOW)
                    await page.send_str('{"type":"seen"}')

        tasks = [asyncio.create_task(view(number)) for number in range(count)]
        async with asyncio.timeout(LIMIT):
            while min(images) == 0:
                for task in tasks:
                    if task.done():
                        task.result()
                await asyncio.sleep(0.05)
        print("watching", flush=True)
        before = list(images)
        begun = time.monotonic()
        await loop.run_in_executor(None, sys.stdin.read)
        took = time.monotonic() - begun
        rates = [(now - then) / took for now, then in zip(images, before, strict=True)]
        print(json.dumps(rates), flush=True)
        for task in tasks:
            task.cancel()


@contextlib.asynccontextmanager
async def watched(port: int, count: int, slow: int, row: Row) -> AsyncIterator[None]:
    """Notes afterwards how many images a second each viewer had."""
    if count == 0:
        yield
        return
    watching = await asyncio.create_subprocess_exec(
        *(sys.executable, __file__, "watch", str(port), str(count), str(slow)),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
    )
    assert watching.stdout is not None
    if not await watching.stdout.readline():
        raise RuntimeError("the viewers have ended")
    yield
    out, _ = await watching.communicate(b"")
    rates = json.loads(out)
    row.slow_rates, row.rates = rates[:slow], rates[slow:]


async def measure(ask: Ask, count: int, row: Row) -> None:
    """So many orders of each label, in turn."""
    for _ in range(count):
        for label in LABELS:
            await asyncio.sleep(random.uniform(*PAUSES))
            begun = time.perf_counter()
            await ask(label)
            row.times[label].append((time.perf_counter() - begun) * 1000)


async def prepare(ask: Ask) -> None:
    await ask("ROPN")
    await asyncio.sleep(1.0)
    for label in ("RSOW", "COPN"):
        await ask(label)
    await asyncio.sleep(1.0)


def new_row(name: str) -> Row:
    return Row(name, {label: [] for label in LABELS})


async def run(samples: int, viewers: list[int]) -> list[Row]:
    rows = [new_row("direct")]
    with contextlib.ExitStack() as started:
        folder = Path(started.enter_context(tempfile.TemporaryDirectory()))
        emulator = Emulator(folder / "robot", "link")
        started.callback(emulator.end)
        supervisor = Supervisor(
            folder / "robot",
            *("--port", "0", "--bind", "127.0.0.1", "--fps", "10"),
            *("--camera", emulator.camera),
        )
        started.callback(supervisor.end)
        async with direct(supervisor.port) as ask:
            await prepare(ask)
            await measure(ask, samples, rows[-1])
        print(rows[-1].line(), flush=True)
        await asyncio.sleep(1.0)
        gateway = Child(
            PROGRAMS / "destijl_web",
            *("--port", "0", "--supervisor", f"127.0.0.1:{supervisor.port}"),
        )
        started.callback(gateway.end)
        port = int(gateway.line(r"open http://.*:(\d+)/")[1])
        await asyncio.sleep(1.0)
        async with through(port) as ask:
            await prepare(ask)
            slow = viewers[-1] // 5
            for count, of_them in [
                *((count, 0) for count in viewers),
                (viewers[-1], slow),
            ]:
                row = new_row(
                    f"{count} viewers" + (f", {of_them} slow" if of_them else "")
                )
                rows.append(row)
                async with watched(port, count, of_them, row):
                    used, begun = processor_time(gateway), time.monotonic()
                    await measure(ask, samples, row)
                    used = processor_time(gateway) - used
                    row.load = used / (time.monotonic() - begun) * 100
                print(row.line(), flush=True)
    return rows


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.machine()


ABOUT = """\
# Orders through the browser monitor's gateway

Written by `script/bench web --docs`; do not edit. Milliseconds from an order to its
answer: direct, from a program that is connected to the supervisor itself; else from a
page that drives through the gateway, while the viewers watch the emulated camera at
10 images a second. {samples} orders of each kind a row; RSTP goes to the robot and
back, at 9600 baud; CPST the supervisor answers by itself. A slow viewer shows an image
{slow} s after it has come. Load: of the gateway, percent of one of {processors}
processors ({processor}, Linux {release}), on which viewers, supervisor and emulator
ran, too.

"""


def document(rows: list[Row], samples: int) -> str:
    about = ABOUT.format(
        samples=samples,
        slow=SLOW,
        processors=os.cpu_count(),
        processor=processor(),
        release=platform.release(),
    )
    titles = ["row"]
    for label in LABELS:
        titles += [f"{label} median", "p99", "max"]
    titles += ["load", "images a second", "of slow ones"]
    lines = ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]
    return about + "\n".join([*lines, *(row.cells() for row in rows)]) + "\n"


def main() -> None:
    if sys.argv[1:2] == ["watch"]:
        asyncio.run(watch(*map(int, sys.argv[2:5])))
        return
    parser = argparse.ArgumentParser(prog="script/bench web")
    parser.add_argument(
        "--samples", type=int, default=1000, help="of each label (1000)"
    )
    parser.add_argument("--viewers", default="0,10,50", help="how many (0,10,50)")
    parser.add_argument("--out", type=Path, help="folder for web.json")
    parser.add_argument("--docs", action="store_true", help=f"write {DOCUMENT.name}")
    chosen = parser.parse_args()
    viewers = [int(count) for count in chosen.viewers.split(",")]
    rows = asyncio.run(run(chosen.samples, viewers))
    if chosen.out is not None:
        result = json.dumps([asdict(row) for row in rows])
        (chosen.out / "web.json").write_text(result, encoding="utf-8")
    if chosen.docs:
        DOCUMENT.write_text(document(rows, chosen.samples), encoding="utf-8")


if __name__ == "__main__":
    main()
