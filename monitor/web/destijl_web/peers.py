#  SPDX-License-Identifier: GPL-3.0-or-later
"""Who may be told the token: not a program of another user of this machine, which
may listen on the supervisor's port while the supervisor does not. Linux only."""

import asyncio
import ipaddress
import os
import re
import socket
from pathlib import Path

ACCEPT_LIMIT = 5.0
_PAUSE = 0.02
#  Seconds; the last one: between two looks

_SERVICES = range(61184, 65520)
#  Users that systemd makes for a service while it runs (DynamicUser=)


async def objection(made: socket.socket) -> str:
    """To telling it who is at the other end; empty: none. Raises OSError if the
    connection ends meanwhile."""
    if not _is_here(made):
        return ""
    for _ in range(round(ACCEPT_LIMIT / _PAUSE)):
        users = _users(made)
        for user in users:
            if user not in (0, os.geteuid()) and user not in _SERVICES:
                return f"a program of user {user} listens there"
        if users:
            return ""
        await asyncio.sleep(_PAUSE)
    return "it does not accept a connection"


def _is_here(made: socket.socket) -> bool:
    ours, its = (
        end[0].removeprefix("::ffff:")
        for end in (made.getsockname(), made.getpeername())
    )
    return ours == its or ipaddress.ip_address(its).is_loopback


def _users(made: socket.socket) -> set[int]:
    """Of its program, and of others whose connections have the same two ports.
    Empty: one of them has not been accepted, and is nobody's yet."""
    #  06: closed
    entry = re.compile(
        rf"^ *\d+: \w+:{made.getpeername()[1]:04X} \w+:{made.getsockname()[1]:04X}"
        r" (?!06)(?:\S+ +){4}(\d+) +\d+ (\d+)",
        re.MULTILINE,
    )
    found: list[tuple[str, str]] = []
    for table in Path("/proc/self/net").glob("tcp*"):
        found += entry.findall(table.read_text())
    if any(inode == "0" for _, inode in found):
        return set()
    return {int(user) for user, _ in found}
