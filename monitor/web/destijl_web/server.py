#  SPDX-License-Identifier: GPL-3.0-or-later
"""The gateway itself: HTTP and WebSockets."""

import asyncio
import contextlib
import gc
import io
import logging
import re
import resource
import socket
import sys
from collections import Counter
from collections.abc import Awaitable, Callable, Iterator, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, quote

import segno
from aiohttp import WSCloseCode, WSMsgType, hdrs, web

from . import guard, messages
from .connections import Connection, Connections
from .hub import FOR_TEACHERS, MAX_PER_SESSION, MAX_VIEWERS, Hub
from .logins import Logins, Refused, Session, parsed
from .options import Options, is_loopback
from .origins import Origins, address_to_open
from .recordings import MAX_TITLE, Recordings, csv_pieces
from .viewer import Viewer

PAGE = Path(__file__).resolve().parent.parent / "page"

MAX_FORM = 4096
#  Bytes

BACKLOG = 128

HEARTBEAT = 20.0
#  Seconds between two WebSocket pings to a browser

FAREWELL = 1.0
#  Seconds

SWITCH = 0.0005
#  Seconds between thread switches: the event loop waits this long for a thread
#  that reads a recording

_TYPES = {
    ".html": "text/html",
    ".css": "text/css",
    ".js": "text/javascript",
    ".json": "application/json",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".ico": "image/x-icon",
    ".webmanifest": "application/manifest+json",
}
_PATH = re.compile(r"[A-Za-z0-9_-]+(?:\.[a-z]+)*(?:/[A-Za-z0-9_-]+(?:\.[a-z]+)*){0,3}")

_FRAMES = (WSMsgType.TEXT, WSMsgType.BINARY, WSMsgType.PING, WSMsgType.PONG)
_REFUSALS = {"1": "wrong token", "expelled": "its address was expelled"}

_log = logging.getLogger(__name__)

_Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


class CannotStart(Exception):
    """Its text is the reason."""


class _OneLine(logging.Formatter):
    def format(self, record: logging.LogRecord) -> str:
        text = f"destijl_web: {record.levelname.lower()}: {record.getMessage()}"
        if record.exc_info and record.exc_info[0]:
            text += f": {record.exc_info[0].__name__}: {record.exc_info[1]}"
        return text.replace("\n", " ")


def run(options: Options, heart: int) -> int:
    """Until a signal. Returns the exit status."""
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(_OneLine())
    logging.basicConfig(level=logging.INFO, handlers=[handler])
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    with contextlib.suppress(OSError, ValueError):
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(most, 4096), most))
    sys.setswitchinterval(SWITCH)
    try:
        return asyncio.run(_serve(options, heart))
    except CannotStart as reason:
        print(f"destijl_web: {reason}", file=sys.stderr)
        return 1


async def _serve(options: Options, heart: int) -> int:
    stop = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in guard.ENDS:
        loop.add_signal_handler(number, stop.set)
    service = Service(options)
    await service.start()
    print(f"destijl_web: open {service.address}", flush=True)
    #  Exclude the present objects from garbage collection
    gc.collect()
    gc.freeze()
    tasks = [
        asyncio.create_task(_beat(heart, service.hub)),
        asyncio.create_task(stop.wait()),
    ]
    failure = await service.failure(tasks)
    if failure is not None:
        _log.error("failure: %s: %s", type(failure).__name__, failure)
    await service.close()
    return 0 if failure is None else 3


class Service:
    """The gateway without its process."""

    def __init__(self, options: Options) -> None:
        self._options = options
        self._logins = Logins(options.token, options.viewers_token)
        self.hub = Hub(
            options.supervisor_host,
            options.supervisor_port,
            options.token,
            options.record,
            options.record_limit,
            self._logins,
        )
        self.port = 0
        self.address = ""
        self._runner: web.AppRunner | None = None
        self._listener: asyncio.Server | None = None
        self._tasks: list[asyncio.Task[None]] = []

    async def start(self) -> None:
        """Raises CannotStart."""
        listening = _listen(self._options.bind, self._options.port)
        self.port = listening.getsockname()[1]
        self.address = address_to_open(self._options.bind, self.port)
        origins = Origins(self._options.bind, self.port, self._options.origins)
        gateway = _Gateway(self._options, self.hub, self._logins, origins)
        self._runner = web.AppRunner(gateway.application())
        await self._runner.setup()
        assert self._runner.server is not None
        self._listener = await asyncio.get_running_loop().create_server(
            Connections(self._runner.server), sock=listening, backlog=BACKLOG
        )
        self._tasks = [
            asyncio.create_task(work)
            for work in (
                self.hub.run_ticks(),
                self.hub.fan_out.run(),
                self.hub.link.run(),
            )
        ]

    async def failure(
        self, further: Sequence[asyncio.Task[Any]]
    ) -> BaseException | None:
        """Waits until a task ends, of its own or a further one: how."""
        ended, _ = await asyncio.wait(
            [*self._tasks, *further], return_when=asyncio.FIRST_COMPLETED
        )
        return next((f for task in ended if (f := task.exception())), None)

    async def close(self) -> None:
        await self.hub.close()
        if self._listener is not None:
            self._listener.close()
        if self._runner is not None and self._runner.server is not None:
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(2 * FAREWELL):
                    await self._runner.server.shutdown(FAREWELL)
                    await self._runner.cleanup()
        for task in self._tasks:
            task.cancel()


