#  SPDX-License-Identifier: GPL-3.0-or-later
"""One page: the messages queued for it, bounded even if it is slow."""

import asyncio
import contextlib
import socket
from collections import deque
from collections.abc import Callable

from aiohttp import WSCloseCode, web

from .logins import Session

IMAGES_UNDER_WAY = 2
STATES_WAITING = 32
#  Above, changes of the state are dropped, and the whole state is sent later

PONGS_WAITING = 8
#  The latest only

TEXTS_WAITING = 512
#  Above, the connection is closed

KERNEL_BUFFER = 2**17
#  Bytes; Linux doubles it. The default would be megabytes, and a stalled page
#  would not be detected

DRAIN_LIMIT = 10.0
#  Seconds within which something must have been sent to the page

FAREWELL = 1.0
#  Seconds for a page that is closed for what it said to read why


class Viewer:
    def __init__(
        self,
        number: int,
        session: Session,
        ws: web.WebSocketResponse,
        transport: asyncio.Transport,
    ) -> None:
        self.number = number
        self.session = session
        self.name = f"#{number}"
        self.pinged_at = 0.0
        self.orders_waiting = 0
        self.queued = False
        #  In the fan-out's queue
        self.state_is_stale = False
        #  The whole state is to be sent, once the queue has drained
        self._ws = ws
        self.transport = transport
        connection: socket.socket = transport.get_extra_info("socket")
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, KERNEL_BUFFER)
        self._wake = asyncio.Event()
        self._texts: deque[str] = deque()
        self._pongs: deque[str] = deque(maxlen=PONGS_WAITING)
        self._echo: bytes | None = None
        self._position: str | None = None
        self._image: bytes | None = None
        self._unseen = 0
        self._drained_at = asyncio.get_running_loop().time()
        self._closing: tuple[int, str] | None = None

    #  Received from the page

    def seen(self) -> None:
        self._unseen = max(0, self._unseen - 1)
        if self._image is not None:
            self.wake()

    #  To the page. Queued messages are sent after the next wake

    def put(self, text: str) -> None:
        if len(self._texts) >= TEXTS_WAITING:
            self.close(WSCloseCode.TRY_AGAIN_LATER, "too slow")
        else:
            self._texts.append(text)

    def put_state(self, text: str) -> None:
        if len(self._texts) >= STATES_WAITING:
            self.state_is_stale = True
        elif not self.state_is_stale:
            self._texts.append(text)

    def put_pong(self, text: str) -> None:
        self._pongs.append(text)

    def put_echo(self, data: bytes) -> None:
        """The answer to a frame that is a ping."""
        self._echo = data
        self.wake()

    def put_position(self, text: str) -> None:
        self._position = text

    def put_image(self, image: bytes) -> None:
        self._image = image

    def forget_image(self) -> None:
        self._image = None

    def wake(self) -> None:
        self._wake.set()

    def close(self, code: int, reason: str) -> None:
        """Once; drops the queue."""
        if self._closing is None:
            self._closing = (code, reason)
            if code == WSCloseCode.POLICY_VIOLATION:
                self.transport.pause_reading()
            self.wake()

    def is_stuck(self, now: float) -> bool:
        """Nothing was sent to it for DRAIN_LIMIT."""
        if self.transport.is_closing() and self._closing is None:
            return False
        if self.transport.get_write_buffer_size() == 0:
            self._drained_at = now
        return now - self._drained_at > DRAIN_LIMIT

    def abort(self) -> None:
        self.transport.abort()

    async def send(self, whole_state: Callable[[], str]) -> None:
        """Sends the queue, until the connection ends."""
        with contextlib.suppress(ConnectionError):
            while self._closing is None and not self._ws.closed:
                await self._wake.wait()
                self._wake.clear()
                await self._send_all(whole_state)
        if self._closing is not None and not self._ws.closed:
            code, reason = self._closing
            limit = FAREWELL if code == WSCloseCode.POLICY_VIOLATION else DRAIN_LIMIT
            with contextlib.suppress(ConnectionError, TimeoutError):
                await asyncio.wait_for(
                    self._ws.close(code=code, message=reason.encode()), limit
                )
            self.abort()

    async def _send_all(self, whole_state: Callable[[], str]) -> None:
        while self._closing is None and not self._ws.closed:
            #  The most urgent first
            if self._echo is not None:
                data, self._echo = self._echo, None
                await self._ws.pong(data)
            elif self._pongs:
                await self._ws.send_str(self._pongs.popleft())
            elif self._texts:
                await self._ws.send_str(self._texts.popleft())
            elif self.state_is_stale:
                self.state_is_stale = False
                await self._ws.send_str(whole_state())
            elif self._image is not None and self._unseen < IMAGES_UNDER_WAY:
                image, self._image = self._image, None
                self._unseen += 1
                await self._ws.send_bytes(image)
            elif self._position is not None:
                text, self._position = self._position, None
                await self._ws.send_str(text)
            else:
                return
