#  SPDX-License-Identifier: GPL-3.0-or-later
"""The connection to the supervisor: reconnects when lost, sends orders at
once, receives lines."""

import asyncio
import contextlib
import functools
import logging
import socket
from typing import Protocol

from . import peers
from .exchange import STOPS, Command, Exchange

MAX_LINE = 8 * 2**20
#  Bytes: base64 of an image of 6 MB

CONNECT_LIMIT = 5.0
FIRST_PAUSE = 0.2
LONGEST_PAUSE = 2.0
FAREWELL = 1.0
#  Seconds; the last one: for the supervisor to close its side

LIFE = 0.1
#  Seconds between two signs of life, or a tick of the hub more. Without one for
#  0.8 s the supervisor stops the robot: a stand-still of 0.65 s is survived, and
#  the loss of a packet noticed by the next one

TOO_MANY = 200
#  Commands that may wait; the supervisor's limit is 256. Above, only stops are
#  sent, and only a few in succession

ENOUGH_STOPS = 4

_UNSOLICITED = (b"CIMG:", b"CPOS:", b"RBLV:", b"MSSG:", b"MPRG:", b"MEND:")

_TCP_USER_TIMEOUT = 18
#  Linux only

_log = logging.getLogger(__name__)


class Listener(Protocol):
    """Receives the events of the link. Its functions must not wait."""

    def link_began(self) -> None:
        """The supervisor has admitted us as its monitor."""

    def link_refused(self, reason: str) -> None: ...

    def link_failed(self) -> None:
        """No supervisor answers there."""

    def link_ended(self, reason: str) -> None:
        """After link_began."""

    def settled(self, command: Command, answer: str, took: float, line: bytes) -> None:
        """Line answers command, or, empty, command is one that has no answer."""

    def unasked(self, line: bytes) -> None: ...

    def unanswered(self, command: Command) -> None:
        """The connection ends for this reason."""


class Link:
    def __init__(
        self, host: str, port: int, token: str | None, listener: Listener
    ) -> None:
        self._host = host
        self._port = port
        self._token = token
        self._listener = listener
        self._session: _Session | None = None
        self._closing = False

    async def run(self) -> None:
        """Connects and connects again, until close."""
        pause = FIRST_PAUSE
        told = ""
        while not self._closing:
            session = _Session(self._listener, self._token)
            self._session = session
            try:
                await asyncio.wait_for(
                    asyncio.get_running_loop().create_connection(
                        functools.partial(_as_it_is, session),
                        self._host,
                        self._port,
                    ),
                    CONNECT_LIMIT,
                )
                with contextlib.suppress(OSError):  # it has ended
                    await session.begin()
                reason = await session.ended
            except OSError as error:
                reason = str(error) or "no answer"
            if session.began:
                pause = FIRST_PAUSE
                told = ""
                if not self._closing:
                    self._listener.link_ended(reason)
            elif session.refusal:
                pause = LONGEST_PAUSE
                if not self._closing and session.refusal != told:
                    told = session.refusal
                    self._listener.link_refused(told)
            elif reason != told:
                told = reason
                self._listener.link_failed()
                _log.warning(
                    "no supervisor at %s port %d: %s", self._host, self._port, reason
                )
            if not self._closing:
                await asyncio.sleep(pause)
                pause = min(2 * pause, LONGEST_PAUSE)

    def is_up(self) -> bool:
        return self._session is not None and self._session.is_up() and not self._closing

    def is_lost(self) -> bool:
        return not self.is_up() and not self._closing

    def waiting(self) -> int:
        return len(self._session.exchange) if self._session else 0

    def is_waiting(self, label: str) -> bool:
        return self._session is not None and self._session.exchange.is_waiting(label)

    def send(self, command: Command) -> None:
        """Is_up holds."""
        assert self._session is not None
        self._session.send(command)

    def watch(self) -> None:
        """To be called periodically: checks for late answers, shows that we live."""
        if self._session is not None and not self._closing:
            self._session.watch()

    async def close(self) -> None:
        self._closing = True
        if self._session is not None:
            await self._session.close()


