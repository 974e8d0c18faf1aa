#  SPDX-License-Identifier: GPL-3.0-or-later
"""Sessions of browsers, by the token that they have sent."""

import hmac
import ipaddress
import secrets
from collections import OrderedDict

LIFE = 12 * 3600.0
#  Duration of a session in seconds

MAX_SESSIONS = 1000
#  Above, the oldest is removed

MAX_ADDRESSES = 1000

ATTEMPTS = 10
RECOVERY = 6.0
#  Number of wrong tokens at once per address, then one in so many seconds


class Logins:
    def __init__(self, token: str | None, viewers_token: str | None) -> None:
        self._tokens = [
            (role, given.encode("ascii"))
            for role, given in (("teacher", token), ("viewer", viewers_token))
            if given is not None
        ]
        self._sessions: OrderedDict[str, tuple[str, float]] = OrderedDict()
        self._wrong: OrderedDict[str, tuple[float, float]] = OrderedDict()
        #  Per address: count and time

    def are_needed(self) -> bool:
        return bool(self._tokens)

    def may_try(self, address: str, now: float) -> bool:
        return self._count(_source(address), now) <= ATTEMPTS - 1

    def log_in(self, token: str, address: str, now: float) -> str | None:
        """The name of a new session, if the token is right."""
        given = token.encode("utf-8", "replace")
        role = None
        for one_role, right in self._tokens:
            if hmac.compare_digest(given, right) and role is None:
                role = one_role
        if role is None:
            source = _source(address)
            self._wrong[source] = (self._count(source, now) + 1, now)
            self._wrong.move_to_end(source)
            if len(self._wrong) > MAX_ADDRESSES:
                self._wrong.popitem(last=False)
            return None
        session = secrets.token_urlsafe(32)
        self._sessions[session] = (role, now + LIFE)
        if len(self._sessions) > MAX_SESSIONS:
            self._sessions.popitem(last=False)
        return session

    def role(self, session: str | None, now: float) -> str | None:
        """The role of that session; None: of a browser without a session."""
        if not self._tokens:
            return "open"
        role, until = self._sessions.get(session or "", (None, 0.0))
        return role if now < until else None

    def _count(self, source: str, now: float) -> float:
        count, at = self._wrong.get(source, (0.0, now))
        return max(0.0, count - (now - at) / RECOVERY)


def _source(address: str) -> str:
    """The owner of an IPv6 network has all its addresses."""
    try:
        parsed = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if parsed.version == 6:
        return str(ipaddress.ip_network((parsed, 64), strict=False))
    return str(parsed)
