#  SPDX-License-Identifier: GPL-3.0-or-later
"""Connects viewers and supervisor: who drives, what everybody sees."""

import asyncio
import binascii
import json
import logging
import math
import re
import time
import unicodedata
from collections import deque
from operator import itemgetter
from pathlib import Path
from typing import Any

from aiohttp import WSCloseCode

from . import ground, messages
from .exchange import STOPS, Command
from .fan_out import FanOut
from .logins import Budget, Logins, Session
from .recording import Recording
from .state import State
from .supervisor import TOO_MANY, Link, printable
from .viewer import Viewer

MAX_VIEWERS = 100
FOR_TEACHERS = 10
#  WebSockets, and those of them that viewers do not get

MAX_PER_SESSION = 4

SESSION_OVER = 4001
#  Code of a WebSocket that is closed since its session has ended

ORDERS_PER_VIEWER = 16

SILENCE = 0.5
ABSENCE = 1.0
#  Seconds without a ping of the driver: to stop the robot, to free the wheel

TICK = 0.05
LATE = 0.15

EVENTS = 100
#  Kept for newcomers: orders, and as many of all others

REPEATED = 60.0
#  Seconds within which the same event, by the same session, is kept as one

BATTERY_TIME = 600.0
BATTERY_STEP = 10.0
#  Duration of the history, and interval between equal levels, in seconds

CAMERA_SILENCE = 2.0
IMAGE_AGE = 1.0
#  Seconds; an older image is not sent to a new viewer

STOP_TOLD = 1.0
#  Seconds between two events for stops of the same session, and between two of
#  its stops that count

BEHIND = 0.005
#  Seconds by which others are informed of an order after its driver, whose own
#  answer is then already sent

MAX_IMAGE = 6 * 2**20

_POSITION = re.compile(
    rb"CPOS:(-?[0-9]{1,9})" + rb";(-?[0-9]{1,9}(?:\.[0-9]{1,9})?)" * 5
)
_PROGRESS = re.compile(rb"MPRG:([0-9]{1,2});([0-9]{1,2});([0-9]{1,7})")
_LEVELS = {b"RBLV:-1": -1, b"RBLV:0": 0, b"RBLV:1": 1, b"RBLV:2": 2}
_NOT_RUNNING = "robot no longer runs"
_CAMERA_CLOSED = "camera closed: "
_NO_MISSION = "mission not possible: "
_BY_HAND = "order by hand"

_log = logging.getLogger(__name__)


