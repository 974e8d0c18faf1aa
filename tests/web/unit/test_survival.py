#  SPDX-License-Identifier: GPL-3.0-or-later
"""All attacks, twice in a row, on one gateway with its guard."""

import asyncio
import contextlib
import sys
from pathlib import Path
from typing import Any

import attacks
import pytest
from helpers import TOKENS, Page, Supervisor, token_file, until
from parties import fact

MOST_MEMORY = 100_000
#  kB of the gateway, at any time

MODULE_LIMIT = 1800.0

Times = list[float]


@pytest.fixture
def tokens(tmp_path: Path) -> list[str]:
    teachers, viewers = (token_file(tmp_path, token) for token in TOKENS.values())
    return [
        *("--token", teachers, "--viewers-token", viewers),
        *("--origin", attacks.ORIGIN),
    ]


async def watch(page: Page) -> None:
    """Until it is closed."""
    with contextlib.suppress(ConnectionError):
        while await page.receive() is not None:
            page.said.clear()
            page._new.clear()


async def silence(supervisor: Supervisor, g: attacks.Gateway) -> None:
    """Twelve pupils stop a hundred times, the supervisor says nothing for 5 s."""
    connections = supervisor.connections
    supervisor.answers["RSTP"] = None
    pages = [await g.pupil() for _ in range(12)]
    for page in pages:
        for number in range(99):
            await page.say("order", id=number, label="RSTP")
    await pages[-1].event("unanswered")
    supervisor.answers["RSTP"] = b"AACK"
    for number in range(99):
        await pages[-1].expect("answer", id=number, answer="NOLINK")
    await until(lambda: supervisor.connections > connections)
    await pages[-1].event("supervisor_connected")


async def drive(page: Page, times: Times) -> None:
    loop = asyncio.get_running_loop()

    async def ping() -> None:
        while True:
            await page.say("ping", n=0, hidden=False)
            await page.wheel("take")
            await asyncio.sleep(0.1)

    pinging = asyncio.create_task(ping())
    try:
        while True:
            begun = loop.time()
            if (await page.order("RGFW"))["answer"] == "AACK":
                times.append(loop.time() - begun)
            page.said.clear()
            page._new.clear()
            await asyncio.sleep(0.02)
    finally:
        pinging.cancel()


async def survive(programs: Any, tokens: list[str], planted: str = "") -> Times:
    """How long the driver's orders took meanwhile, in seconds."""
    supervisor = Supervisor()
    await supervisor.start()
    there = f"127.0.0.1:{supervisor.port}"
    program = programs("--port", "0", "--supervisor", there, *tokens, planted=planted)
    g = attacks.Gateway(program.port())
    gateway = program.gateway()
    times: Times = []
    for _ in range(2):
        await silence(supervisor, g)
        driver, quiet = await g.teacher(), await g.pupil()
        watching = asyncio.create_task(watch(quiet))
        driving = asyncio.create_task(drive(driver, times))
        assert await attacked(g) == 0
        assert not watching.done() and not driving.done()
        for task in (watching, driving):
            task.cancel()
        await g.end()
    assert program.process.poll() is None
    assert program.gateway() == gateway
    assert 0 < fact(gateway, "VmHWM") < MOST_MEMORY
    await supervisor.stop()
    supervisor.forget()
    return times


async def attacked(g: attacks.Gateway) -> int:
    """By another process, whose status this is."""
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, attacks.__file__, str(g.port)),
        env={"PYTHONPATH": ":".join(filter(None, sys.path))},
    )
    try:
        return await process.wait()
    finally:
        if process.returncode is None:
            process.kill()


async def test_survival(programs: Any, tokens: list[str]) -> None:
    #  a busy machine is no hang
    assert await survive(programs, tokens, "guard.PATIENCE = 600")


@pytest.mark.timed
async def test_orders_meanwhile(programs: Any, tokens: list[str]) -> None:
    times = sorted(await survive(programs, tokens))
    assert times[int(len(times) * 0.99)] < 0.1
