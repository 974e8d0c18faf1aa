#  SPDX-License-Identifier: GPL-3.0-or-later
"""The unit tests that are coroutines, and the gateway that they are given; the
option of the tests in the browser."""

import asyncio
import inspect
from collections.abc import Iterator
from typing import Any

import pytest
from destijl_web import logins
from helpers import TEST_LIMIT, Program, World, world


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--pictures",
        metavar="FOLDER",
        help="leave there the pictures of the documentation; needs pngquant and webp",
    )


@pytest.fixture(autouse=True)
def runner() -> Iterator[asyncio.Runner]:
    with asyncio.Runner() as runner:
        yield runner


@pytest.fixture
def w(runner: asyncio.Runner, request: pytest.FixtureRequest) -> Iterator[World]:
    """Other options than a gateway's usual ones: @pytest.mark.world (...)."""
    mark = request.node.get_closest_marker("world")
    made = world(**(dict(*mark.args, **mark.kwargs) if mark else {}))
    yield runner.run(made.__aenter__())
    runner.run(made.__aexit__(None, None, None))


@pytest.fixture
def programs() -> Iterator[Any]:
    made: list[Program] = []

    def make(*arguments: str, planted: str = "") -> Program:
        made.append(Program(*arguments, planted=planted))
        return made[-1]

    yield make
    for one in made:
        if one.process.poll() is None:
            one.process.kill()
            one.process.communicate()


@pytest.fixture
def no_recovery(monkeypatch: pytest.MonkeyPatch) -> None:
    """However long a test takes, none of its wrong tokens is forgotten."""
    monkeypatch.setattr(logins, "RECOVERY", 1e9)


def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    if not inspect.iscoroutinefunction(pyfuncitem.obj):
        return None
    given: dict[str, Any] = pyfuncitem.funcargs
    names = inspect.signature(pyfuncitem.obj).parameters

    async def limited() -> None:
        limit = getattr(pyfuncitem.module, "MODULE_LIMIT", TEST_LIMIT)
        async with asyncio.timeout(limit):
            await pyfuncitem.obj(**{name: given[name] for name in names})

    given["runner"].run(limited())
    return True
