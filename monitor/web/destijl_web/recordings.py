#  SPDX-License-Identifier: GPL-3.0-or-later
"""Stored recordings: listed, served, named, deleted."""

import contextlib
import json
import os
import re
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from . import ground

_NAME = re.compile(r"(?:([0-9]{6})-)?([0-9]{8}T[0-9]{6}\.[0-9]{3}Z)")
#  Number and beginning

_TAIL = 65536
#  Bytes at the end in which the last complete line is searched

_TITLE = "title.txt"
_FILES = ("events.jsonl", "images.mjpeg", _TITLE)
MAX_TITLE = 60
#  Characters

_PIECE = 2**20
_IMAGE = b'"type":"image"'

CSV_HEAD = "time_ms,id,angle_deg,x_px,y_px,dx_px,dy_px,x_cm,y_cm,heading_deg\n"
_CSV_FIELDS = ("t", "id", "angle", "x", "y", "dx", "dy")
_CSV_LINES = 500
#  Bytes per read


def place(name: str) -> tuple[int, str]:
    """Where it is in the order of the recordings: by their numbers, for a machine
    without a clock begins in 1970, later than in 2026. 0: a name without one."""
    found = _NAME.fullmatch(name)
    return (int(found[1] or 0), found[2]) if found else (0, "")


def opener(path: str, flags: int) -> int:
    """For open, to write: not behind a symbolic link, and not for others to
    read, whatever the umask."""
    return os.open(path, flags | os.O_NOFOLLOW, 0o640)


class Recordings:
    """Its functions wait for the disk: to be called in a thread."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._known: dict[str, tuple[int, dict[str, Any]]] = {}

    def all(self) -> list[dict[str, Any]]:
        found = []
        for entry in os.scandir(self._folder):
            if _NAME.fullmatch(entry.name) and entry.is_dir(follow_symlinks=False):
                try:
                    title = {"title": _title(Path(entry))}
                    found.append(self._summary(entry.name) | title)
                except OSError:
                    continue
        return sorted(found, key=lambda one: place(one["name"]), reverse=True)

    def file(self, name: str, which: str) -> Path | None:
        """The file events.jsonl or images.mjpeg."""
        folder = self._kept(name)
        path = folder / which if folder else None
        return path if path and path.is_file() and not path.is_symlink() else None

    def entitle(self, name: str, title: str) -> bool:
        """False: there is no such recording."""
        folder = self._kept(name)
        if folder is None or (folder / _TITLE).is_symlink():
            return False
        with open(folder / _TITLE, "w", encoding="utf-8", opener=opener) as file:
            file.write(title)
        return True

    def delete(self, name: str) -> bool:
        """False: there is no such recording."""
        folder = self._kept(name)
        if folder is not None:
            _delete(folder)
        return folder is not None

    def _kept(self, name: str) -> Path | None:
        folder = self._folder / name
        is_kept = _NAME.fullmatch(name) and folder.is_dir() and not folder.is_symlink()
        return folder if is_kept else None

    def _summary(self, name: str) -> dict[str, Any]:
        events = self._folder / name / "events.jsonl"
        lines = events.stat().st_size
        size = lines + (self._folder / name / "images.mjpeg").stat().st_size
        known = self._known.get(name)
        if known is None or known[0] != size:
            number, begun = place(name)
            start = datetime.strptime(begun, "%Y%m%dT%H%M%S.%fZ")
            known = (
                size,
                {
                    "name": name,
                    "number": number,
                    "start": round(start.replace(tzinfo=UTC).timestamp() * 1000),
                    "duration": _duration(events),
                    "images": _images(events),
                    "bytes": size,
                },
            )
            self._known[name] = known
        return known[1]


def make_room(writing: Path, limit: int) -> bool:
    """Deletes the oldest recordings without a title beside the one that is being
    written, until all are limit bytes at most. False: they are still more."""
    others = sorted(
        (
            path
            for path in writing.parent.iterdir()
            if _NAME.fullmatch(path.name) and not path.is_symlink() and path.is_dir()
        ),
        key=lambda path: place(path.name),
    )
    total = sum(map(_bytes, others))
    for path in others:
        if total <= limit:
            break
        if path != writing and not _title(path):
            total -= _bytes(path)
            _delete(path)
    return total <= limit


def _bytes(folder: Path) -> int:
    total = 0
    for name in _FILES:
        with contextlib.suppress(OSError):
            total += (folder / name).stat().st_size
    return total


def _title(folder: Path) -> str:
    path = folder / _TITLE
    if path.is_symlink() or not path.is_file():
        return ""
    text = path.read_bytes()[: 4 * MAX_TITLE].decode("utf-8", "replace").strip()
    return text if text.isprintable() else ""


def _delete(folder: Path) -> None:
    for name in _FILES:
        (folder / name).unlink(missing_ok=True)
    with contextlib.suppress(OSError):  # somebody's own file is in it
        folder.rmdir()


def csv_pieces(events: Path) -> Iterator[str]:
    """The positions of a recording, a few hundred lines at a time."""
    yield CSV_HEAD
    lines = []
    arena: Any = None
    with open(events, encoding="utf-8") as file:
        for line in file:
            if '"type":"position"' in line:
                fields = _read(line)
                if fields and all(
                    isinstance(fields.get(f), int | float) for f in _CSV_FIELDS
                ):
                    row = [str(fields[f]) for f in _CSV_FIELDS]
                    known = arena is not None and fields["id"] >= 0
                    pose = ground.pose(arena, fields) if known else None
                    row += [f"{v:.2f}" for v in pose] if pose else ["", "", ""]
                    lines.append(",".join(row) + "\n")
            elif '"ground":' in line:
                fields = _read(line)
                if fields and fields.get("type") == "state":
                    arena = fields.get("ground")
            if len(lines) >= _CSV_LINES:
                yield "".join(lines)
                lines.clear()
    if lines:
        yield "".join(lines)


def _read(line: str | bytes) -> dict[str, Any] | None:
    try:
        fields = json.loads(line)
    except ValueError:
        return None
    return fields if isinstance(fields, dict) else None


def _duration(events: Path) -> int:
    with open(events, "rb") as file:
        file.seek(max(0, file.seek(0, os.SEEK_END) - _TAIL))
        for line in reversed(file.read().splitlines()):
            fields = _read(line)
            if fields is not None and isinstance(fields.get("t"), int):
                return int(fields["t"])
    return 0


def _images(events: Path) -> int:
    count = 0
    kept = b""
    with open(events, "rb") as file:
        while piece := file.read(_PIECE):
            piece = kept + piece
            count += piece.count(_IMAGE)
            #  too short for a field, but long enough for its first part
            kept = piece[-(len(_IMAGE) - 1) :]
    return count
