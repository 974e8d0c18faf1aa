#  SPDX-License-Identifier: GPL-3.0-or-later
"""Sessions of browsers, by the token that they have sent; how much each may."""

import hmac
import ipaddress
import secrets
from collections import OrderedDict
from typing import Any

LIFE = 12 * 3600.0
#  Duration of a session in seconds

MAX_SESSIONS = 1000
#  Of each role. Above, the oldest without a WebSocket is removed

MAX_ADDRESSES = 1000

ATTEMPTS = 10
RECOVERY = 6.0
#  Number of wrong tokens at once per address that the log names, then one in so
#  many seconds

EXPULSION = 600.0
#  Seconds for which an expelled address gets no session of a viewer


class Budget:
    """AT_ONCE, and then RATE a second."""

    def __init__(self, at_once: float, rate: float) -> None:
        self._most = self._left = at_once
        self._rate = rate
        self._counted_at = 0.0

    def take(self, now: float, amount: float = 1.0) -> bool:
        since = max(0.0, now - self._counted_at)
        self._left = min(self._most, self._left + since * self._rate)
        self._counted_at = now
        if self._left < amount:
            return False
        self._left -= amount
        return True


class Session:
    """A browser that has logged in; with the role "open", one WebSocket."""

    def __init__(
        self, role: str, source: str = "", until: float = float("inf")
    ) -> None:
        self.role = role
        self.source = source
        self.until = until
        self.sockets = 0
        self.muted = False
        #  Of all its WebSockets together
        self.frames = Budget(200.0, 100.0)
        self.bytes = Budget(65536.0, 8192.0)
        self.wishes = Budget(10.0, 1.0)
        #  What all others are told of
        self.orders_told = Budget(40.0, 20.0)
        self.stops = Budget(5.0, 0.1)
        #  While somebody else drives; those within a second count once
        self.stop_counted_at = self.stop_told_at = float("-inf")
        self.stops_untold = 0
        self.told: dict[str, dict[str, Any]] = {}
        #  The last event of each code that it caused


class Refused(Exception):
    """Its text is what the form is told: 1, wait or expelled."""


class Logins:
    def __init__(self, token: str | None, viewers_token: str | None) -> None:
        self._tokens = [
            (role, given.encode("ascii"))
            for role, given in (("teacher", token), ("viewer", viewers_token))
            if given is not None
        ]
        self.viewers_token = viewers_token
        self._sessions: OrderedDict[str, Session] = OrderedDict()
        self._wrong: OrderedDict[str, Budget] = OrderedDict()
        self._expelled: OrderedDict[str, float] = OrderedDict()
        #  Per source; the second: until when

    def log_in(self, token: str, address: str, now: float) -> str:
        """The name of a new session. Raises Refused. The right token is never
        refused because of wrong ones."""
        given = token.encode("utf-8", "replace")
        role = None
        for one_role, right in self._tokens:
            if hmac.compare_digest(given, right) and role is None:
                role = one_role
        source = _source(address)
        if role is None:
            wrong = self._wrong.setdefault(source, Budget(ATTEMPTS, 1 / RECOVERY))
            self._wrong.move_to_end(source)
            _bound(self._wrong)
            raise Refused("1" if wrong.take(now) else "wait")
        if role == "viewer" and now < self._expelled.get(source, 0.0):
            raise Refused("expelled")
        name = secrets.token_urlsafe(32)
        self._sessions[name] = Session(role, source, now + LIFE)
        same = [(n, s) for n, s in self._sessions.items() if s.role == role]
        if len(same) > MAX_SESSIONS:
            del self._sessions[next(n for n, s in same if s.sockets == 0)]
        return name

    def session(self, name: str | None, now: float) -> Session | None:
        """None: of a browser that has not logged in."""
        if not self._tokens:
            return Session("open")
        found = self._sessions.get(name or "")
        return found if found and now < found.until else None

    def log_out(self, name: str | None) -> None:
        found = self._sessions.pop(name or "", None)
        if found is not None:
            found.until = 0.0

    def expel(self, session: Session, now: float) -> None:
        """With all other viewers of its address, which gets no new session for a
        while; this machine's own address, which is that of tunnels, does."""
        expelled = [session]
        if not ipaddress.ip_network(session.source).is_loopback:
            self._expelled[session.source] = now + EXPULSION
            self._expelled.move_to_end(session.source)
            _bound(self._expelled)
            expelled += self._sessions.values()
        for one in expelled:
            if one.role == "viewer" and one.source == session.source:
                one.until = 0.0


def parsed(address: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return None
    return getattr(found, "ipv4_mapped", None) or found


def _source(address: str) -> str:
    """The owner of an IPv6 network has all its addresses."""
    found = parsed(address)
    if found is None:
        return "0.0.0.0/32"
    length = 64 if found.version == 6 and not found.is_loopback else None
    return str(ipaddress.ip_network((found, length or found.max_prefixlen), False))


def _bound(sources: OrderedDict[str, Any]) -> None:
    if len(sources) > MAX_ADDRESSES:
        sources.popitem(last=False)
