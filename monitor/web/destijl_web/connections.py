#  SPDX-License-Identifier: GPL-3.0-or-later
"""Connections of browsers: one request each, of bounded size, or a WebSocket.
Nothing that somebody without a token sends is kept beyond that."""

import asyncio
import logging
from typing import Any, cast

from aiohttp import WSCloseCode, web
from aiohttp.http_exceptions import HttpProcessingError

from .logins import Budget
from .viewer import Viewer

MAX_REQUEST = 16384
MAX_LINES = 100
#  Bytes, with the body, and lines: what follows a request is not read either

READ = 4096
#  Bytes at once, so that no connection keeps the others waiting

MAX_PENDING = 400
#  Above, the oldest connections without a viewer are closed

_log = logging.getLogger(__name__)


class Connections:
    """Makes them."""

    def __init__(self, server: web.Server) -> None:
        self._server = server
        self._loop = asyncio.get_running_loop()
        self._told = Budget(1.0, 1.0)
        self.pending: dict[Connection, None] = {}

    def __call__(self) -> "Connection":
        return Connection(
            self,
            self._server,
            loop=self._loop,
            access_log=None,
            auto_decompress=False,
            read_bufsize=READ,
            lingering_time=1.0,
        )

    def add(self, connection: "Connection") -> None:
        self.pending[connection] = None
        if len(self.pending) > MAX_PENDING:
            oldest = next(iter(self.pending))
            del self.pending[oldest]
            oldest.abort()
            if self._told.take(self._loop.time()):
                _log.warning("too many connections: the oldest are closed")


class Connection(web.RequestHandler):
    def __init__(self, all_of_them: Connections, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._all = all_of_them
        self._bytes = 0
        self._lines = 0
        self._viewer: Viewer | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        #  an attribute of asyncio's transports, without a function
        cast(Any, transport).max_size = READ
        super().connection_made(transport)
        self._all.add(self)

    def connection_lost(self, error: BaseException | None) -> None:
        self._all.pending.pop(self, None)
        super().connection_lost(error)

    def data_received(self, data: bytes) -> None:
        viewer = self._viewer
        if viewer is not None:
            if not viewer.session.bytes.take(self._loop.time(), len(data)):
                viewer.close(WSCloseCode.POLICY_VIOLATION, "too many bytes")
                return
        else:
            self._bytes += len(data)
            self._lines += data.count(b"\n")
            if self._bytes > MAX_REQUEST or self._lines > MAX_LINES:
                self.abort()
                return
        super().data_received(data)

    def log_exception(self, *args: Any, **kwargs: Any) -> None:
        #  who sends what is no request does not fill the log
        if not isinstance(kwargs.get("exc_info"), HttpProcessingError):
            super().log_exception(*args, **kwargs)

    def belongs_to(self, viewer: Viewer) -> None:
        self._viewer = viewer
        self._all.pending.pop(self, None)

    def abort(self) -> None:
        if self.transport is not None:
            self.transport.abort()
