#  SPDX-License-Identifier: GPL-3.0-or-later
"""The options of the program."""

import enum
import ipaddress
import re
import stat
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlsplit

HELP = """\
Usage: destijl_web [OPTION ...]
Shows the arena in browsers and lets one of them drive the robot.

  --supervisor HOST:PORT  where the supervisor runs (127.0.0.1:5544)
  --bind ADDRESS          address to listen on (127.0.0.1); any but this
                          machine's own 127.0.0.1 needs --token
  --port N                port of the browsers (8080; 0: a free one)
  --token FILE            the token of those who may take the wheel from
                          anybody, in the first line of FILE; also shown
                          to the supervisor
  --viewers-token FILE    the token of all others
  --record FOLDER         record every session in a new folder of FOLDER
  --record-limit MB       of all recordings in FOLDER (10000): above it,
                          the oldest without a name are deleted
  --origin URL            a further address under which browsers reach
                          it, as https://robot.example; up to 8 times
  --version, --help

Exit status: 0 after an orderly stop, 1 where the gateway cannot
start, 2 for bad usage, 3 after an internal failure or a hang.
The address to open is printed once browsers can connect.
"""

MAX_ORIGINS = 8

MIN_TOKEN = 16
#  Characters; what protects it from being guessed


class Usage(Exception):
    """Bad usage; its text is the reason."""


class Wish(enum.Enum):
    """A request other than to run."""

    HELP = enum.auto()
    VERSION = enum.auto()


@dataclass
class Options:
    supervisor_host: str = "127.0.0.1"
    supervisor_port: int = 5544
    bind: str = "127.0.0.1"
    port: int = 8080
    token: str | None = None
    viewers_token: str | None = None
    record: Path | None = None
    record_limit: int = 10_000 * 10**6
    origins: tuple[str, ...] = ()


def read(arguments: Sequence[str]) -> Options | Wish:
    """Raises Usage."""
    values = Options()
    rest = list(arguments)
    while rest:
        name, equals, value = rest.pop(0).partition("=")
        if name in ("--help", "-h") and not equals:
            return Wish.HELP
        if name == "--version" and not equals:
            return Wish.VERSION
        if name not in _TAKERS:
            raise Usage(f'unknown argument: "{name}{equals}{value}"; see --help')
        if not equals:
            if not rest:
                raise Usage(f"{name} wants a value")
            value = rest.pop(0)
        if not value:
            raise Usage(f"{name} wants a value")
        _TAKERS[name](values, value)
    _check(values)
    return values


def is_loopback(host: str) -> bool:
    if host == "localhost" or host.endswith(".localhost"):
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _check(values: Options) -> None:
    if values.token is None:
        if not is_loopback(values.bind):
            raise Usage(
                f"--bind {values.bind} lets other machines in: it needs --token FILE"
            )
        for origin in values.origins:
            if not is_loopback(urlsplit(origin).hostname or ""):
                raise Usage(
                    f"--origin {origin} lets other machines in: it needs --token FILE"
                )
        if values.viewers_token is not None:
            raise Usage("--viewers-token needs --token: who takes the wheel otherwise?")
    elif values.token == values.viewers_token:
        raise Usage("--token and --viewers-token have the same token")


def _take_supervisor(values: Options, given: str) -> None:
    found = re.fullmatch(r"(?:\[([0-9A-Fa-f:.]+)\]|([A-Za-z0-9._-]+)):([0-9]+)", given)
    if found is None:
        raise Usage(f'bad value of --supervisor: "{given}" is not HOST:PORT')
    values.supervisor_host = found[1] or found[2]
    values.supervisor_port = _number("--supervisor", found[3], 1)


def _take_bind(values: Options, given: str) -> None:
    try:
        values.bind = str(ipaddress.ip_address(given))
    except ValueError:
        raise Usage(f'bad value of --bind: "{given}" is not an address') from None


def _take_port(values: Options, given: str) -> None:
    values.port = _number("--port", given, 0)


def _take_token(values: Options, given: str) -> None:
    values.token = _token("--token", given)


def _take_viewers_token(values: Options, given: str) -> None:
    values.viewers_token = _token("--viewers-token", given)


def _take_record(values: Options, given: str) -> None:
    values.record = Path(given)
    if not values.record.is_dir():
        raise Usage(f'bad value of --record: "{given}" is not a folder')


def _take_record_limit(values: Options, given: str) -> None:
    if re.fullmatch("[1-9][0-9]{0,8}", given) is None:
        raise Usage(f'bad value of --record-limit: "{given}" is not a number of MB')
    values.record_limit = int(given) * 10**6


def _take_origin(values: Options, given: str) -> None:
    if len(values.origins) == MAX_ORIGINS:
        raise Usage(f"--origin: no more than {MAX_ORIGINS} times")
    origin = given.rstrip("/").lower()
    if (
        re.fullmatch(r"https?://(\[[0-9a-f:.]+\]|[a-z0-9._-]+)(:[0-9]+)?", origin)
        is None
    ):
        raise Usage(f'bad value of --origin: "{given}" is not http(s)://HOST[:PORT]')
    values.origins += (origin,)


_TAKERS = {
    "--supervisor": _take_supervisor,
    "--bind": _take_bind,
    "--port": _take_port,
    "--token": _take_token,
    "--viewers-token": _take_viewers_token,
    "--record": _take_record,
    "--record-limit": _take_record_limit,
    "--origin": _take_origin,
}


def _number(name: str, given: str, first: int) -> int:
    if re.fullmatch("[0-9]{1,5}", given) is None or not first <= int(given) <= 65535:
        raise Usage(f'bad value of {name}: "{given}" is not a port')
    return int(given)


def _token(name: str, path: str) -> str:
    """Same rules as in the supervisor: one file serves both."""
    try:
        with open(path, "rb") as file:
            mode = Path(path).stat()
            line = file.readline(200).rstrip(b"\n")
    except OSError as error:
        raise Usage(f"cannot use the token file {path}: {error.strerror}") from None
    shown_to_group = mode.st_mode & stat.S_IRGRP and mode.st_uid != 0
    if mode.st_mode & (stat.S_IWGRP | stat.S_IROTH | stat.S_IWOTH) or shown_to_group:
        raise Usage(
            f"cannot use the token file {path}: others may read or write it;"
            f" chmod go= {path}"
        )
    if re.fullmatch(b"[!-~]{%d,128}" % MIN_TOKEN, line) is None:
        raise Usage(
            f"cannot use the token file {path}: its first line is not"
            f" {MIN_TOKEN} to 128 printable characters without a blank"
        )
    return line.decode("ascii")
