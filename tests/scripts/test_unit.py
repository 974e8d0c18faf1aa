#  SPDX-License-Identifier: GPL-3.0-or-later
"""The systemd units: what systemd says of them, and what the supervisor's lets it
open, also what comes later."""

import re
import shutil
from pathlib import Path

import pytest
from parties import PROGRAMS, ROOT, ran

UNIT = ROOT / "script/systemd/destijl.service"


@pytest.mark.skipif(shutil.which("systemd-analyze") is None, reason="no systemd")
@pytest.mark.parametrize("name", [UNIT.name, "destijl-web.service"])
def test_it_is_sound(name: str, tmp_path: Path) -> None:
    """Read without a word, and its restrictions are rated as good: 2.0 or less."""
    unit = UNIT.with_name(name)
    rated = ("security", "--no-pager", "--offline=true", "--threshold=20", unit)
    status, said = ran("systemd-analyze", *rated)
    assert status == 0, said
    #  the programs have to be there; their own path may have a blank
    programs = tmp_path / "bin"
    programs.symlink_to(PROGRAMS)
    copy = tmp_path / name
    copy.write_text(unit.read_text().replace("/usr/local/bin", str(programs)))
    options = ("--man=no", "--recursive-errors=no")
    status, said = ran("systemd-analyze", "verify", *options, copy)
    #  it also tells of this system's other units
    assert status == 0 and name not in said, said


def values(key: str) -> set[str]:
    return set(" ".join(re.findall(f"(?m)^{key}=(.*)", UNIT.read_text())).split())


def test_drivers_are_loaded_before_their_devices_come() -> None:
    drivers = {"usbserial", "cdc_acm", "videodev"}
    for key in ("Wants", "After"):
        assert {f"modprobe@{one}.service" for one in drivers} <= values(key)


def test_serial_lines_of_the_board_and_no_console() -> None:
    allowed = values("DeviceAllow")
    assert {f"/dev/char/4:{64 + n}" for n in range(4)} <= allowed
    kinds = {"char-ttyAMA", "char-ttyUSB", "char-ttyACM", "char-video4linux"}
    assert kinds == {one for one in allowed if one.startswith("char-")}