class _Session(asyncio.Protocol):
    """One connection."""

    def __init__(self, listener: Listener, token: str | None) -> None:
        self.exchange = Exchange()
        self.began = False
        self.refusal = ""
        self.ended: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        self._listener = listener
        self._token = token
        self._loop = asyncio.get_running_loop()
        self._transport: asyncio.Transport | None = None
        self._parts: list[bytes] = []
        self._length = 0
        self._begun_at = 0.0
        self._lived_at = 0.0
        self._reason = "the supervisor closed it"
        self._position_wanted = False
        self._surprises = 0

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        made: socket.socket = transport.get_extra_info("socket")
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        made.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPIDLE, 1)
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPINTVL, 1)
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPCNT, 3)
        made.setsockopt(socket.IPPROTO_TCP, _TCP_USER_TIMEOUT, 4000)

    async def begin(self) -> None:
        if self._transport is None:
            return
        if self._token is not None:
            made: socket.socket = self._transport.get_extra_info("socket")
            if objection := await peers.objection(made):
                self._end(objection + "; it is not told the token")
                return
            self._transport.write(b"AUTH:" + self._token.encode("ascii") + b"\n")
        #  Answered AACK in every state, without effect in a new session: so we
        #  know that we are its monitor
        self.send(Command("CPST"))

    def data_received(self, data: bytes) -> None:
        now = self._loop.time()
        first = 0
        while (end := data.find(b"\n", first)) >= 0:
            if self._parts:
                self._parts.append(data[first:end])
                line = b"".join(self._parts)
                self._parts.clear()
                self._length = 0
            else:
                self._begun_at = now
                line = data[first:end]
            first = end + 1
            self._take(line.removesuffix(b"\r"), now)
        if first < len(data):
            if not self._parts:
                self._begun_at = now
            self._parts.append(data[first:])
            self._length += len(data) - first
            if self._length > MAX_LINE:
                self._end("a line of it has no end")

    def eof_received(self) -> None:
        self._end(self._reason)

    def connection_lost(self, error: Exception | None) -> None:
        if error is not None:
            self._reason = str(error)
        self._transport = None
        if not self.ended.done():
            self.ended.set_result(self._reason)
        for command in self.exchange.give_up():
            for done in command.done:
                done("NOLINK", 0.0)

    def is_up(self) -> bool:
        return (
            self.began
            and self._transport is not None
            and not self._transport.is_closing()
        )

    def send(self, command: Command) -> None:
        if self._transport is None:
            return
        now = self._loop.time()
        line = command.line()
        if command.label == "CASA":
            #  Before it, a command without effect: images in transit arrive
            #  before its answer, and are not taken for the arena's
            fence = Command("CPCO" if self._position_wanted else "CPST")
            self.exchange.sent(fence, now)
            line = fence.line() + line
        elif command.label in ("CPCO", "CPST"):
            self._position_wanted = command.label == "CPCO"
        elif command.label == "CCLS":
            self._position_wanted = False
        if command.label in STOPS and self.exchange.stops_at_end() >= ENOUGH_STOPS:
            #  answered by the same answer
            self.exchange.last().done += command.done
            return
        settled = self.exchange.sent(command, now)
        self._transport.write(line)
        for one in settled:
            self._listener.settled(one, "AACK", 0.0, b"")

    def watch(self) -> None:
        now = self._loop.time()
        late = self.exchange.overdue(now)
        if self.is_up() and now - self._lived_at >= LIFE:
            assert self._transport is not None
            self._lived_at = now
            self._transport.write(b"LIVE\n")
        if late is not None and self._transport is not None:
            if self.began:
                #  The next message might be its answer or the next one's
                self._listener.unanswered(late)
            self._end(f"no answer to {late.label}")

    async def close(self) -> None:
        if self._transport is not None:
            #  So that the last line still arrives: closing a socket with
            #  unread data resets the connection
            with contextlib.suppress(OSError):
                self._transport.write_eof()
            await asyncio.wait([self.ended], timeout=FAREWELL)
            if self._transport is not None:
                self._transport.abort()

    def _end(self, reason: str) -> None:
        self._reason = reason
        if self._transport is not None:
            self._transport.abort()

    def _take(self, line: bytes, now: float) -> None:
        if self._transport is None or self._transport.is_closing():
            return
        if not self.began:
            self._take_first(line, now)
            return
        settled = self.exchange.match(line, self._begun_at, now)
        for command in settled:
            if command.label in ("CACO", "CAIN"):
                self._listener.settled(command, "AACK", 0.0, b"")
            else:
                answer = (
                    "CIMG"
                    if line[:4] == b"CIMG"
                    else line[:64].decode("ascii", "replace")
                )
                took = (now - command.sent_at) * 1000
                self._listener.settled(command, answer, took, line)
        if settled:
            return
        if line == b"ATIM" or line[:5] in _UNSOLICITED:
            self._listener.unasked(line)
        else:
            self._surprises += 1
            if self._surprises <= 10:
                _log.warning("unexpected from the supervisor: %r", line[:64])

    def _take_first(self, line: bytes, now: float) -> None:
        if line.startswith(b"MSSG:refused: "):
            self.refusal = printable(line[14:])
            self._end(self.refusal)
        elif line == b"ACER" and self._token is not None:
            pass  # it asks for no token
        elif line == b"AACK":
            self.exchange.match(line, self._begun_at, now)
            self.began = True
            self._listener.link_began()
        else:
            self._end("it is no supervisor")


def _as_it_is(session: _Session) -> _Session:
    return session


def printable(data: bytes) -> str:
    """Text of the supervisor, in printable form."""
    text = data[:1024].decode("utf-8", "replace")
    return "".join(c if c.isprintable() else "?" for c in text)
