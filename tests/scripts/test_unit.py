#  SPDX-License-Identifier: GPL-3.0-or-later
"""What the supervisor's unit lets it open, also what comes later."""

import re
from pathlib import Path

UNIT = Path(__file__).parents[2] / "script/systemd/destijl.service"


def values(key: str) -> list[str]:
    return [
        word
        for line in re.findall(f"(?m)^{key}=(.*)", UNIT.read_text())
        for word in line.split()
    ]


def test_drivers_are_loaded_before_their_devices_come() -> None:
    drivers = {"usbserial", "cdc_acm", "videodev"}
    for key in ("Wants", "After"):
        assert {f"modprobe@{one}.service" for one in drivers} <= set(values(key))


def test_serial_lines_of_the_board_and_no_console() -> None:
    allowed = set(values("DeviceAllow"))
    assert {f"/dev/char/4:{64 + n}" for n in range(4)} <= allowed
    kinds = {"char-ttyAMA", "char-ttyUSB", "char-ttyACM", "char-video4linux"}
    assert kinds == {one for one in allowed if one.startswith("char-")}