def _listen(bind: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in bind else socket.AF_INET
    try:
        return socket.create_server((bind, port), family=family, backlog=BACKLOG)
    except OSError as error:
        raise CannotStart(
            f"cannot listen on {bind} port {port}: {error.strerror}"
        ) from None


async def _beat(heart: int, hub: Hub) -> None:
    wrong = 0
    while True:
        wrong = wrong + 1 if hub.believes_wrongly() else 0
        if wrong < guard.PATIENCE:
            guard.beat(heart)
        elif wrong == guard.PATIENCE:
            _log.error("says that it has a supervisor, and has none")
        await asyncio.sleep(guard.BEAT)


class _Gateway:
    def __init__(
        self, options: Options, hub: Hub, logins: Logins, origins: Origins
    ) -> None:
        self._hub = hub
        self._origins = origins
        self._logins = logins
        self._recordings = Recordings(options.record) if options.record else None
        self._sockets = Counter[str]()
        #  Of each role
        self._loop = asyncio.get_running_loop()

    def application(self) -> web.Application:
        application = web.Application(
            client_max_size=MAX_FORM, middlewares=[self._check]
        )
        application.on_response_prepare.append(self._protect)
        application.add_routes(
            [
                web.get("/", self._index),
                web.get("/page/{path:.+}", self._file),
                web.post("/login", self._login),
                web.post("/logout", self._logout),
                web.get("/join.svg", self._join),
                web.get("/ws", self._socket),
                web.get("/recordings", self._list),
                web.delete("/recordings/{name}", self._delete),
                web.put("/recordings/{name}/title", self._entitle),
                web.get("/recordings/{name}/positions.csv", self._positions),
                web.get(
                    "/recordings/{name}/{file:events\\.jsonl|images\\.mjpeg}",
                    self._part,
                ),
            ]
        )
        return application

    #  Every request

    @web.middleware
    async def _check(
        self, request: web.Request, handler: _Handler
    ) -> web.StreamResponse:
        local = "127.0.0.1"
        if request.transport is not None:
            name = request.transport.get_extra_info("sockname")
            local = str(name[0]) if name else local
        if not self._origins.is_host(request.headers.get(hdrs.HOST, ""), local):
            raise web.HTTPMisdirectedRequest(
                text="destijl_web is not reached under this name: see --origin\n"
            )
        return await handler(request)

    async def _protect(
        self, request: web.Request, response: web.StreamResponse
    ) -> None:
        host = request.headers.get(hdrs.HOST, "")
        #  Safari before 15.4 does not accept WebSockets for 'self'
        sockets = (
            f" ws://{host} wss://{host}" if re.fullmatch(r"[\w.:\[\]-]+", host) else ""
        )
        response.headers["Content-Security-Policy"] = (
            "default-src 'none'; script-src 'self'; style-src 'self';"
            f" img-src 'self' blob:; connect-src 'self'{sockets};"
            " manifest-src 'self'; base-uri 'none'; form-action 'self';"
            " frame-ancestors 'none'"
        )
        response.headers["X-Content-Type-Options"] = "nosniff"
        #  not no-referrer: the form's Origin would be null
        response.headers["Referrer-Policy"] = "same-origin"
        response.headers["Cross-Origin-Opener-Policy"] = "same-origin"
        response.headers["Cross-Origin-Resource-Policy"] = "same-origin"
        response.headers.setdefault("Cache-Control", "no-store")
        response.headers.pop("Server", None)
        if response.status != 101:
            response.force_close()
            response.headers[hdrs.CONNECTION] = "close"

    def _session(self, request: web.Request) -> Session | None:
        name = request.cookies.get(self._cookie(request))
        return self._logins.session(name, self._loop.time())

    def _cookie(self, request: web.Request) -> str:
        #  Cookies are shared among ports: each gateway of a machine has its
        #  own name
        return f"destijl_web_{self._origins.port}"

    def _address(self, request: web.Request) -> str:
        """The browser's address; a proxy on this machine is trusted."""
        address = request.remote or ""
        if self._origins.is_proxied() and is_loopback(address):
            #  the last one is the proxy's word, those before it the browser's
            told = request.headers.getall("X-Forwarded-For", [""])[-1]
            forwarded = parsed(told.rpartition(",")[2].strip())
            if forwarded is not None:
                address = str(forwarded)
        return address

    #  The page

    async def _index(self, request: web.Request) -> web.StreamResponse:
        return _page("index.html" if self._session(request) else "login.html")

    async def _file(self, request: web.Request) -> web.StreamResponse:
        #  without a cookie, too: the form needs the style sheet
        return _page(request.match_info["path"])

    async def _login(self, request: web.Request) -> web.StreamResponse:
        origin = request.headers.get(hdrs.ORIGIN)
        if origin is not None:
            self._check_own(request)
        address = self._address(request)
        form = parse_qs((await request.read()).decode("utf-8", "replace"))
        token = form.get("token", [""])[0].strip()
        try:
            session = self._logins.log_in(token, address, self._loop.time())
        except Refused as refused:
            if str(refused) != "wait":
                _log.warning("login refused, %s: %s", _REFUSALS[str(refused)], address)
            raise web.HTTPSeeOther(f"/?failed={refused}") from None
        response = web.Response(status=303, headers={"Location": "/"})
        response.set_cookie(
            self._cookie(request),
            session,
            path="/",
            httponly=True,
            samesite="Strict",
            secure=self._origins.is_secure(
                origin or "", request.headers.get(hdrs.HOST, "")
            ),
        )
        return response

    async def _logout(self, request: web.Request) -> web.StreamResponse:
        self._check_own(request)
        self._logins.log_out(request.cookies.get(self._cookie(request)))
        response = web.Response(status=303, headers={"Location": "/"})
        response.del_cookie(self._cookie(request), path="/")
        return response

    def _check_own(self, request: web.Request) -> None:
        if not self._origins.is_origin(
            request.headers.get(hdrs.ORIGIN, ""), request.headers.get(hdrs.HOST, "")
        ):
            raise web.HTTPForbidden(text="this page is not destijl_web's\n")

    async def _join(self, request: web.Request) -> web.StreamResponse:
        """The address for the pupils; their token is for the form's script alone."""
        if self._entitled(request).role != "teacher":
            raise web.HTTPForbidden(text="this is for the teacher\n")
        address = self._origins.for_others(request.headers.get(hdrs.HOST, ""))
        token = self._logins.viewers_token
        if token is not None and "token" in request.query:
            address += "#token=" + quote(token, safe="")
        svg = io.BytesIO()
        segno.make_qr(address).save(
            svg, kind="svg", title=address, light="white", omitsize=True
        )
        return web.Response(body=svg.getvalue(), content_type=_TYPES[".svg"])

    #  Viewers

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        #  Without this header a page that was refused asks why: scripts do not see
        #  the answer to a WebSocket
        asked = hdrs.UPGRADE not in request.headers
        if not asked:
            self._check_own(request)
        session = self._entitled(request)
        role = session.role
        if session.sockets >= MAX_PER_SESSION:
            raise web.HTTPServiceUnavailable(text="too many pages of this session\n")
        if self._sockets.total() >= MAX_VIEWERS or (
            role == "viewer" and self._sockets[role] >= MAX_VIEWERS - FOR_TEACHERS
        ):
            raise web.HTTPServiceUnavailable(text="too many viewers\n")
        if asked:
            raise web.HTTPUpgradeRequired(text="this is for WebSockets\n")
        if not self._hub.may_wish(session):
            raise web.HTTPTooManyRequests(text="too often\n")
        self._sockets[role] += 1
        session.sockets += 1
        try:
            return await self._serve_viewer(request, session)
        finally:
            self._sockets[role] -= 1
            session.sockets -= 1

    async def _serve_viewer(
        self, request: web.Request, session: Session
    ) -> web.StreamResponse:
        #  pings are answered, and counted, as all else
        ws = web.WebSocketResponse(
            autoping=False,
            compress=False,
            heartbeat=HEARTBEAT,
            max_msg_size=4 * messages.MAX_SIZE,
        )
        await ws.prepare(request)
        transport, connection = request.transport, request.protocol
        assert isinstance(transport, asyncio.Transport)
        assert isinstance(connection, Connection)
        viewer = Viewer(self._hub.next_number(), session, ws, transport)
        connection.belongs_to(viewer)
        sender = asyncio.create_task(viewer.send(self._hub.whole_state))
        self._hub.join(viewer)
        try:
            await self._listen_to(viewer, ws)
        finally:
            self._hub.leave(viewer)
            viewer.close(WSCloseCode.OK, "")
        await sender
        return ws

    async def _listen_to(self, viewer: Viewer, ws: web.WebSocketResponse) -> None:
        while True:
            received = await ws.receive()
            if received.type not in _FRAMES:
                return
            if not viewer.session.frames.take(self._loop.time()):
                reason = "too many messages"
            elif received.type is WSMsgType.PING:
                viewer.put_echo(received.data)
                continue
            elif received.type is WSMsgType.PONG:
                continue
            elif received.type is WSMsgType.BINARY:
                reason = "binary"
            elif len(received.data.encode()) > messages.MAX_SIZE:
                reason = "too large"
            else:
                try:
                    self._hub.take(viewer, messages.read(received.data))
                    continue
                except messages.Malformed as fault:
                    reason = str(fault)
            _log.warning("viewer %d refused: %s", viewer.number, reason)
            viewer.close(WSCloseCode.POLICY_VIOLATION, reason)
            return

    #  Recordings

    def _entitled(self, request: web.Request) -> Session:
        session = self._session(request)
        if session is None:
            raise web.HTTPUnauthorized(text="a token is needed\n")
        return session

    def _kept(self, request: web.Request) -> Recordings:
        self._entitled(request)
        if self._recordings is None:
            raise web.HTTPNotFound(text="nothing is recorded: see --record\n")
        return self._recordings

    def _changed(self, request: web.Request) -> Recordings:
        """By a page of our own, and who may take the wheel."""
        self._check_own(request)
        kept = self._kept(request)
        if self._entitled(request).role == "viewer":
            raise web.HTTPForbidden(text="this is for the teacher\n")
        return kept

    async def _delete(self, request: web.Request) -> web.StreamResponse:
        kept = self._changed(request)
        name = request.match_info["name"]
        if name == self._hub.state["recording"]:
            raise web.HTTPConflict(text="it is being written\n")
        if not await asyncio.to_thread(kept.delete, name):
            raise web.HTTPNotFound(text="no such recording\n")
        return web.Response(status=204)

    async def _entitle(self, request: web.Request) -> web.StreamResponse:
        kept = self._changed(request)
        title = (await request.text()).strip()
        if len(title) > MAX_TITLE or not title.isprintable():
            raise web.HTTPBadRequest(text="not a name\n")
        name = request.match_info["name"]
        if not await asyncio.to_thread(kept.entitle, name, title):
            raise web.HTTPNotFound(text="no such recording\n")
        return web.Response(status=204)

    async def _list(self, request: web.Request) -> web.StreamResponse:
        kept = self._kept(request)
        return web.json_response(await asyncio.to_thread(kept.all))

    async def _events(self, request: web.Request, which: str) -> Path:
        kept = self._kept(request)
        path = await asyncio.to_thread(kept.file, request.match_info["name"], which)
        if path is None:
            raise web.HTTPNotFound(text="no such recording\n")
        return path

    async def _part(self, request: web.Request) -> web.StreamResponse:
        which = request.match_info["file"]
        path = await self._events(request, which)
        kind = (
            "application/x-ndjson" if which == "events.jsonl" else "video/x-motion-jpeg"
        )
        return web.FileResponse(path, headers={"Content-Type": kind})

    async def _positions(self, request: web.Request) -> web.StreamResponse:
        path = await self._events(request, "events.jsonl")
        name = f"destijl-{request.match_info['name']}.csv"
        response = web.StreamResponse(
            headers={
                "Content-Type": "text/csv; charset=utf-8",
                "Content-Disposition": f'attachment; filename="{name}"',
            }
        )
        await response.prepare(request)
        pieces = csv_pieces(path)
        while piece := await asyncio.to_thread(_next, pieces):
            await response.write(piece.encode())
        await response.write_eof()
        return response


def _next(pieces: Iterator[str]) -> str:
    return next(pieces, "")


def _page(name: str) -> web.StreamResponse:
    kind = _TYPES.get(Path(name).suffix)
    path = PAGE / name
    if (
        kind is None
        or _PATH.fullmatch(name) is None
        or not path.is_file()
        or path.resolve() != path
    ):
        raise web.HTTPNotFound(text="no such page\n")
    #  revalidated each time, and not sent again if unchanged
    headers: dict[str, str] = {"Content-Type": kind, "Cache-Control": "no-cache"}
    return web.FileResponse(path, headers=headers)
