#  SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes of README.md, by the real proxies, where they are installed."""

import asyncio
import contextlib
import os
import re
import shutil
import socket
import ssl
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
from destijl_web import logins
from helpers import LIMIT, TOKENS, UPGRADE, WEB, World, world

NAME = "robot.example"


def recipe(beginning: str) -> str:
    found = re.search(
        rf"^    {re.escape(beginning)} \{{\n.*?^    \}}\n",
        (WEB / "README.md").read_text(),
        re.MULTILINE | re.DOTALL,
    )
    assert found is not None
    return found[0]


def nginx(folder: Path, port: int, gateway: int) -> tuple[str, list[str]]:
    text = recipe("server")
    for a, b in (
        ("listen 443 ssl", f"listen 127.0.0.1:{port} ssl"),
        ("127.0.0.1:8080", f"127.0.0.1:{gateway}"),
        ("/etc/ssl/certs/robot.pem", f"{folder}/robot.pem"),
        ("/etc/ssl/private/robot.key", f"{folder}/robot.key"),
    ):
        assert text.count(a) == 1
        text = text.replace(a, b)
    kinds = ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
    places = "".join(f"{kind}_temp_path {folder}/{kind};\n" for kind in kinds)
    return (
        f"daemon off; master_process off; pid {folder}/pid;\nevents {{ }}\n"
        f"http {{\naccess_log off;\n{places}{text}}}\n",
        ["nginx", "-p", str(folder), "-e", "stderr", "-c"],
    )


def caddy(folder: Path, port: int, gateway: int) -> tuple[str, list[str]]:
    text = recipe(NAME)
    for a, b in (
        (f"{NAME} {{", f"https://{NAME}:{port} {{\nbind 127.0.0.1\ntls internal"),
        ("127.0.0.1:8080", f"127.0.0.1:{gateway}"),
    ):
        assert text.count(a) == 1
        text = text.replace(a, b)
    own = f"admin off\nauto_https disable_redirects\nstorage file_system {folder}"
    return (
        f"{{\n{own}\nskip_install_trust\n}}\n{text}",
        ["caddy", "run", "--adapter", "caddyfile", "--config"],
    )


class Proxied:
    def __init__(self, w: World, port: int) -> None:
        self.w = w
        self.port = port

    async def ask(
        self, what: str, *lines: str, body: str = "", until: str = "", ip: str = ""
    ) -> str:
        """What it answers, until it closes or that has come."""
        context = ssl.create_default_context()
        context.check_hostname = False
        context.verify_mode = ssl.CERT_NONE
        reader, writer = await asyncio.open_connection(
            *("127.0.0.1", self.port),
            ssl=context,
            server_hostname=NAME,
            local_addr=(ip, 0) if ip else None,
        )
        head = [f"{what} HTTP/1.1", f"Host: {NAME}", f"Content-Length: {len(body)}"]
        if not until:
            head.append("Connection: close")
        writer.write(("\r\n".join([*head, *lines]) + "\r\n\r\n" + body).encode())
        heard = b""
        async with asyncio.timeout(LIMIT):
            while not until or until.encode() not in heard:
                piece = await reader.read(65536)
                if not piece:
                    break
                heard += piece
        writer.close()
        return heard.decode("latin-1")

    async def log_in(self, token: str, *lines: str, ip: str = "") -> str:
        form = "Content-Type: application/x-www-form-urlencoded"
        origin = f"Origin: https://{NAME}"
        body = f"token={token}"
        return await self.ask("POST /login", form, origin, *lines, body=body, ip=ip)


async def is_listening(port: int) -> None:
    async with asyncio.timeout(LIMIT):
        while True:
            with contextlib.suppress(ConnectionError):
                _, writer = await asyncio.open_connection("127.0.0.1", port)
                writer.close()
                return
            await asyncio.sleep(0.05)


@contextlib.asynccontextmanager
async def proxied(kind: str, folder: Path) -> AsyncIterator[Proxied]:
    """The gateway behind that proxy."""
    with socket.socket() as bound:
        #  for the whole test: nobody else is given its port
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        bound.bind(("127.0.0.1", 0))
        port = bound.getsockname()[1]
        async with world(**TOKENS, origins=(f"https://{NAME}",)) as w:
            text, command = {"nginx": nginx, "caddy": caddy}[kind](
                folder, port, w.service.port
            )
            (folder / "config").write_text(text)
            places = dict.fromkeys(("HOME", "XDG_DATA_HOME"), str(folder))
            process = await asyncio.create_subprocess_exec(
                *command, folder / "config", env=os.environ | places
            )
            try:
                await is_listening(port)
                yield Proxied(w, port)
            finally:
                process.terminate()
                await process.wait()


async def certificate(folder: Path) -> None:
    kind = ("-x509", "-nodes", "-newkey", "rsa:2048", "-subj", f"/CN={NAME}")
    files = ("-out", folder / "robot.pem", "-keyout", folder / "robot.key")
    process = await asyncio.create_subprocess_exec(
        *("openssl", "req", *kind, *files), stderr=asyncio.subprocess.DEVNULL
    )
    assert await process.wait() == 0


@pytest.mark.usefixtures("no_recovery")
@pytest.mark.parametrize("kind", ["nginx", "caddy"])
async def test_recipes(
    kind: str, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    if shutil.which(kind) is None or shutil.which("openssl") is None:
        pytest.skip(f"{kind}, or openssl, is not installed")
    await certificate(tmp_path)
    async with proxied(kind, tmp_path) as p:
        assert 'action="/login"' in await p.ask("GET /")
        answer = await p.log_in(TOKENS["token"])
        found = re.search(r"^Set-Cookie: ([^;]+);(.*)", answer, re.MULTILINE)
        assert found is not None and "Secure" in found[2]
        upgrade = (f"Cookie: {found[1]}", *UPGRADE)
        origin = f"Origin: https://{NAME}"
        answer = await p.ask("GET /ws", origin, *upgrade, until='"welcome"')
        assert " 101 " in answer and '"role":"teacher"' in answer
        for other in ("https://evil.example", f"http://{NAME}"):
            answer = await p.ask("GET /ws", f"Origin: {other}", *upgrade, until="\r\n")
            assert answer.startswith("HTTP/1.1 403 ")
        #  who forges his address gains nothing, and harms nobody else
        for number in range(logins.ATTEMPTS + 1):
            forged = f"X-Forwarded-For: 192.0.2.{number}"
            answer = await p.log_in("wrong", forged, forged)
        assert "/?failed=wait" in answer
        assert "192.0.2" not in caplog.text
        assert "/?failed=1" in await p.log_in("wrong", ip="127.0.0.2")
        assert "Set-Cookie" in await p.log_in(TOKENS["token"])
