#  SPDX-License-Identifier: GPL-3.0-or-later
"""Messages to all viewers: to a few of them in each turn of the event loop, so
that an order, or its answer, never waits for all of them."""

import asyncio
from collections import deque

from .viewer import Viewer

PER_TURN = 2


class FanOut:
    def __init__(self) -> None:
        self._queue: deque[Viewer] = deque()
        self._filled = asyncio.Event()

    def add(self, viewer: Viewer) -> None:
        """It has queued messages."""
        if not viewer.queued:
            viewer.queued = True
            self._queue.append(viewer)
            self._filled.set()

    async def run(self) -> None:
        while True:
            await self._filled.wait()
            for _ in range(min(PER_TURN, len(self._queue))):
                viewer = self._queue.popleft()
                viewer.queued = False
                viewer.wake()
            if not self._queue:
                self._filled.clear()
            await asyncio.sleep(0)
