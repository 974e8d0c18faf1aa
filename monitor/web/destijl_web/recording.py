#  SPDX-License-Identifier: GPL-3.0-or-later
"""A session written to a folder, by a separate thread: a slow disk delays no
order."""

import contextlib
import itertools
import json
import os
import queue
import threading
import time
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from .recordings import make_room, opener, place

MAX_WAITING = 64 * 2**20
#  Bytes waiting for the disk; above, the recording fails

_PER_LINE = 256
#  Bytes counted for a line

FLUSH_PERIOD = 1.0
CLOSE_LIMIT = 2.0
#  Seconds

_Item = tuple[dict[str, Any], bytes | None]


class Recording:
    def __init__(
        self, folder: Path, limit: int, failed: Callable[["Recording", str], None]
    ) -> None:
        """Limit: bytes of all recordings in the folder. Failed is called in the
        thread, once at most."""
        self._begun = time.monotonic()
        self.name = _new_name(folder)
        self._folder = folder / self.name
        self._limit = limit
        self._failed = failed
        self._queue: queue.SimpleQueue[_Item | None] = queue.SimpleQueue()
        self._waiting = 0
        self._lock = threading.Lock()
        self._ended = False
        self._thread = threading.Thread(target=self._run, name="recording", daemon=True)
        self._thread.start()

    def put(
        self, kind: str, fields: dict[str, Any], image: bytes | None = None
    ) -> None:
        if self._ended:
            return
        size = _PER_LINE + (len(image) if image else 0)
        with self._lock:
            self._waiting += size
            too_much = self._waiting > MAX_WAITING
        if too_much:
            self._end("the disk is too slow")
            return
        t = round((time.monotonic() - self._begun) * 1000)
        self._queue.put(({"t": t, "type": kind, **fields}, image))

    def close(self) -> None:
        """Queued data is still written, in time."""
        self._queue.put(None)

    def join(self) -> None:
        self._thread.join(CLOSE_LIMIT)

    def _end(self, reason: str) -> None:
        with self._lock:
            first = not self._ended
            self._ended = True
        self._queue.put(None)
        if first:
            self._failed(self, reason)

    def _run(self) -> None:
        try:
            self._write()
        except OSError as error:
            self._end(error.strerror or str(error))

    def _write(self) -> None:
        self._folder.mkdir(0o750)
        events = self._folder / "events.jsonl"
        offset = 0
        with (
            open(events, "x", encoding="utf-8", opener=opener) as lines,
            open(self._folder / "images.mjpeg", "xb", opener=opener) as images,
        ):
            while make_room(self._folder, self._limit):
                end = time.monotonic() + FLUSH_PERIOD
                while (left := end - time.monotonic()) > 0:
                    try:
                        item = self._queue.get(timeout=left)
                    except queue.Empty:
                        break
                    if item is None:
                        return
                    fields, image = item
                    if image is not None:
                        images.write(image)
                        fields |= {"offset": offset, "length": len(image)}
                        offset += len(image)
                    lines.write(json.dumps(fields, separators=(",", ":")) + "\n")
                    with self._lock:
                        self._waiting -= _PER_LINE + (len(image) if image else 0)
                #  images first: a line refers to stored images
                images.flush()
                lines.flush()
            self._end("the limit of its folder is reached: --record-limit")


_numbers: dict[Path, Iterator[int]] = {}
#  Of the next recordings. Only the first of a process reads its folder


def _new_name(folder: Path) -> str:
    if folder not in _numbers:
        with contextlib.suppress(OSError):  # it fails later, and says so
            last = max((place(name)[0] for name in os.listdir(folder)), default=0)
            _numbers[folder] = itertools.count(last + 1)
    number = next(_numbers.get(folder, itertools.count(1)))
    now = datetime.now(UTC)
    return f"{number:06d}-{now:%Y%m%dT%H%M%S}.{now.microsecond // 1000:03d}Z"
