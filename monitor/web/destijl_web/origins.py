#  SPDX-License-Identifier: GPL-3.0-or-later
"""Under which addresses browsers may reach the gateway. A page from elsewhere
is so kept from speaking to it, by WebSocket or by a name that resolves to this
machine."""

import ipaddress
import socket
from urllib.parse import urlsplit

from .options import is_loopback


class Origins:
    def __init__(self, bind: str, port: int, further: tuple[str, ...]) -> None:
        self.port = port
        self._further = frozenset(further)
        self._told = further[0] + "/" if further else address_to_open(bind, port)
        self._hosts = {urlsplit(origin).netloc for origin in further}
        names = ["localhost", "127.0.0.1", "[::1]"]
        if not is_loopback(bind):
            name = socket.gethostname().lower()
            names += [name, name + ".local"]
        self._hosts.update(self._with_port(name) for name in names)
        if port == 80:
            self._hosts.update(names)

    def is_host(self, host: str, local_address: str) -> bool:
        """Host, of a request to local_address, is one of our names."""
        host = host.lower()
        return (
            host in self._hosts
            or host == self._with_port(_bracketed(local_address))
            or (self.port == 80 and host == _bracketed(local_address))
        )

    def is_origin(self, origin: str, host: str) -> bool:
        """A page of that origin is ours, where is_host holds for the host."""
        origin = origin.lower()
        return origin in self._further or (
            origin == "http://" + host.lower() and not self.is_secure("", host)
        )

    def is_secure(self, origin: str, host: str) -> bool:
        """A page of that origin, or reached by that host, comes by TLS."""
        return not self._further.isdisjoint(
            one
            for one in (origin.lower(), "https://" + host.lower())
            if one.startswith("https:")
        )

    def for_others(self, host: str) -> str:
        """The URL to tell to others, by one who has come to that host."""
        if self._further or is_loopback(urlsplit("//" + host).hostname or ""):
            return self._told
        return f"http://{host}/"

    def is_proxied(self) -> bool:
        return bool(self._further)

    def _with_port(self, name: str) -> str:
        return f"{name}:{self.port}"


def address_to_open(bind: str, port: int) -> str:
    """The URL for the user."""
    address = ipaddress.ip_address(bind)
    if address.is_unspecified:
        bind = _own_address(address.version)
    return f"http://{_bracketed(bind)}:{port}/"


def _own_address(version: int) -> str:
    """Of the interface with the default route; nothing is sent."""
    family, far, near = (
        (socket.AF_INET, "192.0.2.1", "127.0.0.1")
        if version == 4
        else (socket.AF_INET6, "2001:db8::1", "::1")
    )
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as probe:
            probe.connect((far, 9))
            return str(probe.getsockname()[0])
    except OSError:
        return near


def _bracketed(address: str) -> str:
    return f"[{address}]" if ":" in address else address