class Hub:
    def __init__(
        self,
        host: str,
        port: int,
        token: str | None,
        record: Path | None,
        record_limit: int,
        logins: Logins,
    ) -> None:
        self.state = State()
        self.viewers: dict[int, Viewer] = {}
        self.fan_out = FanOut()
        self.link = Link(host, port, token, self)
        self._record = record
        self._record_limit = record_limit
        self._logins = logins
        self._wishes = Budget(200.0, 20.0)
        self._stops = Budget(10.0, 1 / 3)
        #  Of all viewers together
        self._recording: Recording | None = None
        self._loop = asyncio.get_running_loop()
        self._last_number = 0
        self._events: deque[dict[str, Any]] = deque(maxlen=EVENTS)
        self._orders: deque[dict[str, Any]] = deque(maxlen=EVENTS)
        self._battery: deque[tuple[int, int]] = deque()
        self._image: bytes | None = None
        self._image_at = 0.0
        self._images_since = 0.0
        #  They are expected after this time
        self._camera_told = False
        self._stopped_silent = False
        self._ticked_at = 0.0
        self._was_late = False

    #  Viewers

    def next_number(self) -> int:
        self._last_number += 1
        return self._last_number

    def join(self, viewer: Viewer) -> None:
        now = self._loop.time()
        viewer.pinged_at = now
        self.viewers[viewer.number] = viewer
        self._tell_viewers()
        changes = self.state.take_changes()
        self._forget_old_battery()
        viewer.put(
            encode(
                "welcome",
                you=viewer.number,
                role=viewer.session.role,
                state=self.state.all(),
                events=sorted([*self._events, *self._orders], key=itemgetter("time")),
                battery=list(self._battery),
                recordings=self._record is not None,
                pupils=self._logins.viewers_token is not None,
            )
        )
        if self._image is not None and (
            now - self._image_at < IMAGE_AGE or self.state["arena"] == "found"
        ):
            viewer.put_image(self._image)
        viewer.wake()
        self._send_changes(changes, but=viewer)

    def leave(self, viewer: Viewer) -> None:
        if self.viewers.pop(viewer.number, None) is None:
            return
        self._take_all_from(viewer)
        self._tell_viewers()
        self._publish()

    def may_wish(self, session: Session) -> bool:
        """Something that all are told of."""
        now = self._loop.time()
        return session.role == "teacher" or (
            not session.muted and session.wishes.take(now) and self._wishes.take(now)
        )

    def take(self, viewer: Viewer, message: messages.Message) -> None:
        """A message from a page."""
        if viewer.number not in self.viewers:
            return  # its session is over
        if isinstance(message, messages.Ping):
            viewer.put_pong(encode("pong", n=message.number))
            viewer.wake()
            viewer.pinged_at = self._loop.time()
            if self._drives(viewer):
                self._stopped_silent = False
                if message.hidden:
                    self._free_wheel("wheel_released", viewer)
        elif isinstance(message, messages.Seen):
            viewer.seen()
            return
        elif isinstance(message, messages.Order):
            self._take_order(viewer, message)
        elif isinstance(message, messages.Wheel):
            if message.what in ("release", "withdraw") or self.may_wish(viewer.session):
                self._take_wheel(viewer, message)
        elif isinstance(message, messages.Pupil):
            self._take_pupil(viewer, message)
        elif self.may_wish(viewer.session):
            self._rename(viewer, message.name)
        self._publish()

    def _rename(self, viewer: Viewer, name: str) -> None:
        """By another's name, with the number: the log says who it was."""
        others = (v for v in self.viewers.values() if v.session is not viewer.session)
        if _plain(name) in (_plain(other.name) for other in others):
            name += f" #{viewer.number}"
        viewer.name = name
        self._tell_viewers()

    def whole_state(self) -> str:
        return encode("state", **self.state.all())

    def tick(self) -> None:
        """To be called every TICK seconds."""
        now = self._loop.time()
        self.link.watch()
        late = self._is_late(now)
        driver = self._driver()
        if driver is not None and not late:
            silent = now - driver.pinged_at
            if silent > ABSENCE:
                self._free_wheel("wheel_lost", driver)
            elif silent > SILENCE and not self._stopped_silent:
                self._stopped_silent = True
                self._stop()
                self._tell("stopped_silent", "warning", name=driver.name)
        for viewer in list(self.viewers.values()):
            if now >= viewer.session.until:
                self.leave(viewer)
                viewer.close(SESSION_OVER, "the session is over")
            elif viewer.is_stuck(now):
                _log.warning("viewer %d takes nothing: closed", viewer.number)
                viewer.abort()
                self.leave(viewer)
        if (
            self.state["camera"]
            and self.state["arena"] != "found"
            and self.link.waiting() == 0
            and now - max(self._image_at, self._images_since) > CAMERA_SILENCE
            and not self._camera_told
        ):
            self._camera_told = True
            self._tell("camera_silent", "warning")
        self._publish()

    def _is_late(self, now: float) -> bool:
        """The machine stalled: pings may have arrived that are not read yet.
        Not assumed twice in succession."""
        late = now - self._ticked_at > LATE and not self._was_late
        self._ticked_at = now
        self._was_late = late
        return late

    async def run_ticks(self) -> None:
        while True:
            self.tick()
            await asyncio.sleep(TICK)

    async def close(self) -> None:
        """Stops the robot, closes the connections and the recording."""
        self._stop()
        await self.link.close()
        for viewer in self.viewers.values():
            viewer.close(WSCloseCode.GOING_AWAY, "the gateway ends")
        recording = self._recording
        self._end_recording()
        if recording is not None:
            await self._loop.run_in_executor(None, recording.join)

    #  Orders

    def _take_order(self, viewer: Viewer, order: messages.Order) -> None:
        is_stop = order.label in STOPS
        drives = self._drives(viewer)
        refusal = None
        if not is_stop and not drives:
            refusal = "NOWHEEL"
        elif not self.link.is_up():
            refusal = "NOLINK"
        elif not drives and not self._may_stop(viewer.session):
            refusal = "MUTED"
        elif not is_stop and (
            viewer.orders_waiting >= ORDERS_PER_VIEWER
            or self.link.waiting() >= TOO_MANY
        ):
            refusal = "BUSY"
        if refusal is not None:
            viewer.put(encode("answer", id=order.number, answer=refusal))
            viewer.wake()
            return
        name = viewer.name
        viewer.orders_waiting += 1

        def done(answer: str, took: float) -> None:
            viewer.orders_waiting -= 1
            ms = round(took, 2)
            viewer.put(encode("answer", id=order.number, answer=answer, ms=ms))
            viewer.wake()
            args: dict[str, Any] = {"name": name, "label": order.label}
            if order.value is not None:
                args["value"] = order.value
            elif order.points:
                args["value"] = len(order.points)
            level = "info" if is_good(answer) else "warning"
            if drives and viewer.session.orders_told.take(self._loop.time()):
                self._tell("order", level, **args, answer=answer, ms=ms)

        self._send(Command(order.label, order.value, [done], points=order.points), name)
        if not drives:
            self._tell_stop(viewer)

    def _may_stop(self, session: Session) -> bool:
        """Everybody may, while nobody drives. Otherwise a viewer may a few times,
        then now and then: nobody keeps the others from driving."""
        if session.role == "teacher" or self._driver() is None:
            return True
        if session.muted:
            return False
        now = self._loop.time()
        if now - session.stop_counted_at > STOP_TOLD:
            if not session.stops.take(now) or not self._stops.take(now):
                return False
            session.stop_counted_at = now
        return True

    def _tell_stop(self, viewer: Viewer) -> None:
        session = viewer.session
        session.stops_untold += 1
        now = self._loop.time()
        if now - session.stop_told_at > STOP_TOLD:
            session.stop_told_at = now
            count, session.stops_untold = session.stops_untold, 0
            self._tell("stopped_by", "warning", session, count, name=viewer.name)

    def _send(self, command: Command, name: str) -> None:
        self.link.send(command)
        value = command.value if not command.points else len(command.points)
        self._note("order", label=command.label, value=value, name=name)

    def _stop(self) -> None:
        """By the gateway itself, if the robot may be moving."""
        if self.link.is_up() and (
            self.state["robot"] in ("open", "started") or self.link.waiting() > 0
        ):
            self._send(Command("RSTP"), "")

    #  Control (the wheel)

    def _drives(self, viewer: Viewer) -> bool:
        return bool(self.state["driver"] == viewer.number)

    def _driver(self) -> Viewer | None:
        return self.viewers.get(self.state["driver"] or 0)

    def _take_wheel(self, viewer: Viewer, wish: messages.Wheel) -> None:
        driver = self._driver()
        if wish.what in ("take", "ask") or (wish.what == "seize" and driver is None):
            if driver is None:
                self._give_wheel(viewer)
                self._tell("wheel_taken", "info", viewer.session, name=viewer.name)
            elif (
                wish.what == "ask"
                and driver is not viewer
                and viewer.number not in self.state["asking"]
            ):
                self.state.set(asking=[*self.state["asking"], viewer.number])
                self._tell("wheel_asked", "info", viewer.session, name=viewer.name)
            elif wish.what == "take" and self.state["offered"] == viewer.number:
                self._hand_over(driver, viewer)
        elif wish.what == "withdraw":
            self._forget_wish(viewer)
            if driver is viewer or self.state["offered"] == viewer.number:
                self.state.set(offered=None)
                if driver is not viewer:
                    self._tell(
                        "wheel_unwanted", "info", viewer.session, name=viewer.name
                    )
        elif wish.what == "seize":
            if (
                viewer.session.role == "teacher"
                and driver is not None
                and driver is not viewer
            ):
                self._stop()
                self._give_wheel(viewer)
                self._tell(
                    "wheel_seized",
                    "warning",
                    **{"from": driver.name, "name": viewer.name},
                )
        elif driver is viewer:
            other = self.viewers.get(wish.to or 0)
            if wish.what == "release":
                self._free_wheel("wheel_released", viewer)
            elif wish.what == "offer":
                if other is not None and other is not viewer:
                    self.state.set(offered=other.number)
                    names = {"from": viewer.name, "name": other.name}
                    self._tell("wheel_offered", "info", viewer.session, **names)
            elif other is not None and other.number in self.state["asking"]:
                if wish.what == "give":
                    self._hand_over(viewer, other)
                else:
                    self._forget_wish(other)
                    self._tell(
                        "wheel_declined", "info", viewer.session, name=other.name
                    )

    def _take_pupil(self, teacher: Viewer, wish: messages.Pupil) -> None:
        pupil = self.viewers.get(wish.to)
        if teacher.session.role != "teacher" or pupil is None:
            return
        session = pupil.session
        if session.role != "viewer":
            return
        names = {"from": teacher.name, "name": pupil.name}
        if wish.what == "expel":
            self._logins.expel(session, self._loop.time())
            self._tell("expelled", "warning", **names)
        elif session.muted != (wish.what == "mute"):
            session.muted = wish.what == "mute"
            self._tell(wish.what + "d", **names)
            for viewer in self.viewers.values():
                if session.muted and viewer.session is session:
                    if self._drives(viewer):
                        self._stop()
                        self.state.set(driver=None)
                    self._take_all_from(viewer)
            self._tell_viewers()

    def _take_all_from(self, viewer: Viewer) -> None:
        self._forget_wish(viewer)
        if self.state["offered"] == viewer.number:
            self.state.set(offered=None)
        if self.state["driver"] == viewer.number:
            self._free_wheel("wheel_lost", viewer)

    def _hand_over(self, driver: Viewer, viewer: Viewer) -> None:
        self._stop()
        self._give_wheel(viewer)
        self._tell("wheel_given", **{"from": driver.name, "name": viewer.name})

    def _give_wheel(self, viewer: Viewer) -> None:
        self._stopped_silent = False
        viewer.pinged_at = self._loop.time()
        self._forget_wish(viewer)
        self.state.set(driver=viewer.number, offered=None)

    def _free_wheel(self, code: str, viewer: Viewer) -> None:
        self._stop()
        self.state.set(driver=None, offered=None)
        level = "info" if code == "wheel_released" else "warning"
        self._tell(code, level, viewer.session, name=viewer.name)

    def _forget_wish(self, viewer: Viewer) -> None:
        self.state.set(asking=[n for n in self.state["asking"] if n != viewer.number])

    #  The supervisor

    def believes_wrongly(self) -> bool:
        """Says that it is connected, and is not."""
        return self.state["supervisor"] == "connected" and self.link.is_lost()

    def link_began(self) -> None:
        self.state.begin_session()
        self.state.set(supervisor="connected")
        self._begin_recording()
        self._tell("supervisor_connected")
        self._publish()

    def link_refused(self, reason: str) -> None:
        self.state.set(supervisor="refused")
        self._tell("supervisor_refused", "error", reason=reason)
        self._publish()

    def link_failed(self) -> None:
        self.state.set(supervisor="connecting")
        self._publish()

    def link_ended(self, reason: str) -> None:
        self.state.begin_session()
        self.state.set(supervisor="connecting")
        self._forget_image()
        self._tell("supervisor_lost", "error", reason=reason)
        self._publish()
        self._end_recording()
        self._publish()

    def settled(self, command: Command, answer: str, took: float, line: bytes) -> None:
        self.state.answered(command.label, answer)
        if command.label == "CASA" and answer == "CIMG":
            self._take_image(line)
        elif command.label == "RGBT":
            self._take_battery(line)
        elif command.label in ("CACO", "CAIN"):
            self._images_since = self._loop.time()
            if self.state["arena"] == "confirmed":
                self.link.send(Command("CARN"))
        elif command.label == "CARN" and self.state["arena"] == "confirmed":
            self.state.set(ground=ground.read(line))
        elif command.label == "COPN" and answer == "AACK":
            self._images_since = self._loop.time()
            self._camera_told = False
        elif command.label == "CCLS" and answer == "AACK":
            self._forget_image()
        elif command.points and answer == "AACK":
            unit = "cm" if command.label.endswith("CM") else "px"
            self.state.mission_began(unit, command.points)
        self._note("answer", label=command.label, answer=answer, ms=round(took, 2))
        for done in command.done:
            done(answer, took)
        self._publish()

    def unasked(self, line: bytes) -> None:
        if line.startswith(b"CIMG:"):
            self._take_image(line)
        elif line.startswith(b"CPOS:"):
            self._take_position(line)
        elif line.startswith(b"RBLV:"):
            self._take_battery(line)
        elif line.startswith(b"MPRG:"):
            self._take_progress(line)
        elif line.startswith(b"MEND:"):
            self._take_end(line)
        elif line == b"ATIM":
            self.state.robot_lost()
            self._tell("robot_lost", "error")
        else:
            self._take_text(printable(line[5:]))
        self._publish()

    def unanswered(self, command: Command) -> None:
        self._tell("unanswered", "error", label=command.label)
        self._publish()

    def _take_image(self, line: bytes) -> None:
        try:
            image = binascii.a2b_base64(line[5:], strict_mode=True)
        except binascii.Error:
            image = b""
        if not image.startswith(b"\xff\xd8") or len(image) > MAX_IMAGE:
            _log.warning("an image of the supervisor is no JPEG")
            return
        self._image = image
        self._image_at = self._loop.time()
        self._camera_told = False
        for viewer in self.viewers.values():
            viewer.put_image(image)
            self.fan_out.add(viewer)
        if self._recording is not None:
            self._recording.put("image", {}, image)

    def _forget_image(self) -> None:
        self._image = None
        for viewer in self.viewers.values():
            viewer.forget_image()

    def _take_position(self, line: bytes) -> None:
        found = _POSITION.fullmatch(line)
        if found is None:
            _log.warning("a position of the supervisor is malformed")
            return
        angle, x, y, dx, dy = (float(text) for text in found.groups()[1:])
        if not all(map(math.isfinite, (angle, x, y, dx, dy))):
            return
        fields = {
            "id": int(found[1]),
            "angle": angle,
            "x": x,
            "y": y,
            "dx": dx,
            "dy": dy,
        }
        text = encode("position", time=now_ms(), **fields)
        for viewer in self.viewers.values():
            viewer.put_position(text)
            self.fan_out.add(viewer)
        self._note("position", time=now_ms(), **fields)

    def _take_progress(self, line: bytes) -> None:
        found = _PROGRESS.fullmatch(line)
        mission = self.state["mission"]
        if found is None or mission is None:
            return
        leg, of, distance = (int(text) for text in found.groups())
        if 1 <= leg <= of == mission["of"]:
            self.state.mission_went_on(leg, distance)

    def _take_end(self, line: bytes) -> None:
        if self.state["mission"] is None:
            return
        if line == b"MEND:done":
            self._tell("mission_done")
        else:
            reason = printable(line[5:]).removeprefix("aborted;")
            level = "info" if reason == _BY_HAND else "warning"
            self._tell("mission_aborted", level, reason=reason)
        self.state.mission_ended()

    def _take_battery(self, line: bytes) -> None:
        level = _LEVELS.get(line)
        if level is None:
            return
        self.state.set(battery=level)
        now = now_ms()
        if (
            not self._battery
            or self._battery[-1][1] != level
            or now - self._battery[-1][0] >= BATTERY_STEP * 1000
        ):
            self._battery.append((now, level))
            self._forget_old_battery()

    def _forget_old_battery(self) -> None:
        oldest = now_ms() - BATTERY_TIME * 1000
        while self._battery and self._battery[0][0] < oldest:
            self._battery.popleft()

    def _take_text(self, text: str) -> None:
        if text.startswith(_NOT_RUNNING):
            self.state.robot_stopped_running()
            self._tell("robot_not_running", "error")
        elif text.startswith(_CAMERA_CLOSED):
            self.state.camera_closed(failed=True)
            self._forget_image()
            self._tell("camera_failed", "error")
        elif text.startswith(_NO_MISSION):
            reason = text.removeprefix(_NO_MISSION)
            self._tell("mission_refused", "warning", reason=reason)
        else:
            self._tell("message", "warning", text=text)

    #  To all viewers

    def _tell_viewers(self) -> None:
        self.state.set(
            viewers=[
                {"id": v.number, "name": v.name, "role": v.session.role}
                | ({"muted": True} if v.session.muted else {})
                for v in self.viewers.values()
            ]
        )

    def _tell(
        self,
        code: str,
        level: str = "info",
        by: Session | None = None,
        count: int = 1,
        /,
        **args: str | float,
    ) -> None:
        """An event, caused COUNT times by a session."""
        event: dict[str, Any] = {
            "time": now_ms(),
            "level": level,
            "code": code,
            "args": args,
        }
        if by is not None:
            #  One entry, however often: so nobody wipes the others' away
            earlier = by.told.get(code)
            if (
                earlier is not None
                and earlier in self._events
                and event["time"] - earlier["time"] < REPEATED * 1000
            ):
                self._events.remove(earlier)
                count += earlier["args"].get("count", 1)
            if count > 1:
                args["count"] = count
            by.told[code] = event
        (self._orders if code == "order" else self._events).append(event)
        self._note("event", **event)
        text = encode("event", **event)
        for viewer in self.viewers.values():
            viewer.put(text)
        self._loop.call_later(BEHIND, self._send_texts)

    def _send_texts(self) -> None:
        for viewer in self.viewers.values():
            self.fan_out.add(viewer)

    def _publish(self) -> None:
        """Changes of the state."""
        self._send_changes(self.state.take_changes())

    def _send_changes(self, changes: dict[str, Any], but: Viewer | None = None) -> None:
        if not changes:
            return
        self._note("state", **changes)
        text = encode("state", **changes)
        for viewer in self.viewers.values():
            if viewer is not but:
                viewer.put_state(text)
        self._loop.call_later(BEHIND, self._send_texts)

    #  Recording

    def _begin_recording(self) -> None:
        if self._record is None:
            return
        self._recording = Recording(
            self._record, self._record_limit, self._recording_failed
        )
        self.state.set(recording=self._recording.name)
        self._note("state", **self.state.all())

    def _recording_failed(self, recording: Recording, reason: str) -> None:
        #  called by its thread
        self._loop.call_soon_threadsafe(self._drop_recording, recording, reason)

    def _drop_recording(self, recording: Recording, reason: str) -> None:
        if recording is self._recording:
            self._recording = None
            self.state.set(recording=None)
        _log.error("recording failed: %s", reason)
        self._tell("recording_failed", "error", reason=reason)
        self._publish()

    def _end_recording(self) -> None:
        if self._recording is not None:
            self._recording.close()
            self._recording = None
            self.state.set(recording=None)

    def _note(self, kind: str, **fields: Any) -> None:
        if self._recording is not None:
            self._recording.put(kind, fields)


def encode(kind: str, **fields: Any) -> str:
    return json.dumps({"type": kind, **fields}, separators=(",", ":"))


def _plain(name: str) -> str:
    """Equal for names that look the same, letters of other alphabets aside."""
    return "".join(
        one
        for one in unicodedata.normalize("NFKC", name).casefold()
        if unicodedata.category(one) not in ("Mn", "Me", "Cf", "Zs")
        and one not in "\u115f\u1160\u17b4\u17b5\u2800\u3164"
    )


def now_ms() -> int:
    return round(time.time() * 1000)


def is_good(answer: str) -> bool:
    return answer[:4] in ("AACK", "CIMG", "RBLV", "RVER", "RCST")
