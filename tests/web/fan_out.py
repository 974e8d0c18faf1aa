#  SPDX-License-Identifier: GPL-3.0-or-later
"""How long an order takes to its answer: from a program that is connected to
the supervisor itself, and from a page through the gateway while others watch.

usage: fan_out.py [--bin FOLDER] [--orders N] [--viewers N,N,...]

Starts supervisor and emulator from FOLDER (bin), 10 images a second. A line
for each number of viewers; all of them, but not the page that drives, are in a
process of their own. RSTP goes to the robot and back, at 9600 baud; CPST the
supervisor answers by itself."""

import argparse
import asyncio
import contextlib
import json
import os
import random
import re
import signal
import statistics
import subprocess
import sys
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from pathlib import Path
from typing import Any

import aiohttp

ROOT = Path(__file__).resolve().parents[2]
LABELS = ("RSTP", "CPST")
PAUSES = (0.02, 0.06)
#  Seconds between an answer and the next order, at random: no rhythm is to
#  meet that of the images

LIMIT = 20.0

Ask = Callable[[str], Awaitable[None]]


class Programs:
    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._made: list[subprocess.Popen[str]] = []

    def start(self, *command: str, found: str, **more: Any) -> str:
        """What the program says that matches."""
        process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            **more,
        )
        self._made.append(process)
        assert process.stdout is not None
        for line in process.stdout:
            if match := re.search(found, line):
                return match[1]
        raise RuntimeError(f"{command[0]} has ended")

    def stop(self) -> None:
        """What they said is shown, where something has gone wrong."""
        for process in reversed(self._made):
            process.send_signal(signal.SIGTERM)
            with contextlib.suppress(subprocess.TimeoutExpired):
                said, _ = process.communicate(timeout=LIMIT)
                if sys.exc_info()[0] is not None:
                    print(said, file=sys.stderr)

    def supervisor(self) -> int:
        """Its port."""
        emulator = str(self._folder / "destijl_emulator")
        robot = self.start(emulator, "--boot-ms", "0", found=r"^device (.*)")
        camera = self.start(emulator, "--camera-port", "0", found=r"^camera (.*)")
        return int(
            self.start(
                str(self._folder / "destijl"),
                *("--port", "0", "--bind", "127.0.0.1", "--fps", "10"),
                *("--serial", robot, "--camera", camera),
                found=r"listening on .*:(\d+)",
            )
        )

    def gateway_time(self) -> float:
        """Seconds of processor that the gateway has had, without its guard."""
        guard = self._made[-1].pid
        (child,) = Path(f"/proc/{guard}/task/{guard}/children").read_text().split()
        fields = Path(f"/proc/{child}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def gateway(self, supervisor: int) -> int:
        """Its port."""
        return int(
            self.start(
                *(sys.executable, "-m", "destijl_web", "--port", "0"),
                *("--supervisor", f"127.0.0.1:{supervisor}"),
                found=r"open http://.*:(\d+)/",
                env={**os.environ, "PYTHONPATH": str(ROOT / "monitor" / "web")},
            )
        )


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


async def watch(port: int, count: int) -> None:
    """Viewers, until the input ends. Prints how many images a second each had."""
    images = [0] * count
    loop = asyncio.get_running_loop()
    async with aiohttp.ClientSession(connector=aiohttp.TCPConnector(limit=0)) as client:

        async def view(number: int) -> None:
            page = await connect(client, port)
            async for message in page:
                if message.type is aiohttp.WSMsgType.BINARY:
                    images[number] += 1
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
async def watched(port: int, count: int, rates: list[float]) -> AsyncIterator[None]:
    """Rates: afterwards, the images a second that each viewer had."""
    if count == 0:
        yield
        return
    watching = await asyncio.create_subprocess_exec(
        *(sys.executable, __file__, "watch", str(port), str(count)),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
    )
    assert watching.stdout is not None
    if not await watching.stdout.readline():
        raise RuntimeError("the viewers have ended")
    yield
    out, _ = await watching.communicate(b"")
    rates += json.loads(out)


async def measure(ask: Ask, count: int) -> dict[str, list[float]]:
    """Milliseconds."""
    samples: dict[str, list[float]] = {label: [] for label in LABELS}
    for number in range(count):
        label = LABELS[number % len(LABELS)]
        await asyncio.sleep(random.uniform(*PAUSES))
        begun = time.perf_counter()
        await ask(label)
        samples[label].append((time.perf_counter() - begun) * 1000)
    return samples


async def prepare(ask: Ask) -> None:
    await ask("ROPN")
    await asyncio.sleep(1.0)
    for label in ("RSOW", "COPN"):
        await ask(label)
    await asyncio.sleep(1.0)


def report(name: str, samples: dict[str, list[float]], more: str) -> None:
    figures = "  ".join(
        f"{label} median {statistics.median(values):6.2f}"
        f" p99 {sorted(values)[int(len(values) * 0.99)]:6.2f}"
        f" max {max(values):6.2f} ms"
        for label, values in samples.items()
    )
    print(f"{name:12}{figures}{more}", flush=True)


async def run(folder: Path, orders: int, viewers: list[int]) -> None:
    programs = Programs(folder)
    try:
        port = programs.supervisor()
        async with direct(port) as ask:
            await prepare(ask)
            report("direct", await measure(ask, orders), "")
        await asyncio.sleep(1.0)
        port = programs.gateway(port)
        await asyncio.sleep(1.0)
        async with through(port) as ask:
            await prepare(ask)
            for count in viewers:
                rates: list[float] = []
                async with watched(port, count, rates):
                    used, begun = programs.gateway_time(), time.monotonic()
                    samples = await measure(ask, orders)
                    used = programs.gateway_time() - used
                    load = used / (time.monotonic() - begun) * 100
                more = f"  {load:.0f} % of a processor"
                if rates:
                    more += f", {min(rates):.1f} images/s"
                report(f"{count} viewers", samples, more)
    finally:
        programs.stop()


def main() -> None:
    if sys.argv[1:2] == ["watch"]:
        asyncio.run(watch(int(sys.argv[2]), int(sys.argv[3])))
        return
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, default=ROOT / "bin")
    parser.add_argument("--orders", type=int, default=1000)
    parser.add_argument("--viewers", default="0,10,50")
    chosen = parser.parse_args()
    viewers = [int(count) for count in chosen.viewers.split(",")]
    asyncio.run(run(chosen.bin, chosen.orders, viewers))


if __name__ == "__main__":
    main()
