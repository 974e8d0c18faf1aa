#  SPDX-License-Identifier: GPL-3.0-or-later
"""A monitor: one connection, every message kept with its time of arrival, and the ways
in which it can be lost."""

import re
import select
import socket
import struct
import threading
import time
from collections import Counter

from ledger import Message
from links import inside
from parties import LIMIT

SHOWN_DATA = 200
#  Characters of an image's text that are kept with its message
JPEG_TEXT = re.compile(r"/9j[A-Za-z0-9+/]{12,}={0,2}")


class Monitor:
    def __init__(self) -> None:
        self.messages: list[Message] = []
        self.counts: Counter[str] = Counter()
        #  by label
        self.last_image = ""
        #  base64
        self.broken_images = 0
        self.end = ""
        #  "orderly" or "broken" where the supervisor has closed the connection
        self._socket: socket.socket | None = None
        self._leaving = self._paused = False

    def connect(
        self,
        port: int,
        address: str = "127.0.0.1",
        receive_buffer: int = 0,
        namespace: str = "",
    ) -> None:
        """receive_buffer 0: the system's."""
        with inside(namespace):
            self._socket = socket.socket()
        if receive_buffer:
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        self._socket.settimeout(LIMIT)
        try:
            self._socket.connect((address, port))
        except OSError as problem:
            self._socket.close()
            self._socket = None
            raise AssertionError(f"no connection to port {port}: {problem}") from None
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        arguments = (self._socket,)
        self._reader = threading.Thread(target=self._read, args=arguments, daemon=True)
        self._reader.start()

    def _read(self, connection: socket.socket) -> None:
        poll = select.poll()
        poll.register(connection, select.POLLIN)
        rest = b""
        try:
            while not self._leaving:
                if self._paused:
                    time.sleep(0.005)
                elif poll.poll(20) and not self._paused:
                    data = connection.recv(65_536)
                    now = time.monotonic()
                    if not data:
                        self.end = "orderly"
                        return
                    *lines, rest = (rest + data).split(b"\n")
                    for line in lines:
                        self._take(line.decode("latin-1"), now)
        except OSError:
            self.end = "broken"

    def _take(self, line: str, now: float) -> None:
        label, data = line[:4], line[5:]
        if label == "CIMG":
            if len(data) % 4 or not JPEG_TEXT.fullmatch(data):
                self.broken_images += 1
            self.last_image, data = data, data[:SHOWN_DATA]
        self.messages.append(Message(label, data, now))
        self.counts[label] += 1

    def send(self, data: bytes) -> bool:
        """False where the supervisor has closed the connection."""
        assert self._socket is not None
        try:
            self._socket.sendall(data)
        except OSError:
            return False
        return True

    def pause(self, paused: bool) -> None:
        """Nothing is read from the socket."""
        self._paused = paused
        time.sleep(0.05)
        #  a recv that had begun is over

    def closed(self, within: float = 0.0) -> bool:
        """By the supervisor."""
        self._reader.join(within)
        return self.end != ""

    def close(self, abortive: bool = False) -> None:
        """Or resets it."""
        if self._socket is None:
            return
        if abortive:
            self._leave()
            linger = struct.pack("ii", 1, 0)
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, linger)
        else:
            #  the supervisor sees the close first, the reader's end afterwards
            try:
                self._socket.shutdown(socket.SHUT_WR)
            except OSError:
                self.end = self.end or "broken"
            self._leave()
        self._socket.close()
        self._socket = None

    def _leave(self) -> None:
        self._leaving = True
        self._reader.join()
