#  SPDX-License-Identifier: GPL-3.0-or-later
"""Short-lived connections, as from a port scanner or a flood.
usage: crowds.py PORT: such a flood against 127.0.0.1, until it is killed"""

import contextlib
import os
import random
import select
import socket
import struct
import sys
import time

RESET = (socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
#  Of a socket: its close will be a reset


def begun(address: tuple[str, int], waits: bool, own: str = "") -> socket.socket:
    """A connection. waits: until it is established or refused, which is seen when it is
    used."""
    one = socket.socket()
    if own:
        one.bind((own, 0))
    one.settimeout(3.0 if waits else 0.0)
    with contextlib.suppress(OSError):
        one.connect(address)
    return one


def knock(address: tuple[str, int], count: int, source: random.Random) -> None:
    """Connects and disconnects at once: in order, by a reset, before the answer, after
    a few bytes, or with one direction closed."""
    for _ in range(count):
        way = source.randint(1, 5)
        #  the other side may be faster
        with begun(address, waits=way != 3) as one, contextlib.suppress(OSError):
            if way == 2:
                one.setsockopt(*RESET)
            elif way == 4:
                one.sendall(b"\x16\x03\x01\x00\x0a\x47")
            elif way == 5:
                one.shutdown(socket.SHUT_WR)


def half_open(address: tuple[str, int], count: int, source: random.Random) -> None:
    """The first packet of a handshake, and never the third: the kernel here, which
    knows no such connection, answers the second by a reset. Raises PermissionError."""
    with socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_TCP) as raw:
        host = socket.inet_aton(address[0])
        for _ in range(count):

            def packet(checksum: int, own: int, number: int) -> bytes:
                #  five words of header, SYN, a window
                fields = (own, address[1], number << 16, 0, 0x5002, 1024, checksum, 0)
                return struct.pack("!HHIIHHHH", *fields)

            ends = source.randint(20_000, 32_000), source.randint(0, 0xFFFF)
            #  of the segment and its pseudo-header (RFC 9293, 3.1): both addresses are
            #  this machine's
            summed = host + host + struct.pack("!HH", 6, 20) + packet(0, *ends)
            total = sum(struct.unpack(f"!{len(summed) // 2}H", summed))
            while total > 0xFFFF:
                total = (total & 0xFFFF) + (total >> 16)
            raw.sendto(packet(~total & 0xFFFF, *ends), (address[0], 0))


def crowd(address: tuple[str, int], count: int, within: float) -> tuple[int, int, int]:
    """Starts so many connections before checking any: how many received a complete
    line, were accepted and then closed, or neither."""
    patience = 1.5
    #  If its queue is full, the kernel forgets a connection that this end regards as
    #  established, until a byte arrives: so a client without reply sends one
    waiting = {
        one.fileno(): one for one in (begun(address, False) for _ in range(count))
    }
    told = set()
    ended = []
    poll = select.poll()
    for file in waiting:
        poll.register(file, select.POLLIN)
    end = time.monotonic() + within
    asked = time.monotonic()
    while waiting and time.monotonic() < end:
        for file, _ in poll.poll(5):
            data = b""
            with contextlib.suppress(OSError):
                data = waiting[file].recv(512)
            if data:
                told |= {file} if data.endswith(b"\n") else set()
            else:
                poll.unregister(file)
                ended.append(waiting.pop(file))
                #  which keeps its number
        if time.monotonic() - asked > patience:
            asked = time.monotonic()
            for one in waiting.values():
                with contextlib.suppress(OSError):
                    one.send(b"\n")
    left = len(waiting)
    for one in (*ended, *waiting.values()):
        one.setsockopt(*RESET)
        one.close()
    return len(told), len(ended), left


def flood(port: int) -> None:
    """Four senders with many connections each: all send a wrong line and reconnect at
    once."""
    made: dict[tuple[int, int], socket.socket] = {}
    while os.getppid() != 1:
        for sender in range(1, 5):
            for number in range(64):
                if old := made.get((sender, number)):
                    old.setsockopt(*RESET)
                    old.close()
                one = begun(("127.0.0.1", port), False, f"127.0.1.{sender}")
                made[sender, number] = one
                with contextlib.suppress(OSError):
                    one.send(b"GET / HTTP/1.1\r\n")
            #  for others on this machine
            time.sleep(0.001)


if __name__ == "__main__":
    flood(int(sys.argv[1]))
